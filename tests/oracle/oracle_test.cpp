// The reference against exact rationals: 100,000 random triangles on four grids, one and four samples, with and without
// perspective, ties included.
#include <algorithm>
#include <gtest/gtest.h>

#include <random>

#include "rasterizer/render.hpp"
#include "rational_rasterizer.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff {
namespace {

constexpr uint32_t kExtent = 32;

struct Family {
  const char* name;
  double grid;  // pixels; 0 = any float
  uint32_t samples;
  bool perspective;
};

class Oracle : public ::testing::TestWithParam<Family> {};

// Triangles of up to 10 pixels, inside the view volume; on a grid w is a power of two, so that x / w is exact.
Scene randomScene(const Family& family, std::mt19937_64& random, int triangles) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<testing::Point> points;
  for (int t = 0; t < triangles; ++t) {
    const double cx = unit(random) * (kExtent - 10), cy = unit(random) * (kExtent - 10);
    for (int k = 0; k < 3; ++k) {
      testing::Point p{cx + unit(random) * 10, cy + unit(random) * 10};
      if (family.grid > 0) {
        p.x = std::round(p.x / family.grid) * family.grid;
        p.y = std::round(p.y / family.grid) * family.grid;
      }
      if (family.perspective) p.w = family.grid > 0 ? std::exp2(std::floor(unit(random) * 6) - 2) : 0.1 + 5 * unit(random);
      points.push_back(p);
    }
  }
  return testing::sceneOf(points, kExtent, family.samples);
}

TEST_P(Oracle, AgreesWithTheReferenceOnEverySample) {
  const Family& family = GetParam();
  std::mt19937_64 random(20240607);
  oracle::Counts counts;
  rasterizer::RuleCounts ruleCounts;
  constexpr int kScenes = 130, kTriangles = 50;  // 16 families × 6,500 = 104,000 triangles
  for (int i = 0; i < kScenes; ++i) {
    const Scene scene = randomScene(family, random, kTriangles);
    const oracle::Masks expected = oracle::rasterize(scene, 8, counts);
    const Result<Frame> actual = rasterizer::render(scene, testing::referenceRules(), &ruleCounts);
    ASSERT_TRUE(actual) << actual.error().what;
    ASSERT_TRUE(std::ranges::equal(actual->primitive.data, expected.winner)) << family.name << ", scene " << i;
    ASSERT_TRUE(std::ranges::equal(actual->count.data, expected.count)) << family.name << ", scene " << i;
  }
  RecordProperty("samples", std::to_string(counts.samplesTested));
  RecordProperty("ties", std::to_string(counts.ties));
  if (family.grid == 0.5) {
    EXPECT_GT(counts.ties, 5000U) << "a half-pixel grid has to make ties";
    EXPECT_GT(ruleCounts[rasterizer::Rule::TieBreak], 1000U);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Families, Oracle,
    ::testing::Values(Family{"Half1", 0.5, 1, false}, Family{"Half4", 0.5, 4, false}, Family{"Half1Persp", 0.5, 1, true},
                      Family{"Half4Persp", 0.5, 4, true}, Family{"Sixteenth1", 0.0625, 1, false},
                      Family{"Sixteenth4", 0.0625, 4, false}, Family{"Sixteenth1Persp", 0.0625, 1, true},
                      Family{"Sixteenth4Persp", 0.0625, 4, true}, Family{"Fine1", 1.0 / 256, 1, false},
                      Family{"Fine4", 1.0 / 256, 4, false}, Family{"Fine1Persp", 1.0 / 256, 1, true},
                      Family{"Fine4Persp", 1.0 / 256, 4, true}, Family{"Free1", 0, 1, false}, Family{"Free4", 0, 4, false},
                      Family{"Free1Persp", 0, 1, true}, Family{"Free4Persp", 0, 4, true}),
    [](const auto& testInfo) { return testInfo.param.name; });

}  // namespace
}  // namespace rasterdiff
