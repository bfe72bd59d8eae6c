// The legal interval of a value: it holds the exact value, and what float32 plane equations make of it in several
// orders, for thousands of triangles of all shapes; and it is no wider than it has to be where nothing is free.
#include <gtest/gtest.h>

#include "interpolation_support.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Setup {
  float x[3], y[3], z[3], q[3];  // pixels, depth, 1 / w
  float value[3], screen[3];
};

enum class Anchor { Origin, Vertex };
enum class Positions { Unsnapped, Snapped };

// A driver's vertices: float32 reciprocal, products and sums; positions as they are or on the subpixel grid.
Setup driverSetup(const Scene& scene, Positions positions, const std::array<SubpixelPosition, 3>& snapped) {
  Setup s{};
  for (size_t i = 0; i < 3; ++i) {
    const ClipPosition& p = scene.draws[0].positions[i];
    s.q[i] = 1.0F / p.w;
    s.x[i] = p.x * s.q[i] * 128.0F + 128.0F;
    s.y[i] = p.y * s.q[i] * 128.0F + 128.0F;
    s.z[i] = p.z * s.q[i];
    if (positions == Positions::Snapped) {
      s.x[i] = static_cast<float>(snapped[i].x) / 256.0F;
      s.y[i] = static_cast<float>(snapped[i].y) / 256.0F;
    }
    s.value[i] = scene.draws[0].varyings[0].values[i];
    s.screen[i] = scene.draws[0].varyings[1].values[i];
  }
  return s;
}

struct Plane32 {
  float constant, dx, dy, x0, y0;
  float at(float x, float y) const { return constant + dx * (x - x0) + dy * (y - y0); }
};

Plane32 plane(const Setup& s, const float a[3], Anchor anchor) {
  const float e1x = s.x[1] - s.x[0], e1y = s.y[1] - s.y[0], e2x = s.x[2] - s.x[0], e2y = s.y[2] - s.y[0];
  const float reciprocal = 1.0F / (e1x * e2y - e1y * e2x);
  const float d1 = a[1] - a[0], d2 = a[2] - a[0];
  Plane32 p{a[0], (d1 * e2y - d2 * e1y) * reciprocal, (d2 * e1x - d1 * e2x) * reciprocal, s.x[0], s.y[0]};
  if (anchor == Anchor::Origin) p = {a[0] - (p.dx * s.x[0] + p.dy * s.y[0]), p.dx, p.dy, 0, 0};
  return p;
}

struct Computed {
  float depth, smooth, screen;
};

Computed driverValues(const Setup& s, Anchor anchor, float x, float y) {
  float overW[3];
  for (int i = 0; i < 3; ++i) overW[i] = s.value[i] * s.q[i];
  return {plane(s, s.z, anchor).at(x, y), plane(s, overW, anchor).at(x, y) * (1.0F / plane(s, s.q, anchor).at(x, y)),
          plane(s, s.screen, anchor).at(x, y)};
}

bool contains(const Bounds& bounds, float value) {
  const bool unbounded = bounds.hi - bounds.lo == std::numeric_limits<float>::infinity();
  return unbounded || (value >= bounds.lo && value <= bounds.hi);
}

bool contains(const Bounds& bounds, const Rational& value) {
  const bool low = std::isinf(bounds.lo) || Rational(bounds.lo) <= value;
  return low && (std::isinf(bounds.hi) || Rational(bounds.hi) >= value);
}

struct Tally {
  int fragments = 0, bounded = 0;
};

