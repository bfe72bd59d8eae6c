// The measure of the measure: each deliberate error, as the driver under test, is caught by the default check's own
// scenes, under its profile and, unless it is legal, under the specification.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

#include "catching_scene.hpp"

namespace rasterdiff {
namespace {

using rasterizer::DeliberateError;
using rasterizer::DeliberateErrorInfo;
using rasterizer::Rules;

/// None if no scene tells the mutant from the reference.
std::string catchingScene(const DeliberateErrorInfo& mutant, const Rules& rules) {
  const std::optional<Catch> caught = firstCatch(mutant, rules);
  return caught ? caught->scene->name : std::string{};
}

// What the specification leaves open anyway: other roundings to the grid, another consistent owner of ties, and Bresenham
// lines whose fragments are one aside or one fewer.
const std::set<DeliberateError> kLegal{DeliberateError::TieOwnerBottomRight, DeliberateError::TruncatingSnap,
                                       DeliberateError::CeilingSnap, DeliberateError::FloorSnapY,
                                       DeliberateError::BresenhamFirstForLast};

// Illegal, but only a profile tells: by itself every fragment of a Bresenham line is free under the specification, and a
// line of another width is no more than fragments that are missing.
const std::set<DeliberateError> kToldByProfile{DeliberateError::BresenhamWidthTruncated};

class Mutant : public ::testing::TestWithParam<DeliberateErrorInfo> {};

TEST_P(Mutant, IsCaughtUnderTheProfile) {
  const DeliberateErrorInfo& mutant = GetParam();
  Rules rules = referenceWith(mutant.error);
  rules.error = DeliberateError::None;
  const std::string scene = catchingScene(mutant, rules);
  EXPECT_FALSE(scene.empty()) << "no scene of the catalogue catches the mutant " << mutant.name << ": " << mutant.what;
  std::cout << "[ MUTANT   ] " << mutant.name << " (" << mutant.rule << ") is caught by " << scene << "\n";
}

TEST_P(Mutant, IsJudgedByTheSpecificationAsTheLawSays) {
  const DeliberateErrorInfo& mutant = GetParam();
  const Rules specification = Rules::specification(rasterizer::playedDevice(mutant.error));
  const std::string scene = catchingScene(mutant, specification);
  if (kLegal.contains(mutant.error) || kToldByProfile.contains(mutant.error)) {
    EXPECT_TRUE(scene.empty()) << mutant.name << " is taken for legal, but " << scene << " calls it wrong";
  } else {
    EXPECT_FALSE(scene.empty()) << "no scene shows that the mutant " << mutant.name << " is illegal: " << mutant.what;
  }
}

std::vector<DeliberateErrorInfo> mutants() {
  return {rasterizer::deliberateErrors().begin(), rasterizer::deliberateErrors().end()};
}

INSTANTIATE_TEST_SUITE_P(All, Mutant, ::testing::ValuesIn(mutants()), [](const auto& testInfo) {
  std::string name;
  bool capital = true;
  for (const char c : testInfo.param.name) {
    if (c == '-') {
      capital = true;
    } else {
      name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      capital = false;
    }
  }
  return name;
});

TEST(Mutants, ThereAreMoreThanEightyOfThem) { EXPECT_GE(rasterizer::deliberateErrors().size(), 84U); }

TEST(Mutants, EveryRuleOfTheTableHasOne) {
  std::map<std::string_view, int> count;
  for (const DeliberateErrorInfo& mutant : rasterizer::deliberateErrors()) ++count[mutant.rule];
  for (const CatalogueEntry& entry : catalogue()) {
    for (const std::string& rule : entry.rules) EXPECT_GT(count[rule], 0) << rule << ", which " << entry.name << " exercises";
  }
}

}  // namespace
}  // namespace rasterdiff
