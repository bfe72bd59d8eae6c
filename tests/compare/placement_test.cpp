// The joint placement of vertices: against an independent enumeration, and on meshes whose answer is known.
#include "harness/compare/placement/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/compare/compare.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Rules;
using State = PlacementAnswer::State;

constexpr uint32_t kExtent = 32;

Limits coarseLimits() {
  Limits limits;
  limits.subPixelPrecisionBits = 4;
  return limits;
}

Rules openRules() { return Rules::specification(coarseLimits()); }

Rules rounding(rasterizer::SnapRounding how) {
  Rules rules = *Rules::profile("reference", coarseLimits());
  rules.choices.snapRounding = how;
  return rules;
}

// Off the grid of 1/16 pixel, on that of 1/1024.
testing::Point randomPoint(std::mt19937& random) {
  std::uniform_int_distribution<int> coordinate(2 * 1024, 30 * 1024);
  return {coordinate(random) / 1024.0, coordinate(random) / 1024.0};
}

// A fan around a centre: every vertex but those of the border is shared.
Scene fan(std::mt19937& random, int blades) {
  std::vector<testing::Point> points;
  const testing::Point centre = randomPoint(random);
  std::vector<testing::Point> rim;
  for (int i = 0; i < blades; ++i) {
    const double angle = 2 * 3.14159265358979 * i / blades;
    rim.push_back({std::round((16 + 13 * std::cos(angle)) * 1024) / 1024, std::round((16 + 13 * std::sin(angle)) * 1024) / 1024});
  }
  for (int i = 0; i < blades; ++i) {
    points.push_back({(centre.x + 16 * 7) / 8, (centre.y + 16 * 7) / 8});
    points.push_back(rim[static_cast<size_t>(i)]);
    points.push_back(rim[static_cast<size_t>((i + 1) % blades)]);
  }
  return testing::sceneOf(points, kExtent, 4);
}

struct Sides {
  Frame reference, actual;
};

Sides drawBoth(const Scene& scene, const Rules& actual) {
  return {*rasterizer::render(scene, openRules()), *rasterizer::render(scene, actual)};
}

PlacementAnswer answerOf(const Scene& scene, const Sides& sides) {
  return *explainByPlacement(scene, openRules(), sides.reference, sides.actual);
}

// Independent of the tool: all places of three vertices on all grids of 4 to 12 bits, in doubles that hold every product
// exactly (coordinates below 2^18 in 1/4096 pixel).
bool somePlacementDraws(const std::vector<testing::Point>& points, const Plane<uint32_t>& primitive) {
  const auto inside = [&](const std::array<std::array<double, 2>, 3>& v, double px, double py, bool& tie) {
    const double area = (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]);
    if (area == 0) return false;
    bool in = true;
    for (size_t e = 0; e < 3; ++e) {
      const auto& a = v[e];
      const auto& b = v[(e + 1) % 3];
      const double value = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) * (area > 0 ? 1 : -1);
      if (value < 0) return false;
      if (value == 0) tie = true;
    }
    return in;
  };
  for (int bits = 4; bits <= 12; ++bits) {
    for (unsigned placement = 0; placement < 64; ++placement) {
      std::array<std::array<double, 2>, 3> v{};
      for (size_t i = 0; i < 3; ++i) {
        const auto place = [&](double pixels, unsigned bit) {
          const double grid = std::ldexp(pixels, bits);
          return std::ldexp((placement >> bit & 1U) != 0 ? std::ceil(grid) : std::floor(grid), 12 - bits);
        };
        v[i] = {place(points[i].x, static_cast<unsigned>(2 * i)), place(points[i].y, static_cast<unsigned>(2 * i + 1))};
      }
      bool fits = true;
      for (uint32_t y = 0; y < kExtent && fits; ++y) {
        for (uint32_t x = 0; x < kExtent && fits; ++x) {
          bool tie = false;
          const bool in = inside(v, x * 4096.0 + 2048, y * 4096.0 + 2048, tie);
          const bool drawn = primitive.at(x, y, 0) != 0;
          fits = in == drawn || tie;
        }
      }
      if (fits) return true;
    }
  }
  return false;
}