// Fragments are evaluated at pixel centres, where a driver evaluates them; drivers under the specification may use
// snapped or unsnapped positions, under the profile (which says so) the unsnapped ones.
Tally checkBounds(const TriangleKind& kind, bool open, int triangles) {
  std::mt19937_64 random(23);
  const Rules rules = open ? Rules::specification(Limits{}) : testing::referenceRules();
  Tally tally;
  for (int i = 0; i < triangles; ++i) {
    const Scene scene = randomTriangleScene(random, kind);
    withPiece(scene, rules, [&](const Primitive& primitive, const SetupTriangle& piece, const PieceValues& values) {
      const std::array<SubpixelPosition, 3> snapped{primitive.polygon[0].snapped, primitive.polygon[1].snapped, primitive.polygon[2].snapped};
      for (int k = 0; k < 6; ++k) {
        auto [x, y] = pointInside(random, primitive, piece);
        x = std::floor(x) + 0.5;
        y = std::floor(y) + 0.5;
        const auto covers = [&](const EdgeFunction& e) { return e.covers(std::llround(x * 256), std::llround(y * 256)); };
        if (!std::all_of(piece.edges.begin(), piece.edges.end(), covers)) continue;
        ++tally.fragments;
        Interpolated out[3];
        values.varyings(x, y, out);
        const Bounds depth = values.depth(x, y).bounds;
        if (std::isfinite(out[0].bounds.hi - out[0].bounds.lo)) ++tally.bounded;
        const ExactValues exact = exactValues(scene, x, y);
        EXPECT_TRUE(contains(depth, exact.depth));
        EXPECT_TRUE(contains(out[0].bounds, exact.smooth));
        EXPECT_TRUE(contains(out[1].bounds, exact.screen));
        for (const Positions positions : {Positions::Unsnapped, Positions::Snapped}) {
          if (positions == Positions::Snapped && !open) continue;
          const Setup setup = driverSetup(scene, positions, snapped);
          for (const Anchor anchor : {Anchor::Origin, Anchor::Vertex}) {
            const Computed computed = driverValues(setup, anchor, static_cast<float>(x), static_cast<float>(y));
            EXPECT_TRUE(contains(depth, computed.depth)) << i << ": " << computed.depth << " in " << depth.lo << " .. " << depth.hi;
            EXPECT_TRUE(contains(out[0].bounds, computed.smooth))
                << i << ": " << computed.smooth << " in " << out[0].bounds.lo << " .. " << out[0].bounds.hi;
            EXPECT_TRUE(contains(out[1].bounds, computed.screen))
                << i << ": " << computed.screen << " in " << out[1].bounds.lo << " .. " << out[1].bounds.hi;
          }
        }
      }
    });
  }
  return tally;
}

struct Case {
  const char* name;
  TriangleKind kind;
  bool open;
  double bounded;  // least part of the fragments whose interval is finite
};

class Bounds32 : public ::testing::TestWithParam<Case> {};

TEST_P(Bounds32, HoldTheExactValueAndFloat32Evaluations) {
  const Tally tally = checkBounds(GetParam().kind, GetParam().open, 3000);
  EXPECT_GT(tally.fragments, 300);
  EXPECT_GE(tally.bounded, GetParam().bounded * tally.fragments);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Bounds32,
    ::testing::Values(Case{"Medium", {false, 60, 0, 8}, false, 0.99}, Case{"MediumOpen", {false, 60, 0, 8}, true, 0.99},
                      Case{"MediumPerspective", {true, 60, 0, 8}, false, 0.99}, Case{"MediumPerspectiveOpen", {true, 60, 0, 8}, true, 0.99},
                      Case{"SmallPerspective", {true, 3, 0, 8}, false, 0.95}, Case{"SmallPerspectiveOpen", {true, 3, 0, 8}, true, 0.5},
                      Case{"Slivers", {false, 100, 1, 8}, false, 0.99}, Case{"SliversOpen", {false, 100, 1, 8}, true, 0.5},
                      Case{"SliversPerspective", {true, 100, 1, 8}, false, 0.9}, Case{"ThinSliversPerspective", {true, 100, 0.25, 8}, false, 0.8},
                      Case{"ThinSliversPerspectiveOpen", {true, 100, 0.25, 8}, true, 0}, Case{"LargeValues", {true, 60, 0, 1e30}, true, 0.99},
                      Case{"SmallValues", {true, 60, 0, 1e-30}, true, 0.99}),
    [](const auto& testInfo) { return testInfo.param.name; });

