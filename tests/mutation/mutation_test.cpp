// The measure of the measure: each deliberate error, as the driver under test, is caught by name by some scene of the
// catalogue; the reference itself never is. Under the specification the illegal ones are caught too.
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "harness/compare/baseline.hpp"
#include "harness/compare/compare.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff {
namespace rasterizer {

void PrintTo(const DeliberateErrorInfo& mutant, std::ostream* out) { *out << mutant.name; }

}  // namespace rasterizer

namespace {

// The device that the mutants play: wide lines and large points, in lavapipe's granularity.
Limits generousLimits() {
  Limits limits;
  limits.lineWidthMax = 255;
  limits.lineWidthGranularity = 1.0F / 128;
  limits.pointSizeMin = 0;
  limits.pointSizeMax = 255;
  limits.pointSizeGranularity = 0.125F;
  return limits;
}

using harness::Verdict;
using rasterizer::DeliberateError;
using rasterizer::DeliberateErrorInfo;
using rasterizer::Rules;

// Meshes are large and add nothing that smaller scenes lack.
const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> made;
    for (const CatalogueEntry& entry : catalogue()) {
      if (entry.name.starts_with("mesh/")) continue;
      Result<Scene> scene = entry.make();
      EXPECT_TRUE(scene) << entry.name;
      if (scene) made.push_back(std::move(*scene));
    }
    return made;
  }();
  return all;
}

Rules referenceWith(DeliberateError error) {
  Rules rules = *Rules::profile("reference", generousLimits());
  rules.error = error;
  return rules;
}

struct Catches {
  size_t same = 0, allowed = 0;
  std::vector<std::string> differs;
};

// How the scenes of the catalogue judge the reference with `error` in it, under `rules`.
Catches judge(const Rules& rules, DeliberateError error) {
  Catches catches;
  const Rules mutant = referenceWith(error);
  for (const Scene& scene : scenes()) {
    const Result<Frame> expected = rasterizer::render(scene, rules), actual = rasterizer::render(scene, mutant);
    if (!expected || !actual) {
      ADD_FAILURE() << scene.name << " was not rendered";
      continue;
    }
    const Result<harness::SceneResult> result = harness::compare(scene, rules, *expected, *actual);
    if (!result) {
      ADD_FAILURE() << scene.name << ": " << result.error().what;
      continue;
    }
    switch (result->verdict) {
      case Verdict::Same: ++catches.same; break;
      case Verdict::Allowed: ++catches.allowed; break;
      default: catches.differs.push_back(scene.name);
    }
  }
  return catches;
}

void print(const char* rules, const DeliberateErrorInfo& mutant, const Catches& catches) {
  std::cout << "[ MUTANT   ] " << mutant.name << " (" << mutant.rule << ") under " << rules << ": caught by "
            << catches.differs.size() << " scenes" << (catches.differs.empty() ? "" : ", first " + catches.differs.front())
            << "; allowed in " << catches.allowed << ", same in " << catches.same << "\n";
}

// What the specification leaves open anyway: another consistent owner of ties, and another rounding to the grid.
const std::set<DeliberateError> kLegal{DeliberateError::TieOwnerBottomRight, DeliberateError::TruncatingSnap};

class Mutant : public ::testing::TestWithParam<DeliberateErrorInfo> {};

TEST_P(Mutant, IsCaughtUnderTheProfile) {
  const DeliberateErrorInfo& mutant = GetParam();
  const Catches catches = judge(referenceWith(DeliberateError::None), mutant.error);
  print("the profile", mutant, catches);
  EXPECT_FALSE(catches.differs.empty()) << "no scene of the catalogue catches the mutant " << mutant.name << ": " << mutant.what;
}

TEST_P(Mutant, IsJudgedByTheSpecificationAsTheLawSays) {
  const DeliberateErrorInfo& mutant = GetParam();
  const Catches catches = judge(Rules::specification(generousLimits()), mutant.error);
  print("the specification", mutant, catches);
  if (kLegal.contains(mutant.error)) {
    EXPECT_TRUE(catches.differs.empty()) << mutant.name << " is legal, but " << catches.differs.front() << " calls it wrong";
    EXPECT_GT(catches.allowed, 0U) << mutant.name << " shows nowhere";
  } else {
    EXPECT_FALSE(catches.differs.empty()) << "no scene shows that the mutant " << mutant.name << " is illegal: " << mutant.what;
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

TEST(Unmutated, ReferenceIsSameOnEverySceneOfTheCatalogue) {
  ASSERT_GT(scenes().size(), 100U);
  for (const Rules& rules : {referenceWith(DeliberateError::None), Rules::specification(generousLimits())}) {
    const Catches catches = judge(rules, DeliberateError::None);
    EXPECT_EQ(catches.same, scenes().size()) << "first: " << (catches.differs.empty() ? "" : catches.differs.front());
  }
}

// What holds under a profile has to be legal: the profile's frames are never Differs under the specification.
TEST(Unmutated, EveryProfileStaysWithinTheSpecification) {
  for (const std::string_view name : rasterizer::profiles()) {
    for (const uint32_t bits : {4U, 8U}) {
      Limits limits = generousLimits();
      limits.subPixelPrecisionBits = bits;
      const Rules profile = *Rules::profile(name, limits), specification = Rules::specification(limits);
      for (const Scene& scene : scenes()) {
        const auto result =
            harness::compare(scene, specification, *rasterizer::render(scene, specification), *rasterizer::render(scene, profile));
        ASSERT_TRUE(result) << scene.name;
        // A profile copies its driver's bugs too: those are in the baseline.
        harness::SceneResult judged = *result;
        if (name == "lavapipe") applyBaseline(harness::builtInBaseline(), "llvmpipe", "Mesa 22.3.6", "spec", judged);
        EXPECT_FALSE(judged.verdict == Verdict::Differs && judged.baseline != harness::BaselineStatus::ExpectedDiff)
            << name << " with " << bits << " bits, " << scene.name << ": " << result->reason;
      }
    }
  }
}

}  // namespace
}  // namespace rasterdiff
