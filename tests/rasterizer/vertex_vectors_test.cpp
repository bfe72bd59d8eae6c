// Vectors of vertices are staged as VertexStage stages one: with every instruction set, under every closed choice.
#include "rasterizer/vertex_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "kernels/every_target.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint32_t kWidth = 512, kHeight = 384;

Scene sceneOf(const Viewport& viewport, uint32_t samples) {
  Scene scene;
  scene.target = {.width = kWidth, .height = kHeight, .samples = samples};
  scene.viewport = viewport;
  return scene;
}

/// Coordinates on the grid, halfway between its points, a hair off either, and anywhere; w of every kind.
std::vector<ClipPosition> hardVertices(const Viewport& viewport, size_t count) {
  Prng prng(11);
  std::vector<ClipPosition> vertices;
  const auto coordinate = [&](float origin, float extent, float w) {
    const double steps = prng.chance(50) ? 512 : 256, pixel = static_cast<double>(prng.below(512 * 512)) / steps;
    auto ndc = static_cast<float>(2 * (pixel - origin) / extent - 1);
    if (prng.chance(30)) ndc = std::nextafter(ndc, prng.chance(50) ? 9.0F : -9.0F);
    if (prng.chance(20)) ndc = static_cast<float>(prng.between(-1.2, 1.2));
    return ndc * w;
  };
  while (vertices.size() < count) {
    const float ws[] = {1, 2, 0.25F, 3, 0.7F, static_cast<float>(prng.between(1e-3, 1e3)), 0x1p-140F, 0x1.8p-130F, -1, 0};
    const float w = ws[prng.below(std::size(ws))];
    vertices.push_back({coordinate(viewport.x, viewport.width, w), coordinate(viewport.y, viewport.height, w), static_cast<float>(prng.between(-0.1, 1.1)) * w, w});
  }
  constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
  vertices[5].x = kInfinity, vertices[6].y = kNan, vertices[7].z = -kInfinity, vertices[8].w = kNan, vertices[9] = {0, 0, 0, 0};
  return vertices;
}

/// Returns how many vertices have a place.
size_t expectAlike(const Scene& scene, const Rules& rules, std::span<const ClipPosition> vertices) {
  const VertexStage stage = vertexStage(scene, rules, 0);
  const ClipVolume volume = clipVolume(scene.state, Draw{}, rules.error);
  const PlanePlaces places(rules);
  constexpr size_t kBefore = 3;
  StagedVertices staged(kBefore + vertices.size(), true);
  const uint64_t divided = stageVertices(vertices, stage, volume, kBefore, staged);
  size_t placed = 0, other = 0;
  for (size_t i = 0; i < vertices.size(); ++i) {
    const ClipPosition& p = vertices[i];
    other += p.w != 1 ? 1U : 0U;
    const uint32_t code = staged.codes[kBefore + i];
    EXPECT_EQ(code & ~kNoPlace, outcode({p, {}}, volume)) << i;
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
    EXPECT_EQ((code & kNoPlace) != 0, !finite || !(p.w > 0)) << i;
    if (code != 0) continue;
    ++placed;
    const RasterVertex expected = stage.original(p);
    EXPECT_EQ(staged.snapped[kBefore + i], expected.snapped) << i << ": " << p.x << " " << p.y << " / " << p.w;
    const DepthVertex depth = depthVertex(expected, places), &actual = staged.depths[kBefore + i];
    EXPECT_EQ(std::memcmp(&depth, &actual, sizeof(depth)), 0) << i << ": " << depth.x << " " << actual.x << ", " << depth.deviation << " " << actual.deviation;
    if (::testing::Test::HasFailure()) return placed;
  }
  EXPECT_EQ(divided, other);
  return placed;
}

class VertexVectorsUnder : public ::testing::TestWithParam<ViewportArithmetic> {};

TEST_P(VertexVectorsUnder, HaveTheBitsOfSingleVertices) {
  Rules rules = Rules::profile("reference", Limits{}).value();
  rules.choices.viewportArithmetic = GetParam();
  const Viewport viewports[] = {{0, 0, kWidth, kHeight, 0, 1}, {0.1F, 380.7F, 500.3F, -370.9F, 0.9F, 0.2F}, {-1e6F, 3, 2.5e6F, 300, 0, 1}};
  size_t placed = 0;
  for (const Viewport& viewport : viewports) {
    const std::vector<ClipPosition> vertices = hardVertices(viewport, 1003);
    for (const uint32_t samples : {1U, 4U}) {
      const Scene scene = sceneOf(viewport, samples);
      for (const SnapRounding rounding : {SnapRounding::NearestEven, SnapRounding::NearestUp, SnapRounding::Floor, SnapRounding::TowardZero, SnapRounding::NearestDown,
                                          SnapRounding::NearestAway, SnapRounding::NearestTowardZero, SnapRounding::Ceiling}) {
        for (const SnapOrigin origin : {SnapOrigin::Corner, SnapOrigin::CentreAtOneSample, SnapOrigin::Centre, SnapOrigin::CentreInViewport}) {
          for (const uint32_t bits : {8U, 4U}) {
            rules.choices.snapRounding = rounding;
            rules.choices.snapOrigin = origin;
            rules.choices.subPixelBits = bits;
            SCOPED_TRACE("rounding " + std::to_string(static_cast<int>(rounding)) + ", origin " + std::to_string(static_cast<int>(origin)) + ", bits " +
                         std::to_string(bits) + ", samples " + std::to_string(samples));
            testing::onEveryTarget([&] { placed += expectAlike(scene, rules, vertices); });
            if (HasFailure()) return;
          }
        }
      }
    }
  }
  EXPECT_GT(placed, 100'000U);
}

TEST(VertexVectors, LayPlanesWhereTheProfileLaysThem) {
  const Viewport viewport{0, 0, kWidth, kHeight, 0, 1};
  const std::vector<ClipPosition> vertices = hardVertices(viewport, 1001);
  for (const std::string_view profile : {"reference", "lavapipe"}) {
    for (const PlanePositions positions : {PlanePositions::Unsnapped, PlanePositions::Snapped}) {
      Rules rules = Rules::profile(profile, Limits{}).value();
      rules.choices.planePositions = positions;
      for (const uint32_t open : {0U, ~0U}) {
        rules.openChoices = open;
        testing::onEveryTarget([&] { EXPECT_GT(expectAlike(sceneOf(viewport, 1), rules, vertices), 200U); });
      }
    }
  }
}

TEST(VertexVectors, AreNotForOpenOrMistakenRules) {
  EXPECT_TRUE(stagesInVectors(Rules::profile("lavapipe", Limits{}).value()));
  EXPECT_FALSE(stagesInVectors(Rules::specification(Limits{})));
  Rules mistaken = Rules::profile("reference", Limits{}).value();
  mistaken.error = DeliberateError::HalfPixelShift;
  EXPECT_FALSE(stagesInVectors(mistaken));
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, VertexVectorsUnder,
                         ::testing::Values(ViewportArithmetic::Exact, ViewportArithmetic::Float32, ViewportArithmetic::Float32Fma,
                                           ViewportArithmetic::Float32Division, ViewportArithmetic::Float32DivisionFma));

}  // namespace
}  // namespace rasterdiff::rasterizer
