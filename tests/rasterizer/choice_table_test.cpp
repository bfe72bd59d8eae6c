// The table of choices, and what the rarer answers mean.
#include <gtest/gtest.h>

#include <set>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/edge_function.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/snap.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

TEST(ChoiceTable, EveryAnswerIsReadBackAndTouchesNothingElse) {
  std::set<std::string_view> names;
  for (size_t i = 0; i < choiceTable().size(); ++i) {
    const ChoiceInfo& row = choiceTable()[i];
    EXPECT_EQ(static_cast<size_t>(row.choice), i);
    EXPECT_EQ(&info(row.choice), &row);
    EXPECT_EQ(choiceByName(row.name), row.choice);
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    for (uint32_t answer = 0; answer < row.answers.size(); ++answer) {
      Choices choices;
      row.set(choices, answer);
      EXPECT_EQ(row.get(choices), answer) << row.name;
      row.set(choices, row.get(Choices{}));
      EXPECT_EQ(choices, Choices{}) << row.name;
    }
  }
  EXPECT_FALSE(choiceByName("noSuchChoice"));
}

TEST(ChoiceTable, SubPixelBitsReplaceTheAdvertisedOnesExceptUnderOpenRules) {
  Rules rules;
  EXPECT_EQ(gridBits(rules), 8);
  rules.choices.subPixelBits = 5;
  EXPECT_EQ(gridBits(rules), 5);
  rules.open = true;
  EXPECT_EQ(gridBits(rules), 8);
}

// Of the two polygons on a slanted edge one owns its samples, whatever the rule; the four rules differ.
TEST(TieRule, SlantedEdgesHaveOneOwner) {
  std::set<std::array<bool, 2>> seen;
  for (const SlantedTies slanted : {SlantedTies::LikeVertical, SlantedTies::AgainstVertical, SlantedTies::LikeHorizontal,
                                    SlantedTies::AgainstHorizontal}) {
    const TieRule rule(TieOwner::TopLeft, slanted);
    for (const int dx : {-3, 3}) {
      for (const int dy : {-2, 2}) EXPECT_NE(ownsTies(rule, dx, dy), ownsTies(rule, -dx, -dy));
    }
    seen.insert({ownsTies(rule, 3, 2), ownsTies(rule, 3, -2)});
    EXPECT_TRUE(ownsTies(rule, 1, 0));
    EXPECT_TRUE(ownsTies(rule, 0, -1));
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST(Snap, HalvesGoWhereTheRoundingSays) {
  const auto both = [](SnapRounding rounding) {
    return std::array{snap(2.5 / 256, 8, rounding), snap(-2.5 / 256, 8, rounding)};
  };
  EXPECT_EQ(both(SnapRounding::NearestDown), (std::array{2, -3}));
  EXPECT_EQ(both(SnapRounding::NearestUp), (std::array{3, -2}));
  EXPECT_EQ(both(SnapRounding::NearestAway), (std::array{3, -3}));
  EXPECT_EQ(both(SnapRounding::NearestTowardZero), (std::array{2, -2}));
  EXPECT_EQ(both(SnapRounding::Ceiling), (std::array{3, -2}));
}

// Exact and double-precision snapping agree for every rounding, on halves and on the grid, around zero.
TEST(Snap, ExactSnappingHasTheSameRoundings) {
  const ViewportAxis axis{32, 0, 0};  // pixels = 32 x / w
  for (uint32_t answer = 0; answer < info(Choice::SnapRounding).answers.size(); ++answer) {
    const auto rounding = static_cast<SnapRounding>(answer);
    for (int quarter = -40; quarter <= 40; ++quarter) {
      const float x = static_cast<float>(quarter) / 1024 / 32;
      EXPECT_EQ(snapExactly(x, 1, axis, 8, rounding), snap(quarter / 1024.0, 8, rounding)) << quarter << ' ' << answer;
    }
  }
}

TEST(SamplePattern, MayComeFromTheProfile) {
  Rules rules;
  rules.choices.sampleLocations.emplace();
  rules.choices.sampleLocations->of(4)[2] = {7, 250};
  EXPECT_EQ((*samplePattern(4, rules))[2], (SubpixelPosition{7, 250}));
  EXPECT_EQ((*samplePattern(4, rules))[1], (SubpixelPosition{128, 128}));
}

TEST(OpenChoices, OpenTheScenesThatDependOnThem) {
  Rules rules;
  rules.openChoices = bitOf(Choice::LineArithmetic) | bitOf(Choice::DepthBiasUnit);
  Scene scene = testing::sceneOf({});
  EXPECT_FALSE(rulesFor(scene, rules).open);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  EXPECT_TRUE(rulesFor(scene, rules).open);
  scene.state.topology = PrimitiveTopology::TRIANGLE_LIST;
  scene.state.depthBiasEnable = true;
  EXPECT_TRUE(rulesFor(scene, rules).open);
  rules.openChoices = bitOf(Choice::SnapRounding);
  EXPECT_TRUE(rulesFor(testing::sceneOf({}), rules).open);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
