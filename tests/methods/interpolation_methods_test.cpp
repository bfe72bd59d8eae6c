// Interpolation: the exact answer against rationals, and what each float32 method gets exactly right.
#include "rasterizer/methods/interpolation_methods.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "rasterizer/methods/method_inputs.hpp"
#include "tests/methods/rational_geometry.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Rational;

Rational cross(SubpixelPosition a, SubpixelPosition b, SubpixelPosition p) {
  return Rational(b.x - a.x) * (p.y - a.y) - Rational(b.y - a.y) * (p.x - a.x);
}

Rational rationalValue(const InterpolatedTriangle& t, SubpixelPosition p, bool perspective) {
  Rational numerator = 0, denominator = 0;
  for (size_t i = 0; i < 3; ++i) {
    Rational weight = cross(t.position[(i + 1) % 3], t.position[(i + 2) % 3], p);
    if (perspective) weight /= Rational(t.w[i]);
    numerator += weight * Rational(t.value[i]);
    denominator += weight;
  }
  return numerator / denominator;
}

TEST(InterpolateExactly, AgreesWithRationalsFarBelowAnUlp) {
  Prng prng(1);
  for (int i = 0; i < 4000; ++i) {
    const auto make = i % 3 == 0 ? mediumTriangle : i % 3 == 1 ? sliverTriangle : farTriangle;
    const SnappedTriangle shape = make(prng);
    const InterpolatedTriangle triangle = withValues(shape, i % 2 == 0 ? 1 : 10'000, prng);
    const SubpixelPosition p = pointInside(shape, prng);
    for (const bool perspective : {false, true}) {
      const Rational exact = rationalValue(triangle, p, perspective);
      const Rational error = abs(Rational(interpolateExactly(triangle, p, perspective)) - exact) / exact;
      EXPECT_LT(error, Rational(1, 1ll << 58));  // the bound that the header states
    }
  }
}

TEST(UlpsFrom, CountsUnitsOfTheLastPlace) {
  EXPECT_EQ(ulpsFrom(1.0L, 1.0f), 0);
  EXPECT_EQ(ulpsFrom(1.0L, 1.0f + 3 * std::numeric_limits<float>::epsilon()), 3);
  EXPECT_EQ(ulpsFrom(1.0L + std::numeric_limits<float>::epsilon() / 2, 1.0f), 0.5);
  EXPECT_EQ(ulpsFrom(4.0L, 4.0f + 4 * std::numeric_limits<float>::epsilon()), 1);
}

TEST(InterpolationMethods, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const InterpolationMethod& method : interpolationMethods()) names.insert(method.name);
  EXPECT_EQ(names.size(), interpolationMethods().size());
}

TEST(InterpolationMethods, SmallIntegersAreInterpolatedWithoutError) {
  // f = 1 + x / 8 + y / 4 on a right triangle of 8 pixels at the origin: every intermediate result is a float32.
  InterpolatedTriangle triangle;
  triangle.position = {{{0, 0}, {8 * 256, 0}, {0, 8 * 256}}};
  triangle.value = {1, 2, 3};
  for (int32_t y = 0; y < 8; ++y) {
    for (int32_t x = 0; x + y < 7; ++x) {
      const SubpixelPosition p{x * 256 + 128, y * 256 + 128};
      const float expected = 1 + (static_cast<float>(x) + 0.5f) / 8 + (static_cast<float>(y) + 0.5f) / 4;
      for (const InterpolationMethod& method : interpolationMethods()) {
        // With w = 1 and weights that are multiples of 1/16 only the quotients of bilinear round.
        if (method.name == "bilinear") continue;
        EXPECT_EQ(method.at(triangle, p), expected) << method.name;
      }
      EXPECT_LE(ulpsFrom(expected, interpolateBilinear(triangle, p)), 1.0);  // one rounded quotient
    }
  }
}

TEST(InterpolationMethods, VerticesKeepTheirValues) {
  Prng prng(2);
  for (int i = 0; i < 500; ++i) {
    const InterpolatedTriangle triangle = withValues(mediumTriangle(prng), 1, prng);
    EXPECT_EQ(interpolatePlaneAtVertex(triangle, triangle.position[0]), triangle.value[0]);
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(ulpsFrom(interpolateExactly(triangle, triangle.position[k], true), triangle.value[k]), 0);
    }
  }
}

TEST(InterpolationMethods, PerspectivePutsTheMiddleOfTheScreenNearerToTheFarEnd) {
  // w = 1 and 3 at the ends of a horizontal edge: at its middle f = (0 · 1/1 + 1 · 1/3) / (1/1 + 1/3) = 1/4.
  InterpolatedTriangle triangle;
  triangle.position = {{{0, 0}, {8 * 256, 0}, {0, 8 * 256}}};
  triangle.w = {1, 3, 1};
  triangle.value = {0, 1, 0};
  const SubpixelPosition middle{4 * 256, 0};
  EXPECT_EQ(interpolateExactly(triangle, middle, true), 0.25L);
  EXPECT_EQ(interpolateExactly(triangle, middle, false), 0.5L);
  EXPECT_LE(ulpsFrom(0.25L, interpolatePerspective(triangle, middle)),
            2.0);  // 1/3, its product, sum and quotient round
  EXPECT_EQ(interpolateBarycentricDifferences(triangle, middle), 0.5f);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
