// Depth and interpolated values of random triangles on the drivers: every float in its interval, every flat one to the bit.
// A missing driver is a failure.
#include <gtest/gtest.h>

#include "harness/compare/compare.hpp"
#include "scene/generators/random_triangles.hpp"
#include "vkref/device.hpp"

namespace rasterdiff {
namespace {

using harness::SceneResult;
using rasterizer::Rules;

struct Family {
  Grid grid;
  uint32_t samples;
  bool perspective;
};

std::vector<Family> families() {
  std::vector<Family> all;
  for (const Grid grid : {Grid::Half, Grid::Sixteenth, Grid::TwoHundredFiftySixth, Grid::Free}) {
    for (const uint32_t samples : {1U, 4U}) {
      for (const bool perspective : {false, true}) all.push_back({grid, samples, perspective});
    }
  }
  return all;
}

std::string nameOf(const Family& family) {
  const char* const grids[] = {"Half", "Sixteenth", "Fine", "Free"};
  return grids[static_cast<size_t>(family.grid)] + std::to_string(family.samples) + (family.perspective ? "Persp" : "");
}

bool isInside(const ClipPosition& p) {
  return p.w > 0 && p.x >= -p.w && p.x <= p.w && p.y >= -p.w && p.y <= p.w && p.z >= 0 && p.z <= p.w;
}

// Only the triangles that nothing has to be cut from: clipping has tests of its own, and known differences.
void dropClipped(Scene& scene) {
  for (Draw& draw : scene.draws) {
    Draw kept = draw;
    kept.positions.clear();
    for (Varying& varying : kept.varyings) varying.values.clear();
    for (size_t i = 0; i + 2 < draw.positions.size(); i += 3) {
      if (!isInside(draw.positions[i]) || !isInside(draw.positions[i + 1]) || !isInside(draw.positions[i + 2])) continue;
      for (size_t k = i; k < i + 3; ++k) {
        kept.positions.push_back(draw.positions[k]);
        for (size_t v = 0; v < draw.varyings.size(); ++v) {
          const uint32_t components = draw.varyings[v].components;
          for (uint32_t c = 0; c < components; ++c) kept.varyings[v].values.push_back(draw.varyings[v].values[k * components + c]);
        }
      }
    }
    draw = std::move(kept);
  }
}

class Values : public ::testing::TestWithParam<Family> {
 protected:
  static std::unique_ptr<vkref::Device> open(const std::string& name) {
    auto device = vkref::openDevice({name, false, 20});
    if (!device) throw std::runtime_error(device.error().what);
    return std::move(*device);
  }

  static Scene sceneOf(const Family& family, uint64_t batch) {
    RandomTriangles options;
    options.seed = 9000 + batch;
    options.triangles = 300;
    options.grid = family.grid;
    options.samples = family.samples;
    options.perspective = family.perspective;
    options.values = true;
    Scene scene = randomTriangles(options);
    dropClipped(scene);
    return scene;
  }

  struct Totals {
    uint64_t values = 0, same = 0, covered = 0;
  };

  static void check(const Scene& scene, const Rules& rules, vkref::Device& device, Totals& totals) {
    const Result<Frame> actual = vkref::render(scene, device), expected = rasterizer::render(scene, rules);
    ASSERT_TRUE(actual) << actual.error().what;
    ASSERT_TRUE(expected) << expected.error().what;
    const Result<SceneResult> result = harness::compare(scene, rules, *expected, *actual);
    ASSERT_TRUE(result) << result.error().what;
    EXPECT_EQ(result->differing, 0U) << rules.name << " on " << device.driver().name;
    totals.covered += result->coveredSamples;
    for (const harness::ValueStats& stats : result->values) {
      EXPECT_EQ(stats.differing, 0U) << stats.name << " under " << rules.name << " on " << device.driver().name;
      if (stats.name == "id") {
        EXPECT_EQ(stats.same, stats.compared) << "flat values have no freedom";
      }
      totals.values += stats.compared;
      totals.same += stats.same;
    }
  }
};

constexpr uint64_t kBatches = 8;

TEST_P(Values, OfLavapipeAreWithinItsProfileAndTheSpecification) {
  const auto device = open("lavapipe");
  Totals profile, specification;
  for (uint64_t batch = 0; batch < kBatches; ++batch) {
    const Scene scene = sceneOf(GetParam(), batch);
    check(scene, Rules::forDriver(device->driver().name, device->limits()), *device, profile);
    check(scene, Rules::specification(device->limits()), *device, specification);
  }
  EXPECT_GT(profile.values, 100000U);
  EXPECT_EQ(profile.values, specification.values);
}

// Its depth at four samples has a known difference, so there the scenes have none.
TEST_P(Values, OfSwiftShaderAreWithinTheSpecification) {
  const auto device = open("swiftshader");
  Totals totals;
  for (uint64_t batch = 0; batch < kBatches; ++batch) {
    Scene scene = sceneOf(GetParam(), batch);
    if (GetParam().samples == 4) {
      scene.target.depthFormat.reset();
      scene.state.depthTestEnable = scene.state.depthWriteEnable = false;
    }
    check(scene, Rules::specification(device->limits()), *device, totals);
  }
  EXPECT_GT(totals.values, 100000U);
}

INSTANTIATE_TEST_SUITE_P(Families, Values, ::testing::ValuesIn(families()), [](const auto& testInfo) { return nameOf(testInfo.param); });

}  // namespace
}  // namespace rasterdiff
