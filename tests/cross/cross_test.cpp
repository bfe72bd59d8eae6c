// Drivers against the reference: the catalogue and random triangles, sample by sample. A missing driver is a failure.
#include <gtest/gtest.h>

#include "harness/compare/baseline.hpp"
#include "harness/compare/compare.hpp"
#include "harness/invariants/run.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/generators/random_triangles.hpp"
#include "vkref/device.hpp"

namespace rasterdiff {
namespace {

using harness::SceneResult;
using harness::Verdict;
using rasterizer::Rules;

class Drivers : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    lavapipe_ = open("lavapipe");
    swiftshader_ = open("swiftshader");
  }
  static void TearDownTestSuite() {
    lavapipe_.reset();
    swiftshader_.reset();
  }
  void SetUp() override {
    ASSERT_NE(lavapipe_, nullptr);
    ASSERT_NE(swiftshader_, nullptr);
  }

  static std::unique_ptr<vkref::Device> open(const std::string& name) {
    auto device = vkref::openDevice({name, true, 20});
    EXPECT_TRUE(device) << device.error().what << '\n' << device.error().hint;
    return device ? std::move(*device) : nullptr;
  }

  // Skipped where the device does not offer what the scene needs.
  static SceneResult check(const Scene& scene, const Rules& rules, vkref::Device& device) {
    SceneResult skipped;
    skipped.id = scene.name;
    const Result<Frame> actual = vkref::render(scene, device);
    if (!actual) {
      EXPECT_EQ(actual.error().code, ErrorCode::NotOffered) << scene.name << ": " << actual.error().what;
      skipped.verdict = Verdict::Skipped;
      return skipped;
    }
    const Result<Frame> reference = rasterizer::render(scene, rules);
    EXPECT_TRUE(reference) << scene.name;
    if (!reference) return skipped;
    Result<SceneResult> result = harness::compare(scene, rules, *reference, *actual);
    EXPECT_TRUE(result) << scene.name;
    if (!result) return skipped;
    applyBaseline(harness::builtInBaseline(), device.driver().name, device.driver().info, rules.name, *result);
    return std::move(*result);
  }

  // Nothing is broken that is not known.
  static void checkInvariants(const std::string& driver) {
    const auto subject = harness::openSubject({.driver = driver});
    ASSERT_TRUE(subject) << subject.error().what;
    for (const harness::invariants::Invariant& invariant : harness::invariants::invariants()) {
      const auto outcome = harness::invariants::run(invariant, **subject, 1, harness::kInvariantCases);
      ASSERT_TRUE(outcome) << invariant.name << ": " << outcome.error().what;
      EXPECT_GT(outcome->cases, 0U) << invariant.name;
      if (!outcome->broken) continue;
      SceneResult result;
      result.id = std::string(harness::kInvariantPrefix) + std::string(invariant.name);
      result.verdict = Verdict::Differs;
      result.differing = outcome->brokenCases;
      applyBaseline(harness::builtInBaseline(), (*subject)->name(), (*subject)->info(), "spec", result);
      EXPECT_EQ(result.baseline, harness::BaselineStatus::ExpectedDiff) << invariant.name << ": " << outcome->broken->what;
    }
  }

  static void checkCatalogue(const Rules& rules, vkref::Device& device, int atLeast) {
    int compared = 0;
    for (const CatalogueEntry& entry : catalogue()) {
      if (entry.name.rfind("mesh/", 0) == 0) continue;
      Result<Scene> scene = entry.make();
      ASSERT_TRUE(scene) << entry.name;
      scene->name = entry.name;
      const SceneResult result = check(*scene, rules, device);
      if (result.verdict != Verdict::Skipped) ++compared;
      EXPECT_FALSE(isUnexpected(result)) << entry.name << " on " << device.driver().name << " under " << rules.name << ": "
                                         << toString(result.verdict) << ", " << result.reason;
    }
    EXPECT_GE(compared, atLeast);
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
  }

  static std::unique_ptr<vkref::Device> lavapipe_, swiftshader_;
};

std::unique_ptr<vkref::Device> Drivers::lavapipe_, Drivers::swiftshader_;

TEST_F(Drivers, KeepAllInvariantsButThoseKnownToBeBroken) {
  checkInvariants("lavapipe");
  checkInvariants("swiftshader");
}

