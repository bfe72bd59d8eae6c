// Every choice of Rules as data: its name, its answers, how to read and set it. Profiles, their files, inference and random
// rule sets all go through this table, so that a new choice is one more row. What an answer means stands in rules.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

enum class Choice : uint8_t {
  SubPixelBits,
  ViewportArithmetic,
  SnapRounding,
  SnapOrigin,
  TieOwner,
  SlantedTies,
  TieWinding,
  ClipArithmetic,
  CutFill,
  ClipDistances,
  CullPosition,
  CutOutline,
  PointArithmetic,
  PointClip,
  DrawingRegion,
  LineArithmetic,
  DiamondExit,
  DepthBiasUnit,
  DepthBiasExponent,
  DepthBiasSlope,
  Centroid,
  PlanePositions,
  ResolveArithmetic,
  Count_,
};

inline constexpr size_t kChoices = static_cast<size_t>(Choice::Count_);

struct ChoiceInfo {
  Choice choice;
  std::string_view name;      ///< the field of Choices
  std::string_view question;  ///< what it answers, for people
  std::span<const std::string_view> answers;  ///< names of the enumerators, in order; of SubPixelBits, numbers
  uint32_t (*get)(const Choices&);            ///< index into answers
  void (*set)(Choices&, uint32_t);
};

/// One row a choice, in the order of Choice.
[[nodiscard]] std::span<const ChoiceInfo> choiceTable();
[[nodiscard]] const ChoiceInfo& info(Choice choice);
[[nodiscard]] std::optional<Choice> choiceByName(std::string_view name);

[[nodiscard]] constexpr uint32_t bitOf(Choice choice) { return 1U << static_cast<unsigned>(choice); }
[[nodiscard]] inline bool isOpen(const Rules& rules, Choice choice) { return (rules.openChoices & bitOf(choice)) != 0; }

/// Is some vertex outside of the view volume, or are there clip distances?
[[nodiscard]] bool mayClip(const Scene& scene);

/// The rules by which a scene is judged: where it depends on a choice that the profile leaves open, the specification's
/// (for inputs' places within a fragment: open values); else the profile as it is.
[[nodiscard]] Rules rulesFor(const Scene& scene, const Rules& rules);

}  // namespace rasterdiff::rasterizer
