#include "scene/file/reader.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "scene/file/number.hpp"

namespace rasterdiff {
namespace {

constexpr std::string_view kNumberForms = "a decimal number or a hex float in a string, like \"0x1.8p+3\"";

/// Levenshtein's distance, letters' case aside.
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const bool same =
          std::tolower(static_cast<unsigned char>(a[i - 1])) == std::tolower(static_cast<unsigned char>(b[j - 1]));
      const size_t replaced = diagonal + (same ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string shortened(std::string_view text) {
  return text.size() <= 60 ? std::string(text) : std::string(text.substr(0, 60)) + "...";
}

}  // namespace

bool Reader::fail(size_t offset, std::string what, std::string hint, ErrorCode code) {
  if (!error_) error_ = Error{code, textPosition(text_, offset, fileName_), std::move(what), std::move(hint)};
  return false;
}

bool Reader::expected(const JsonValue& value, std::string_view what) {
  return fail(value, fmt::format("expected {}, found {}", what, describe(value.kind())));
}

std::string Reader::suggest(std::string_view name, std::span<const std::string_view> known) {
  size_t best = std::max<size_t>(2, name.size() / 3) + 1;
  std::string_view nearest;
  for (std::string_view candidate : known) {
    if (name.size() > 64) break;
    const size_t distance = editDistance(name, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
  return fmt::format("one of {}", fmt::join(known, ", "));
}

size_t Reader::offsetInText(const JsonValue& value, size_t at) const {
  const bool verbatim = text_.substr(value.offset() + 1).starts_with(value.text());
  return verbatim ? value.offset() + 1 + at : value.offset();
}

bool Reader::object(const JsonValue& value, std::string_view what, std::span<const std::string_view> known,
                    std::initializer_list<std::string_view> required) {
  if (value.kind() != JsonKind::Object) return expected(value, fmt::format("an object ({})", what));
  JsonValue key = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, key = key.next().next()) {
    if (std::find(known.begin(), known.end(), key.text()) == known.end()) {
      return fail(key, fmt::format("unknown field '{}' of {}", shortened(key.text()), what),
                  suggest(key.text(), known));
    }
  }
  for (std::string_view field : required) {
    if (!value.member(field)) return fail(value, fmt::format("{} without '{}'", what, field), "add the field");
  }
  return true;
}

bool Reader::array(const JsonValue& value, std::string_view what) {
  return value.kind() == JsonKind::Array || expected(value, fmt::format("an array ({})", what));
}

bool Reader::text(const JsonValue& value, std::string& out) {
  if (value.kind() != JsonKind::String) return expected(value, "a string");
  out = value.text();
  return true;
}

bool Reader::boolean(const JsonValue& value, bool& out) {
  if (value.kind() != JsonKind::Boolean) return expected(value, "true or false");
  out = value.boolean();
  return true;
}

bool Reader::integer(const JsonValue& value, double least, double most, double& out) {
  if (value.kind() != JsonKind::Integer) return expected(value, "an integer");
  out = value.number();
  if (out >= least && out <= most) return true;
  return fail(value, fmt::format("{} is outside {:.0f} .. {:.0f}", out, least, most));
}

bool Reader::unsigned32(const JsonValue& value, uint32_t& out) {
  double number = 0;
  if (!integer(value, 0, UINT32_MAX, number)) return false;
  out = static_cast<uint32_t>(number);
  return true;
}

bool Reader::signed32(const JsonValue& value, int32_t& out) {
  double number = 0;
  if (!integer(value, INT32_MIN, INT32_MAX, number)) return false;
  out = static_cast<int32_t>(number);
  return true;
}

bool Reader::number(const JsonValue& value, double& out) {
  if (value.kind() == JsonKind::Integer || value.kind() == JsonKind::Number) {
    out = value.number();
    return true;
  }
  if (value.kind() != JsonKind::String) return expected(value, "a number");
  const std::optional<double> hex = parseHexFloat(value.text());
  if (!hex) {
    const bool nonFinite = parseNonFinite(value.text()).has_value();
    return fail(value, fmt::format("'{}' is no {}number", shortened(value.text()), nonFinite ? "finite " : ""),
                std::string(kNumberForms));
  }
  out = *hex;
  return true;
}

bool Reader::float32(const JsonValue& value, float& out, bool nonFinite) {
  if (value.kind() == JsonKind::String) {
    if (const std::optional<float> special = parseNonFinite(value.text())) {
      out = *special;
      return nonFinite || fail(value, fmt::format("{} is not finite", value.text()),
                               "\"allowNonFinite\": true lets it through in positions and varyings");
    }
  }
  double wide = 0;
  if (!number(value, wide)) return false;
  out = static_cast<float>(wide);
  return std::isfinite(out) || fail(value, fmt::format("{} is beyond float32", wide));
}

bool Reader::numbers(const JsonValue& value, std::string_view what, uint32_t least, uint32_t most,
                     std::vector<double>& out) {
  if (!array(value, what)) return false;
  if (value.size() < least || value.size() > most) {
    return fail(value, fmt::format("{} of {} numbers", what, value.size()),
                least == most ? fmt::format("{} numbers", least) : fmt::format("{} to {} numbers", least, most));
  }
  out.resize(value.size());
  JsonValue element = value.first();
  for (double& number : out) {
    if (!this->number(element, number)) return false;
    element = element.next();
  }
  return true;
}

}  // namespace rasterdiff
