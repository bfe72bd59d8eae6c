// Random lines and points: on their grid, inside of the volume, the same for the same seed, and of every kind.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/generators/random_lines.hpp"
#include "scene/generators/random_points.hpp"
#include "scene/needs.hpp"

namespace rasterdiff {
namespace {

constexpr float kExtent = 128;

float pixels(float clip) { return (clip + 1) * (kExtent / 2); }
bool isMultiple(float value, float step) { return std::fmod(value, step) == 0; }

TEST(RandomLines, LieOnTheirGridInsideTheVolume) {
  const Scene scene = randomLines({.seed = 7});
  ASSERT_TRUE(validate(scene).has_value());
  EXPECT_FALSE(needsClipping(scene));
  EXPECT_EQ(primitiveCount(scene.state, scene.draws[0]), 400u);
  for (const ClipPosition& p : scene.draws[0].positions) {
    EXPECT_TRUE(isMultiple(pixels(p.x), 1.0f / 16)) << p.x;
    EXPECT_TRUE(isMultiple(pixels(p.y), 1.0f / 16)) << p.y;
  }
}

TEST(RandomLines, HaveEveryKind) {
  const std::vector<ClipPosition> v = randomLines({.seed = 7, .lines = 1000}).draws[0].positions;
  size_t horizontal = 0, vertical = 0, diagonal = 0, zero = 0, onCentre = 0, octant[8] = {};
  for (size_t i = 0; i < v.size(); i += 2) {
    const float dx = v[i + 1].x - v[i].x, dy = v[i + 1].y - v[i].y;
    horizontal += dy == 0 && dx != 0;
    vertical += dx == 0 && dy != 0;
    diagonal += dx != 0 && std::fabs(dx) == std::fabs(dy);
    zero += dx == 0 && dy == 0;
    onCentre += isMultiple(pixels(v[i].x) + 0.5f, 1) && isMultiple(pixels(v[i].y) + 0.5f, 1);
    ++octant[(dx < 0 ? 1 : 0) + (dy < 0 ? 2 : 0) + (std::fabs(dx) < std::fabs(dy) ? 4 : 0)];
  }
  for (const size_t count : {horizontal, vertical, diagonal}) EXPECT_GE(count, 40u);
  EXPECT_GE(zero, 5u);
  EXPECT_GE(onCentre, 10u);
  for (const size_t count : octant) EXPECT_GE(count, 50u);
}

TEST(RandomPoints, LieOnTheirGridAndHaveTheSizesAskedFor) {
  const Scene scene = randomPoints({.seed = 9, .smallest = 0.5f, .largest = 16});
  ASSERT_TRUE(validate(scene).has_value());
  EXPECT_FALSE(needsClipping(scene));
  const Draw& draw = scene.draws[0];
  ASSERT_EQ(draw.pointSizes.size(), 400u);
  for (const ClipPosition& p : draw.positions) EXPECT_TRUE(isMultiple(pixels(p.x), 1.0f / 16)) << p.x;
  float least = 100, most = 0;
  for (const float size : draw.pointSizes) {
    EXPECT_TRUE(isMultiple(size, 0.125f)) << size;
    least = std::min(least, size);
    most = std::max(most, size);
  }
  EXPECT_GE(least, 0.5f);
  EXPECT_LE(least, 1.0f);
  EXPECT_GE(most, 15.0f);
  EXPECT_LE(most, 16.0f);
}

TEST(RandomLinesAndPoints, TheSameSeedGivesTheSameSceneAndAnotherAnother) {
  EXPECT_EQ(randomLines({.seed = 3}), randomLines({.seed = 3}));
  EXPECT_NE(randomLines({.seed = 3}), randomLines({.seed = 4}));
  EXPECT_EQ(randomPoints({.seed = 3, .grid = Grid::Free}), randomPoints({.seed = 3, .grid = Grid::Free}));
  EXPECT_NE(randomPoints({.seed = 3, .grid = Grid::Free}), randomPoints({.seed = 4, .grid = Grid::Free}));
}

}  // namespace
}  // namespace rasterdiff