TEST(ConstantAttributes, StayConstantHoweverThinTheTriangle) {
  std::mt19937_64 random(29);
  for (const bool open : {false, true}) {
    const Rules rules = open ? Rules::specification(Limits{}) : testing::referenceRules();
    for (int i = 0; i < 2000; ++i) {
      Scene scene = randomTriangleScene(random, {i % 2 == 1, 100, i % 3 == 0 ? 0.05 : 20.0, 8});
      scene.draws[0].varyings[0].values.assign(3, 0.7F);
      scene.draws[0].varyings[1].values.assign(3, 0.7F);
      withPiece(scene, rules, [&](const Primitive& primitive, const SetupTriangle& piece, const PieceValues& values) {
        const auto [x, y] = pointInside(random, primitive, piece);
        Interpolated out[3];
        values.varyings(x, y, out);
        EXPECT_EQ(out[1].value, 0.7F);
        EXPECT_TRUE(std::isfinite(out[1].bounds.hi - out[1].bounds.lo));
        EXPECT_TRUE(contains(out[0].bounds, 0.7F));
        if (i % 2 == 0) {
          EXPECT_FLOAT_EQ(out[0].value, 0.7F);  // all w are 1: a quotient by exactly 1
        }
      });
    }
  }
}

// A triangle that a legal placement can turn over. Depths that are equal because z and w are, are equal in every evaluation; quotients of
// different numbers may differ once they are rounded, and then nothing bounds what lies between them.
TEST(DepthBounds, OfATriangleThatMayHaveNoAreaDependOnWhereEqualDepthsComeFrom) {
  Limits limits;
  limits.subPixelPrecisionBits = 4;
  const Rules rules = Rules::specification(limits);
  Scene scene = testing::sceneOf({{1, 0}, {0, 2}, {0, 0}}, 1);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.viewport = {-10, -6, 13, 21.5F, 1, 0};
  for (const float w : {1.0F, 0.7001728F}) {
    scene.draws[0].positions = {{0.6923077F * w, -0.44186047F * w, w, w}, {0.53846157F, -0.25581396F, 1, 1}, {0.53846157F, -0.44186047F, 1, 1}};
    const Frame frame = *render(scene, rules);
    const Bounds bounds = frame.depthBounds->at(0, 0, 0);
    ASSERT_EQ(frame.primitive.at(0, 0, 0), 1U);
    ASSERT_EQ(frame.coverage->at(0, 0, 0), Coverage::Either);
    EXPECT_LE(bounds.lo, 0);
    EXPECT_GE(bounds.hi, 0x1p-25F);
    EXPECT_EQ(std::isinf(bounds.hi), w != 1);
    if (w == 1) {
      EXPECT_LE(bounds.hi, 0x1p-20F);
    }
  }
}

TEST(ValueBounds, AreNarrowForTrianglesNearTheOriginWithNothingFree) {
  Scene scene = testing::sceneOf({{0, 0, 0}, {8, 0, 1}, {0, 8, 0.5}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  withPiece(scene, testing::referenceRules(), [](const Primitive&, const SetupTriangle&, const PieceValues& values) {
    const Interpolated depth = values.depth(2.5, 2.5);
    // Some forty roundings of numbers up to 1: 40 · 2^-24.
    EXPECT_LT(depth.bounds.hi - depth.bounds.lo, 80 * 0x1p-24F);
    EXPECT_LE(depth.bounds.lo, depth.value);
    EXPECT_GE(depth.bounds.hi, depth.value);
  });
}

// [vk:shaders-interpolation-decorations] With four samples an undecorated input may be evaluated anywhere in the pixel.
TEST(ValueBounds, OfAMultisampledTargetReachOverThePixelUnderOpenRulesOnly) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8, 4);
  scene.draws[0].varyings = {{"x", Interpolation::noperspective, 1, {0, 8, 0}}, {"s", Interpolation::smooth, 1, {0, 8, 0}}};
  for (const bool open : {false, true}) {
    const Rules rules = open ? Rules::specification(Limits{}) : testing::referenceRules();
    withPiece(scene, rules, [&](const Primitive&, const SetupTriangle&, const PieceValues& values) {
      Interpolated out[2];
      values.varyings(2.5, 2.5, out);
      for (const Interpolated& value : out) {
        EXPECT_EQ(value.value, 2.5F);
        EXPECT_EQ(contains(value.bounds, 2.0F), open);
        EXPECT_EQ(contains(value.bounds, 3.0F), open);
        EXPECT_FALSE(contains(value.bounds, 1.75F));
        EXPECT_FALSE(contains(value.bounds, 3.25F));
      }
    });
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
