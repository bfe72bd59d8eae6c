#include "harness/profile/profile_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/profile/sample_tables.hpp"
#include "scene/file/read_file.hpp"
#include "scene/file/reader.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::ChoiceInfo;
using rasterizer::SampleTables;

constexpr std::string_view kFormat = "rasterdiff-profile-1";
constexpr std::array<std::string_view, 6> kFields{"format", "name", "driver", "info", "choices", "values"};

std::vector<std::string_view> choiceFields() {
  std::vector<std::string_view> names;
  for (const ChoiceInfo& row : rasterizer::choiceTable()) names.push_back(row.name);
  names.push_back("sampleLocations");
  return names;
}

class ProfileReader {
 public:
  ProfileReader(std::string_view text, const std::string& fileName) : reader_(text, fileName) {}

  Result<Profile> read(const JsonValue& root) {
    std::string format;
    const std::span<const std::string_view> fields(kFields);
    if (!reader_.object(root, "a profile", fields, {"format", "choices"})) return wrong();
    if (!reader_.text(*root.member("format"), format)) return wrong();
    if (format != kFormat) {
      reader_.fail(*root.member("format"), "'" + format + "' is no format of profiles", "this program reads " + std::string(kFormat));
      return wrong();
    }
    for (const auto& [field, out] : {std::pair{"name", &profile_.name}, {"driver", &profile_.driver}, {"info", &profile_.info}}) {
      if (const auto value = root.member(field); value && !reader_.text(*value, *out)) return wrong();
    }
    if (const auto values = root.member("values"); values && !readValues(*values)) return wrong();
    if (!readChoices(*root.member("choices"))) return wrong();
    return std::move(profile_);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong() const { return tl::unexpected<Error>(reader_.error()); }

  bool readValues(const JsonValue& value) {
    std::string text;
    if (!reader_.text(value, text)) return false;
    if (text != "open" && text != "closed") return reader_.fail(value, "'" + text + "' is neither open nor closed");
    profile_.choices.valuesOpen = text == "open";
    return true;
  }

  bool readChoices(const JsonValue& value) {
    const std::vector<std::string_view> fields = choiceFields();
    if (!reader_.object(value, "choices", fields)) return false;
    for (const ChoiceInfo& row : rasterizer::choiceTable()) {
      const auto answer = value.member(row.name);
      if (!answer || answer->kind() == JsonKind::Null) {
        profile_.openChoices |= rasterizer::bitOf(row.choice);
      } else if (!readAnswer(row, *answer)) {
        return false;
      }
    }
    const auto tables = value.member("sampleLocations");
    return !tables || tables->kind() == JsonKind::Null || readTables(*tables);
  }

  bool readAnswer(const ChoiceInfo& row, const JsonValue& value) {
    std::string name;
    if (!reader_.text(value, name)) return false;
    const auto found = std::ranges::find(row.answers, name);
    if (found == row.answers.end()) {
      return reader_.fail(value, "'" + name + "' is no " + std::string(row.name), Reader::suggest(name, row.answers));
    }
    row.set(profile_.choices, static_cast<uint32_t>(found - row.answers.begin()));
    return true;
  }

  // {"4": [[6, 2], ...]} in 1/16 pixel; the counts that are missing have the standard locations.
  bool readTables(const JsonValue& value) {
    constexpr std::array<std::string_view, 5> kCounts{"1", "2", "4", "8", "16"};
    if (!reader_.object(value, "sample locations", kCounts)) return false;
    SampleTables tables = standardTables();
    for (uint32_t i = 0; i < kCounts.size(); ++i) {
      const uint32_t samples = 1U << i;
      if (const auto table = value.member(kCounts[i]); table && !readTable(*table, tables.of(samples))) return false;
    }
    profile_.choices.sampleLocations = tables;
    return true;
  }

  bool readTable(const JsonValue& value, std::span<SampleTables::Offset> offsets) {
    if (!reader_.array(value, "a table of locations")) return false;
    if (value.size() != offsets.size()) return reader_.fail(value, "one place for each sample is wanted");
    for (uint32_t s = 0; s < offsets.size(); ++s) {
      std::vector<double> place;
      const JsonValue element = *value.element(s);
      if (!reader_.numbers(element, "a sample's x and y in 1/16 pixel", 2, 2, place)) return false;
      for (const double sixteenths : place) {
        if (!(sixteenths >= 0 && sixteenths < 16) || std::trunc(sixteenths * 16) != sixteenths * 16) {
          return reader_.fail(element, "a place is a multiple of 1/16 from 0 to 15.9375, in sixteenths of a pixel");
        }
      }
      offsets[s] = {static_cast<uint8_t>(place[0] * 16), static_cast<uint8_t>(place[1] * 16)};
    }
    return true;
  }

  Reader reader_;
  Profile profile_;
};

}  // namespace

Result<Profile> parseProfile(std::string_view text, const std::string& fileName) {
  const Result<JsonDocument> document = JsonDocument::parse(text, fileName);
  if (!document) return tl::unexpected(document.error());
  Result<Profile> profile = ProfileReader(text, fileName).read(document->root());
  if (profile && profile->name.empty()) profile->name = fileName;
  return profile;
}

Result<Profile> loadProfile(const std::string& path) {
  const Result<std::string> text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  return parseProfile(*text, path);
}

rasterizer::Rules rulesOf(const Profile& profile, const Limits& limits) {
  rasterizer::Rules rules;
  rules.name = profile.name;
  rules.limits = limits;
  rules.choices = profile.choices;
  rules.openChoices = profile.openChoices;
  return rules;
}

bool namesProfileFile(std::string_view rules) {
  return rules.ends_with(".json") || rules.find('/') != std::string_view::npos;
}

}  // namespace rasterdiff::harness
