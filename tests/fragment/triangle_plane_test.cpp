// The bound of values on a triangle holds for both ways in which float32 planes are made: from differences of vertex values, and
// as sums of weighted vertices, where the terms of a constant cancel.
#include "rasterizer/fragment/triangle_plane.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rasterdiff::rasterizer {
namespace {

struct Corner {
  int x, y;  // 1/16 pixel
};

std::array<FramebufferPosition, 3> pixels(const std::array<Corner, 3>& corners) {
  std::array<FramebufferPosition, 3> result{};
  for (size_t i = 0; i < 3; ++i) result[i].x = corners[i].x / 16.0, result[i].y = corners[i].y / 16.0;
  return result;
}

/// The value at a point between the corners, from a plane whose slopes are float32 sums of weighted vertices.
float weightedSum(const std::array<Corner, 3>& c, const std::array<float, 3>& v, const std::array<float, 3>& at) {
  const auto edge = [](int d) { return static_cast<float>(d) / 16.0F; };
  const float e1x = edge(c[1].x - c[0].x), e1y = edge(c[1].y - c[0].y), e2x = edge(c[2].x - c[0].x), e2y = edge(c[2].y - c[0].y);
  const float q = 1.0F / (e1x * e2y - e1y * e2x);  // exact before the division: few bits
  const float gx = v[0] * (edge(c[1].y - c[2].y) * q) + v[1] * (e2y * q) + v[2] * (-e1y * q);
  const float gy = v[0] * (edge(c[2].x - c[1].x) * q) + v[1] * (-e2x * q) + v[2] * (e1x * q);
  return v[0] + gx * (at[1] * e1x + at[2] * e2x) + gy * (at[1] * e1y + at[2] * e2y);
}

TEST(TrianglePlane, BoundsConstantsOfNeedlesThatAreSumsOfWeightedVertices) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(-2048, 2048), nudge(-2, 2);
  double worst = 0, mostUlps = 0;
  for (int n = 0; n < 20'000; ++n) {
    const Corner a{place(random), place(random)}, b{place(random), place(random)};
    const Corner c{(a.x + b.x) / 2 + nudge(random), (a.y + b.y) / 2 + nudge(random)};
    if ((b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x)) continue;
    const TrianglePlane plane(pixels({a, b, c}), 0);
    const LinearFunction constant = plane.through({5.75, 5.75, 5.75}, 0, 0);
    const double error = std::fabs(double{weightedSum({a, b, c}, {5.75F, 5.75F, 5.75F}, {0.25F, 0.25F, 0.5F})} - 5.75);
    worst = std::max(worst, error / constant.radius(0, 0));
    mostUlps = std::max(mostUlps, error / (5.75 * 2 * kHalfUlp));
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(mostUlps, 100) << "needles that lose nothing prove nothing";
}

TEST(TrianglePlane, LeavesConstantsOfWellShapedTrianglesFewUlps) {
  const TrianglePlane plane(pixels({{{0, 0}, {160, 0}, {0, 160}}}), 0);
  const LinearFunction constant = plane.through({5.75, 5.75, 5.75}, 0, 0);
  EXPECT_LE(constant.radius(5, 5), 32 * 5.75 * 2 * kHalfUlp);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
