// The nominal value of depth and varyings against exact rationals.
#include "rasterizer/interpolation.hpp"

#include <gtest/gtest.h>

#include "interpolation_support.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

// The reference rounds a double to float32 once; the double's own error is its roundings (2^-53, some ten of them)
// times the cancellation in the plane's determinant.
double tolerance(const Rational& exact, double largest, const SetupTriangle& piece) {
  const double value = std::fabs(static_cast<double>(exact));
  const double condition = 1 + 2.0 * kExtent * kExtent * 65536 / std::fabs(static_cast<double>(piece.area));
  return 0x1p-24 * value + 0x1p-49 * largest * condition * condition;
}

void expectNominalValuesAreExact(const TriangleKind& kind, int triangles) {
  std::mt19937_64 random(17);
  const Rules rules = testing::referenceRules();
  int points = 0;
  for (int i = 0; i < triangles; ++i) {
    const Scene scene = randomTriangleScene(random, kind);
    withPiece(scene, rules, [&](const Primitive& primitive, const SetupTriangle& piece, const PieceValues& values) {
      for (int k = 0; k < 4; ++k) {
        const auto [x, y] = pointInside(random, primitive, piece);
        const ExactValues exact = exactValues(scene, x, y);
        Interpolated out[3];
        values.varyings(x, y, out);
        const auto error = [](float actual, const Rational& expected) {
          return std::fabs(static_cast<double>(Rational(actual) - expected));
        };
        EXPECT_LE(error(values.depth(x, y).value, exact.depth), tolerance(exact.depth, 1, piece));
        EXPECT_LE(error(out[0].value, exact.smooth), tolerance(exact.smooth, 64 * kind.largest, piece));
        EXPECT_LE(error(out[1].value, exact.screen), tolerance(exact.screen, kind.largest, piece));
        EXPECT_EQ(out[2].value, scene.draws[0].varyings[2].values[0]);
        ++points;
      }
    });
  }
  EXPECT_GT(points, triangles);
}

TEST(Interpolation, WithoutPerspectiveIsTheExactPlaneRounded) { expectNominalValuesAreExact({false, 60, 0, 8}, 400); }
TEST(Interpolation, WithPerspectiveIsTheExactQuotientRounded) { expectNominalValuesAreExact({true, 60, 0, 8}, 400); }
TEST(Interpolation, OfSmallTrianglesIsExactToo) { expectNominalValuesAreExact({true, 2, 0, 1000}, 400); }

// One triangle with w of 1 and 4: half way on the screen is a fifth of the way in space.
TEST(Interpolation, SmoothFollowsSpaceAndNoperspectiveFollowsTheScreen) {
  Scene scene = testing::sceneOf({{0, 0, 0.25, 1}, {8, 0, 0.5, 4}, {0, 8, 0.25, 1}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.draws[0].varyings = {{"smooth", Interpolation::smooth, 1, {0, 1, 0}}, {"screen", Interpolation::noperspective, 1, {0, 1, 0}}};
  withPiece(scene, testing::referenceRules(), [](const Primitive&, const SetupTriangle&, const PieceValues& values) {
    Interpolated out[2];
    values.varyings(4, 0, out);
    EXPECT_EQ(out[0].value, 0.2F);
    EXPECT_EQ(out[1].value, 0.5F);
    EXPECT_EQ(values.depth(4, 0).value, 0.375F);
  });
}

TEST(Interpolation, FlatIsTheProvokingVertexsValueBitByBit) {
  for (const auto mode : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
    Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8);
    scene.state.provokingVertexMode = mode;
    scene.draws[0].varyings = {{"flat", Interpolation::flat, 2, {1e-40F, -0.0F, 3, 4, 5.5F, 6}}};
    withPiece(scene, testing::referenceRules(), [&](const Primitive&, const SetupTriangle&, const PieceValues& values) {
      Interpolated out[2];
      values.varyings(2, 2, out);
      const bool first = mode == ProvokingVertexMode::FIRST_VERTEX;
      EXPECT_EQ(out[0].value, first ? 1e-40F : 5.5F);
      EXPECT_EQ(out[1].value, first ? 0 : 6);
      EXPECT_EQ(std::signbit(out[1].value), first);
      for (const Interpolated& value : out) {
        EXPECT_EQ(value.bounds.lo, value.value);
        EXPECT_EQ(value.bounds.hi, value.value);
      }
    });
  }
}

TEST(Interpolation, DepthFollowsTheViewportsRange) {
  Scene scene = testing::sceneOf({{0, 0, 0}, {8, 0, 1}, {0, 8, 0}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.viewport.minDepth = 0.75F;
  scene.viewport.maxDepth = 0.25F;
  withPiece(scene, testing::referenceRules(), [](const Primitive&, const SetupTriangle&, const PieceValues& values) {
    EXPECT_EQ(values.depth(4, 0).value, 0.5F);
    EXPECT_EQ(values.depth(0, 0).value, 0.75F);
  });
  // [vk:vertexpostproc-viewport] with negativeOneToOne: (max - min) / 2 · z + (max + min) / 2.
  scene.state.negativeOneToOne = true;
  withPiece(scene, testing::referenceRules(), [](const Primitive&, const SetupTriangle&, const PieceValues& values) {
    EXPECT_EQ(values.depth(8, 0).value, 0.25F);
    EXPECT_EQ(values.depth(0, 0).value, 0.5F);
  });
}

TEST(Interpolation, OfAClippedTriangleContinuesThatOfTheWhole) {
  // The same plane, once inside of the volume and once as part of a triangle four times as large that is cut.
  const auto sceneWith = [](double reach) {
    Scene scene = testing::sceneOf({{1, 1, 0.25, 1}, {1 + reach, 1, 0.25 + reach / 64, 1 + reach / 8}, {1, 1 + reach, 0.25, 1}}, 8);
    scene.target.depthFormat = DepthFormat::D32_SFLOAT;
    // Values linear in space: f / w and 1 / w stay those of the smaller triangle's plane.
    return scene;
  };
  Scene small = sceneWith(6), large = small;
  // In clip space: vertex 1 goes four times as far from vertex 0, vertex 2 as well; the plane is the same.
  std::vector<ClipPosition>& p = large.draws[0].positions;
  for (size_t i = 1; i < 3; ++i) {
    p[i] = {p[0].x + 4 * (p[i].x - p[0].x), p[0].y + 4 * (p[i].y - p[0].y), p[0].z + 4 * (p[i].z - p[0].z), p[0].w + 4 * (p[i].w - p[0].w)};
  }
  small.draws[0].varyings = {{"smooth", Interpolation::smooth, 1, {2, 3, 5}}};
  large.draws[0].varyings = {{"smooth", Interpolation::smooth, 1, {2, 2 + 4 * 1, 2 + 4 * 3}}};
  const Frame whole = *render(small, testing::referenceRules()), cut = *render(large, testing::referenceRules());
  int compared = 0;
  for (size_t i = 0; i < whole.primitive.data.size(); ++i) {
    if (whole.primitive.data[i] == 0 || cut.primitive.data[i] == 0) continue;
    EXPECT_FLOAT_EQ(whole.varyings[0].values.data[i], cut.varyings[0].values.data[i]);
    const Bounds bounds = cut.varyings[0].bounds->data[i];
    EXPECT_LE(bounds.lo, whole.varyings[0].values.data[i]);
    EXPECT_GE(bounds.hi, whole.varyings[0].values.data[i]);
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
