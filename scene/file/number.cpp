#include "scene/file/number.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace rasterdiff {
namespace {

constexpr uint32_t kQuietNan = 0x7fc00000;

bool sameBits(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<double> parseHexFloat(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!takePrefix(text, "0x") && !takePrefix(text, "0X")) return std::nullopt;
  if (text.empty() || text.find_first_not_of("0123456789abcdefABCDEF.pP+-") != std::string_view::npos ||
      text[0] == '-') {
    return std::nullopt;
  }
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::hex);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return negative ? -value : value;
}

std::optional<float> parseNonFinite(std::string_view text) {
  if (text == "nan") return std::bit_cast<float>(kQuietNan);
  if (text == "inf") return HUGE_VALF;
  if (text == "-inf") return -HUGE_VALF;
  if (!takePrefix(text, "nan(0x") || !text.ends_with(')')) return std::nullopt;
  text.remove_suffix(1);
  uint32_t bits = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), bits, 16);
  if (text.size() != 8 || code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  const float value = std::bit_cast<float>(bits);
  if (!std::isnan(value)) return std::nullopt;
  return value;
}

std::string jsonNumber(float value) {
  if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
  if (std::isnan(value)) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    return bits == kQuietNan ? "\"nan\"" : fmt::format("\"nan(0x{:08x})\"", bits);
  }
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  const std::string decimal = fmt::format("{}", value);
  double read = 0;
  std::from_chars(decimal.data(), decimal.data() + decimal.size(), read);
  if (sameBits(static_cast<float>(read), value)) return decimal;
  return fmt::format("\"{:a}\"", value);
}

}  // namespace rasterdiff
