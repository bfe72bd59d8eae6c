// The six half-spaces of the view volume, one vertex at a time. [vk:vertexpostproc-clipping]
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rasterizer/clip.hpp"

namespace rasterdiff::rasterizer {
namespace {

enum Bit : unsigned { kPlusX = 1, kMinusX = 2, kPlusY = 4, kMinusY = 8, kNear = 16, kFar = 32 };

unsigned code(const ClipPosition& p, bool negativeOneToOne = false, DeliberateError error = DeliberateError::None) {
  State state;
  state.negativeOneToOne = negativeOneToOne;
  return outcode({p, {}}, clipVolume(state, Draw{}, error));
}

float above(float value) { return std::nextafter(value, std::numeric_limits<float>::infinity()); }
float below(float value) { return std::nextafter(value, -std::numeric_limits<float>::infinity()); }

TEST(Outcode, EveryPlaneIsInsideAndOneUlpBeyondIsOutside) {
  for (const float w : {1.0F, 3.0F, 0x1p-100F, 0x1p100F}) {
    EXPECT_EQ(code({w, w, w, w}), 0U);
    EXPECT_EQ(code({-w, -w, 0, w}), 0U);
    EXPECT_EQ(code({above(w), 0, 0, w}), kPlusX);
    EXPECT_EQ(code({below(-w), 0, 0, w}), kMinusX);
    EXPECT_EQ(code({0, above(w), 0, w}), kPlusY);
    EXPECT_EQ(code({0, below(-w), 0, w}), kMinusY);
    EXPECT_EQ(code({0, 0, above(w), w}), kFar);
    EXPECT_EQ(code({0, 0, -std::numeric_limits<float>::denorm_min(), w}), kNear);
  }
}

TEST(Outcode, NegativeOneToOneMovesTheNearPlaneToMinusW) {
  EXPECT_EQ(code({0, 0, -1, 1}, true), 0U);
  EXPECT_EQ(code({0, 0, below(-1), 1}, true), kNear);
  EXPECT_EQ(code({0, 0, above(1), 1}, true), kFar);
  EXPECT_EQ(code({0, 0, -1, 1}, false), kNear);
}

TEST(Outcode, NothingWithNegativeWIsInside) {
  for (const float x : {-2.0F, 0.0F, 2.0F}) {
    for (const float z : {-2.0F, -0.5F, 0.0F, 2.0F}) {
      EXPECT_NE(code({x, 0, z, -1}, false), 0U) << x << ", " << z;
      EXPECT_NE(code({x, 0, z, -1}, true), 0U) << x << ", " << z;
    }
  }
}

TEST(Outcode, WithWZeroOnlyTheOriginIsInside) {
  EXPECT_EQ(code({0, 0, 0, 0}), 0U);
  EXPECT_EQ(code({1, 0, 0, 0}), kPlusX);
  EXPECT_EQ(code({-1, 0, 0, 0}), kMinusX);
  EXPECT_EQ(code({0, 1, 0, 0}), kPlusY);
  EXPECT_EQ(code({0, -1, 0, 0}), kMinusY);
  EXPECT_EQ(code({0, 0, 1, 0}), kFar);
  EXPECT_EQ(code({0, 0, -1, 0}), kNear);
}

TEST(Outcode, InfinitiesAreOutside) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(code({infinity, 0, 0, 1}), kPlusX);
  EXPECT_EQ(code({0, -infinity, 0, 1}), kMinusY);
  EXPECT_EQ(code({0, 0, infinity, 1}), kFar);
}

TEST(OutcodeMutants, EachMovesItsOwnPlaneOnly) {
  EXPECT_EQ(code({0, 0, -1, 1}, false, DeliberateError::WrongNearPlane), 0U);
  EXPECT_EQ(code({0, 0, -1, 1}, true, DeliberateError::WrongNearPlane), kNear);
  EXPECT_EQ(code({2, 0, 2, 1}, false, DeliberateError::NoFarClip), kPlusX);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