TEST_F(Drivers, LavapipeIsTheSameUnderItsProfile) {
  checkCatalogue(Rules::forDriver(lavapipe_->driver().name, lavapipe_->limits()), *lavapipe_, 200);
}

TEST_F(Drivers, LavapipeIsLegal) { checkCatalogue(Rules::specification(lavapipe_->limits()), *lavapipe_, 200); }

TEST_F(Drivers, SwiftShaderIsLegal) { checkCatalogue(Rules::specification(swiftshader_->limits()), *swiftshader_, 150); }

TEST_F(Drivers, RandomTrianglesHaveNoDifferingSample) {
  rasterizer::RuleCounts counts;
  uint64_t triangles = 0;
  for (uint32_t family = 0; family < 16; ++family) {
    for (uint64_t batch = 0; batch < 10; ++batch) {
      RandomTriangles options;
      options.seed = 1000 + 16 * batch + family;
      options.grid = static_cast<Grid>(family % 4);
      options.samples = family / 4 % 2 == 0 ? 1 : 4;
      options.perspective = family >= 8;
      const Scene scene = randomTriangles(options);
      triangles += options.triangles;
      const SceneResult exact = check(scene, Rules::forDriver(lavapipe_->driver().name, lavapipe_->limits()), *lavapipe_);
      EXPECT_EQ(exact.differing + exact.allowed, 0U) << "family " << family << ", batch " << batch;
      EXPECT_EQ(check(scene, Rules::specification(lavapipe_->limits()), *lavapipe_).differing, 0U);
      EXPECT_EQ(check(scene, Rules::specification(swiftshader_->limits()), *swiftshader_).differing, 0U);
      ASSERT_TRUE(rasterizer::render(scene, Rules::specification(lavapipe_->limits()), &counts));
    }
  }
  EXPECT_EQ(triangles, 80000U);
  EXPECT_GT(counts[rasterizer::Rule::TieBreak], 100000U);
}

TEST_F(Drivers, TheProfileOfLavapipeIsLegal) {
  const Limits& limits = lavapipe_->limits();
  const Rules profile = Rules::forDriver(lavapipe_->driver().name, limits), open = Rules::specification(limits);
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name.rfind("mesh/", 0) == 0) continue;
    const Result<Scene> scene = entry.make();
    ASSERT_TRUE(scene) << entry.name;
    const Result<Frame> actual = rasterizer::render(*scene, profile), reference = rasterizer::render(*scene, open);
    ASSERT_TRUE(actual && reference) << entry.name;
    Result<SceneResult> result = harness::compare(*scene, open, *reference, *actual);
    ASSERT_TRUE(result) << entry.name;
    // The profile copies the driver's bugs too: those are in the baseline of differences from the specification.
    result->id = entry.name;
    applyBaseline(harness::builtInBaseline(), lavapipe_->driver().name, lavapipe_->driver().info, open.name, *result);
    EXPECT_FALSE(result->verdict == Verdict::Differs && result->baseline != harness::BaselineStatus::ExpectedDiff)
        << entry.name << ": " << result->reason;
  }
}

TEST_F(Drivers, CoverageOnlyCostsNoDepthAndNoVaryingOnEitherSide) {
  const Result<Scene> scene = matchCatalogue("fill/triangle-4x").front()->make();
  ASSERT_TRUE(scene);
  for (vkref::Device* device : {lavapipe_.get(), swiftshader_.get()}) {
    const Result<Frame> driver = vkref::render(*scene, *device);
    ASSERT_TRUE(driver);
    const Result<Frame> reference = rasterizer::render(*scene, Rules::forDriver(device->driver().name, device->limits()));
    ASSERT_TRUE(reference);
    const uint64_t samples = uint64_t{4} * scene->target.width * scene->target.height;
    EXPECT_EQ(device->lastCost().colorAttachments, 2U);  // primitive and count
    EXPECT_EQ(device->lastCost().depthAttachments, 0U);
    EXPECT_EQ(device->lastCost().readbackBytes, samples * 8);
    EXPECT_EQ(planeBytes(*driver), samples * 8);
    EXPECT_EQ(planeBytes(*reference), samples * (reference->coverage ? 9 : 8));
  }
}

}  // namespace
}  // namespace rasterdiff