TEST(Placement, AgreesWithAnEnumerationOnMasksWithFlippedFreeSamples) {
  std::mt19937 random(7);
  int explained = 0, impossible = 0;
  for (int i = 0; i < 400; ++i) {
    const std::vector<testing::Point> points{randomPoint(random), randomPoint(random), randomPoint(random)};
    const Scene scene = testing::sceneOf(points, kExtent);
    Sides sides = drawBoth(scene, rounding(rasterizer::SnapRounding::NearestEven));
    for (size_t s = 0; s < sides.actual.primitive.data.size(); ++s) {
      if (sides.reference.coverage->data[s] != Coverage::Either || random() % 3 != 0) continue;
      sides.actual.primitive.data[s] ^= 1U;
      sides.actual.count.data[s] ^= 1U;
    }
    const PlacementAnswer answer = answerOf(scene, sides);
    ASSERT_NE(answer.state, State::Undecided);
    const bool expected = somePlacementDraws(points, sides.actual.primitive);
    ASSERT_EQ(answer.state == State::Explained, expected) << "triangle " << i << " " << describe(answer) << " grid " << answer.gridBits << " req " << answer.requirements << " left " << answer.leftOut;
    ++(expected ? explained : impossible);
  }
  EXPECT_GT(explained, 50);
  EXPECT_GT(impossible, 50);
}

TEST(Placement, AnotherRoundingOfAFanIsExplainedOnTheAdvertisedGrid) {
  std::mt19937 random(3);
  uint64_t moved = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = fan(random, 5 + i % 9);
    const PlacementAnswer answer = answerOf(scene, drawBoth(scene, rounding(rasterizer::SnapRounding::Floor)));
    ASSERT_EQ(answer.state, State::Explained) << describe(answer);
    EXPECT_EQ(answer.gridBits, 4);
    moved += answer.movedVertices;
  }
  EXPECT_GT(moved, 60U);
}

TEST(Placement, AFinerGridThanAdvertisedIsFound) {
  std::mt19937 random(5);
  int finer = 0;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = fan(random, 8);
    const PlacementAnswer answer = answerOf(scene, drawBoth(scene, *Rules::profile("reference", Limits{})));
    ASSERT_EQ(answer.state, State::Explained) << describe(answer);
    finer += answer.gridBits > 4 ? 1 : 0;
  }
  EXPECT_GT(finer, 0);
}

// Each triangle alone has a legal placement; the shared vertices would have to be in two places.
TEST(Placement, SharedVerticesThatMoveApartAreImpossible) {
  std::mt19937 random(11);
  int impossible = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = fan(random, 6);
    Sides sides = drawBoth(scene, rounding(rasterizer::SnapRounding::Floor));
    const Frame other = *rasterizer::render(scene, rounding(rasterizer::SnapRounding::NearestEven));
    Frame& actual = sides.actual;
    for (size_t s = 0; s < actual.primitive.data.size(); ++s) {
      const bool odd = actual.primitive.data[s] % 2 == 1, otherOdd = other.primitive.data[s] % 2 == 1;
      const uint32_t winner = odd ? actual.primitive.data[s] : otherOdd ? 0 : other.primitive.data[s];
      actual.primitive.data[s] = winner;
      actual.count.data[s] = winner == 0 ? 0 : 1;
    }
    SceneResult result = *compare(scene, openRules(), sides.reference, actual);
    const bool allowed = result.verdict == Verdict::Allowed;
    ASSERT_TRUE(judgeJointly(scene, openRules(), sides.reference, actual, result));
    if (!allowed || !result.placement || result.placement->state != State::Impossible) continue;
    ++impossible;
    EXPECT_EQ(result.verdict, Verdict::Differs);
    EXPECT_GT(result.differing, 0U);
    EXPECT_EQ(result.samples, result.same + result.allowed + result.differing);
    EXPECT_FALSE(result.placement->conflict.empty());
    EXPECT_LE(result.placement->conflict.size(), 6U);
  }
  EXPECT_GT(impossible, 5);
}

TEST(Placement, ClosedRulesAreNotAsked) {
  std::mt19937 random(1);
  const Scene scene = fan(random, 6);
  const Rules closed = rounding(rasterizer::SnapRounding::NearestEven);
  const Frame frame = *rasterizer::render(scene, closed);
  SceneResult result = *compare(scene, closed, frame, frame);
  ASSERT_TRUE(judgeJointly(scene, closed, frame, frame, result));
  EXPECT_FALSE(result.placement);
}

}  // namespace
}  // namespace rasterdiff::harness
