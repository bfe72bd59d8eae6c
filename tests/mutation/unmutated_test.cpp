// No false alarms: the reference itself and every profile, as drivers under test, on every scene of the default check.
#include <gtest/gtest.h>

#include "harness/compare/baseline.hpp"
#include "harness/compare/compare.hpp"
#include "catalogue_scenes.hpp"
#include "rasterizer/mistakes/played_device.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff {
namespace {

using harness::Verdict;
using rasterizer::Rules;

Limits generousLimits() {
  Limits limits = rasterizer::playedDevice(rasterizer::DeliberateError::None);
  limits.viewportSubPixelBits = 0;
  return limits;
}

TEST(Unmutated, ReferenceIsSameOnEverySceneOfTheCatalogue) {
  ASSERT_GT(catalogueScenes().size(), 100U);
  const Rules reference = *Rules::profile("reference", generousLimits());
  for (const Rules& rules : {reference, Rules::specification(generousLimits())}) {
    for (const CatalogueScene& entry : catalogueScenes()) {
      const auto result = harness::compare(entry.scene, rules, *rasterizer::render(entry.scene, rules),
                                           *rasterizer::render(entry.scene, reference));
      ASSERT_TRUE(result) << entry.scene.name;
      EXPECT_EQ(result->verdict, Verdict::Same) << entry.scene.name << " under " << rules.name << ": " << result->reason;
    }
  }
}

// What holds under a profile has to be legal: the profile's frames are never Differs under the specification.
TEST(Unmutated, EveryProfileStaysWithinTheSpecification) {
  for (const std::string_view name : rasterizer::profiles()) {
    for (const uint32_t bits : {4U, 8U}) {
      Limits limits = generousLimits();
      limits.subPixelPrecisionBits = bits;
      Rules profile = *Rules::profile(name, limits);
      // No driver has so coarse a grid; on it the fan of a cut polygon folds in scenes that no baseline of a driver knows.
      if (bits == 4) profile.choices.cutFill = rasterizer::CutFill::Polygon;
      const Rules specification = Rules::specification(limits);
      for (const CatalogueScene& entry : catalogueScenes()) {
        const Scene& scene = entry.scene;
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
