// Profiles as files: the answer to every choice of Rules, or null where it stays open. docs/profiles.md, profile.schema.json.
#pragma once

#include <string>
#include <string_view>

#include "rasterizer/choice_table.hpp"

namespace rasterdiff::harness {

/// What a profile says; limits come from the device it is used with.
struct Profile {
  std::string name;           ///< of the rules in reports
  std::string driver, info;   ///< what it was found on; empty if it was written by hand
  rasterizer::Choices choices{};
  uint32_t openChoices = 0;   ///< bits by rasterizer::Choice
};

/// Error: BadInput with `file:line:col`.
[[nodiscard]] Result<Profile> parseProfile(std::string_view text, const std::string& fileName);
/// Error: Io, or as parseProfile.
[[nodiscard]] Result<Profile> loadProfile(const std::string& path);

/// The text of a profile file; parseProfile reads it back.
[[nodiscard]] std::string writeProfile(const Profile& profile);

[[nodiscard]] rasterizer::Rules rulesOf(const Profile& profile, const Limits& limits);

/// Does `--rules` name a file rather than a profile?
[[nodiscard]] bool namesProfileFile(std::string_view rules);

}  // namespace rasterdiff::harness
