// Rule coverage: how many times each rule decided an outcome while a scene was rendered.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

/// The rules that decide something countable. Ids (R14 ...) are those of docs/rules.md.
enum class Rule : uint8_t {
  ViewVolume,       ///< R3: a primitive was rejected or cut by a plane of the view volume
  ProvokingVertex,  ///< R11: a flat varying took its value from the provoking vertex, which differed from another's
  Facing,           ///< R12: the sign of the area chose front or back where that mattered
  Culling,          ///< R13: a primitive was discarded for its facing
  SampleCoverage,   ///< R14: a sample was found inside
  TieBreak,         ///< R15: a sample lay exactly on an edge
  SamplePattern,    ///< R17: some, not all, samples of a pixel were covered
  Perspective,      ///< R21: a varying was interpolated with unequal w
  DepthTest,        ///< R38: a depth test failed
  Scissor,          ///< R39: a covered sample was outside the scissor
  Order,            ///< R50: a later primitive replaced an earlier one
  Count_,
};

struct RuleInfo {
  Rule rule;
  std::string_view id;      ///< "R15"
  std::string_view name;    ///< "tie-break"
  std::string_view anchor;  ///< "vk:primsrast-polygons-basic"
};

[[nodiscard]] std::span<const RuleInfo> countedRules();

struct RuleCounts {
  std::array<uint64_t, static_cast<size_t>(Rule::Count_)> decided{};
  uint64_t& operator[](Rule rule) { return decided[static_cast<size_t>(rule)]; }
  uint64_t operator[](Rule rule) const { return decided[static_cast<size_t>(rule)]; }
  RuleCounts& operator+=(const RuleCounts& other) {
    for (size_t i = 0; i < decided.size(); ++i) decided[i] += other.decided[i];
    return *this;
  }
};

}  // namespace rasterdiff::rasterizer
