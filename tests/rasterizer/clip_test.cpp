// Clipping in homogeneous coordinates: what is left, what the new vertices are, and that nothing gets lost or added.
#include "rasterizer/clip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rasterdiff::rasterizer {
namespace {

using Triangle = std::array<ClipPosition, 3>;

struct Clipped {
  ClipOutcome outcome = ClipOutcome::Inside;
  std::vector<ClipVertex> vertices;
};

Clipped clip(const Triangle& triangle, bool negativeOneToOne = false, ClipArithmetic arithmetic = ClipArithmetic::Exact) {
  ClipVolume volume;
  volume.nearAtMinusW = negativeOneToOne;
  const std::array<ClipInput, 3> input{ClipInput{triangle[0], {}}, ClipInput{triangle[1], {}}, ClipInput{triangle[2], {}}};
  ClipPolygon polygon;
  Clipped result;
  result.outcome = clipTriangle(input, arithmetic, volume, polygon);
  if (result.outcome != ClipOutcome::Rejected) {
    result.vertices.assign(polygon.vertices.begin(), polygon.vertices.begin() + polygon.size);
  }
  return result;
}

double screenArea(const std::vector<ClipVertex>& polygon) {
  double twice = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
    twice += a[0] / a[3] * (b[1] / b[3]) - b[0] / b[3] * (a[1] / a[3]);
  }
  return twice / 2;
}

double screenArea(const Triangle& t) {
  std::vector<ClipVertex> vertices(3);
  for (size_t i = 0; i < 3; ++i) vertices[i].position = {t[i].x, t[i].y, t[i].z, t[i].w};
  return screenArea(vertices);
}

// Reflection in plane i (+x -x +y -y near far): what was outside of it is inside, and the other way round.
ClipPosition reflected(const ClipPosition& p, int plane) {
  switch (plane) {
    case 0: return {2 * p.w - p.x, p.y, p.z, p.w};
    case 1: return {-2 * p.w - p.x, p.y, p.z, p.w};
    case 2: return {p.x, 2 * p.w - p.y, p.z, p.w};
    case 3: return {p.x, -2 * p.w - p.y, p.z, p.w};
    case 4: return {p.x, p.y, -p.z, p.w};
    default: return {p.x, p.y, 2 * p.w - p.z, p.w};
  }
}

// Up to `reach` beyond plane i, inside of all others; w between 1/2 and 4.
ClipPosition near(std::mt19937& random, int plane, double reach) {
  std::uniform_real_distribution<double> inside(-0.96875, 0.96875), depth(0.03125, 0.96875), w(0.5, 4), beyond(-reach, reach);
  double ndc[3] = {inside(random), inside(random), depth(random)};
  const double border[6] = {1, -1, 1, -1, 0, 1};
  ndc[plane / 2] = border[plane] + beyond(random);
  const double scale = w(random);
  return {static_cast<float>(ndc[0] * scale), static_cast<float>(ndc[1] * scale), static_cast<float>(ndc[2] * scale),
          static_cast<float>(scale)};
}

TEST(Clip, TriangleInsideIsUntouched) {
  const Triangle triangle{{{-1, -1, 0, 1}, {1, -1, 1, 1}, {0, 1, 0.5F, 1}}};
  const Clipped clipped = clip(triangle);
  EXPECT_EQ(clipped.outcome, ClipOutcome::Inside);
  ASSERT_EQ(clipped.vertices.size(), 3U);
  for (const ClipVertex& vertex : clipped.vertices) EXPECT_FALSE(vertex.made);
}

TEST(Clip, TriangleBeyondOnePlaneIsRejected) {
  for (int plane = 0; plane < 6; ++plane) {
    Triangle triangle{{{0.25F, 0.5F, 0.25F, 1}, {-0.5F, 0.25F, 0.5F, 1}, {0.5F, -0.25F, 0.75F, 1}}};
    EXPECT_EQ(clip(triangle).outcome, ClipOutcome::Inside);
    for (ClipPosition& p : triangle) p = reflected(p, plane);
    EXPECT_EQ(clip(triangle).outcome, ClipOutcome::Rejected) << "plane " << plane;
  }
}

TEST(Clip, BeyondTwoPlanesTogetherNothingIsLeft) {
  const Clipped clipped = clip({{{-2.5F, 0.5F, 0.5F, 1}, {-0.5F, 2.5F, 0.5F, 1}, {-2, 2, 0.5F, 1}}});
  EXPECT_EQ(clipped.outcome, ClipOutcome::Cut);
  EXPECT_LT(clipped.vertices.size(), 3U);
}

// The part inside of a plane and the part beyond it (seen through a reflection) are the whole, for each plane.
TEST(Clip, PartsOnBothSidesOfAPlaneAddUpToTheTriangle) {
  std::mt19937 random(1);
  for (int plane = 0; plane < 6; ++plane) {
    int cut = 0;
    for (int i = 0; i < 2000; ++i) {
      const Triangle triangle{{near(random, plane, 0.9), near(random, plane, 0.9), near(random, plane, 0.9)}};
      Triangle mirror;
      for (size_t k = 0; k < 3; ++k) mirror[k] = reflected(triangle[k], plane);
      const Clipped inside = clip(triangle), outside = clip(mirror);
      if (inside.outcome != ClipOutcome::Cut || outside.outcome != ClipOutcome::Cut) continue;
      ++cut;
      EXPECT_GE(inside.vertices.size(), 3U);
      EXPECT_LE(inside.vertices.size(), 4U);
      const double mirrored = plane < 4 ? -screenArea(outside.vertices) : screenArea(outside.vertices);
      const double whole = screenArea(triangle);
      // Reflecting rounds each coordinate to float32, 2^-24 of at most 3 w, at three vertices of a size of about 3.
      EXPECT_NEAR(screenArea(inside.vertices) + mirrored, whole, 0x1p-24 * 3 * 3 * 3) << "plane " << plane;
    }
    EXPECT_GT(cut, 1000) << "plane " << plane;
  }
}

// Area of triangle ∩ [-1, 1]² by exact integration of its width over y, which knows nothing of clipping.
double areaInSquare(const Triangle& t) {
  const auto crossings = [&](double y, double& left, double& right) {
    left = 1e9;
    right = -1e9;
    for (size_t i = 0; i < 3; ++i) {
      const ClipPosition &a = t[i], &b = t[(i + 1) % 3];
      const double ay = a.y, by = b.y;
      if (ay == by || y < std::min(ay, by) || y > std::max(ay, by)) continue;
      const double x = a.x + (y - ay) / (by - ay) * (double{b.x} - a.x);
      left = std::min(left, x);
      right = std::max(right, x);
    }
  };
  std::vector<double> breaks{-1, 1};
  for (size_t i = 0; i < 3; ++i) {
    const ClipPosition &a = t[i], &b = t[(i + 1) % 3];
    breaks.push_back(a.y);
    for (const double side : {-1.0, 1.0}) {
      if (a.x != b.x) breaks.push_back(a.y + (side - a.x) / (double{b.x} - a.x) * (double{b.y} - a.y));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  double area = 0;
  for (size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double from = std::clamp(breaks[i], -1.0, 1.0), to = std::clamp(breaks[i + 1], -1.0, 1.0);
    if (to <= from) continue;
    double left = 0, right = 0;
    crossings((from + to) / 2, left, right);  // the width is linear between breaks: its middle is its mean
    area += std::max(0.0, std::min(right, 1.0) - std::max(left, -1.0)) * (to - from);
  }
  return area;
}

TEST(Clip, AreaIsThatOfTheTriangleInsideTheSquare) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> anywhere(-3, 3);
  size_t most = 0;
  for (int i = 0; i < 5000; ++i) {
    Triangle triangle;
    for (ClipPosition& p : triangle) p = {anywhere(random), anywhere(random), 0.5F, 1};
    const Clipped clipped = clip(triangle);
    const double area = clipped.vertices.size() < 3 ? 0 : std::fabs(screenArea(clipped.vertices));
    EXPECT_NEAR(area, areaInSquare(triangle), 1e-12);  // doubles on both sides, lengths below 10
    most = std::max(most, clipped.vertices.size());
  }
  EXPECT_EQ(most, 7U) << "a triangle and a square have at most seven corners in common";
}

TEST(Clip, AllSixPlanesLeaveNoMoreThanNineVertices) {
  std::mt19937 random(3);
  std::normal_distribution<float> coordinate(0, 3), weight(1, 1.5F);
  size_t most = 0;
  for (int i = 0; i < 200000; ++i) {
    Triangle triangle;
    for (ClipPosition& p : triangle) p = {coordinate(random), coordinate(random), coordinate(random), weight(random)};
    for (const ClipArithmetic arithmetic : {ClipArithmetic::Exact, ClipArithmetic::Float32Linear}) {
      const Clipped clipped = clip(triangle, i % 2 == 1, arithmetic);
      most = std::max(most, clipped.vertices.size());
      for (const ClipVertex& v : clipped.vertices) {
        const auto& p = v.position;
        const double slack = 1e-5 * (1 + std::fabs(p[0]) + std::fabs(p[1]) + std::fabs(p[2]) + std::fabs(p[3]));
        EXPECT_LE(std::fabs(p[0]), p[3] + slack);  // float32 clipping: within a few roundings of the volume
        EXPECT_LE(std::fabs(p[1]), p[3] + slack);
        EXPECT_LE(p[2], p[3] + slack);
        EXPECT_GE(p[2], (i % 2 == 1 ? -p[3] : 0) - slack);
      }
    }
  }
  EXPECT_LE(most, static_cast<size_t>(ClipPolygon::kCapacity));
  EXPECT_GE(most, 7U);
}

TEST(Clip, WeightsSumToOneAndGiveThePosition) {
  std::mt19937 random(4);
  std::normal_distribution<float> coordinate(0, 1.5F);
  std::uniform_real_distribution<float> weight(0.25F, 4);
  int made = 0;
  for (int i = 0; i < 5000; ++i) {
    Triangle t;
    for (ClipPosition& p : t) p = {coordinate(random), coordinate(random), coordinate(random), weight(random)};
    for (const ClipVertex& v : clip(t).vertices) {
      const auto& s = v.smoothWeights;
      const auto& l = v.linearWeights;
      EXPECT_NEAR(s[0] + s[1] + s[2], 1, 1e-12);  // doubles; linear weights are quotients by w, hence the wider bound
      EXPECT_NEAR(l[0] + l[1] + l[2], 1, 1e-9);
      const auto& p = v.position;
      EXPECT_NEAR(s[0] * t[0].x + s[1] * t[1].x + s[2] * t[2].x, p[0], 1e-12 * 100);
      EXPECT_NEAR(s[0] * t[0].w + s[1] * t[1].w + s[2] * t[2].w, p[3], 1e-12 * 100);
      // Linear weights are barycentrics on the screen: they give the projected point from the projected corners.
      const double x = l[0] * t[0].x / t[0].w + l[1] * t[1].x / t[1].w + l[2] * t[2].x / t[2].w;
      EXPECT_NEAR(x, p[0] / p[3], 1e-9);
      made += v.made ? 1 : 0;
    }
  }
  EXPECT_GT(made, 3000);
}

// [vk:vertexpostproc-clipping] A seam on a clipped edge would show: both sides have to make the very same vertex.
TEST(Clip, BothTrianglesOfASharedEdgeMakeTheSameVertex) {
  std::mt19937 random(5);
  std::normal_distribution<float> coordinate(0, 2), weight(1, 1);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] { return ClipPosition{coordinate(random), coordinate(random), coordinate(random), weight(random)}; };
    const ClipPosition a = any(), b = any(), c = any(), d = any();
    for (const ClipArithmetic arithmetic : {ClipArithmetic::Exact, ClipArithmetic::Float32Linear}) {
      // New vertices on the edge a-b have no part of the third vertex.
      const auto onEdge = [](const Clipped& clipped) {
        std::vector<std::array<double, 4>> positions;
        for (const ClipVertex& v : clipped.vertices) {
          if (v.made && v.smoothWeights[2] == 0) positions.push_back(v.position);
        }
        std::sort(positions.begin(), positions.end());
        positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
        return positions;
      };
      const Clipped first = clip({{a, b, c}}, false, arithmetic), second = clip({{b, a, d}}, false, arithmetic);
      // A triangle of which nothing is left by a later plane keeps no vertices; compare where both have some.
      const auto p = onEdge(first), q = onEdge(second);
      if (first.vertices.size() < 3 || second.vertices.size() < 3) continue;
      EXPECT_EQ(p, q) << "triangle pair " << i;
      compared += static_cast<int>(p.size());
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(Clip, VerticesBehindTheEyeLeaveOnlyWhatIsInFront) {
  const Clipped clipped = clip({{{-0.5F, 0.5F, 0.5F, 1}, {0.5F, 0.5F, 0.5F, 1}, {0.25F, -0.5F, -0.5F, -0.5F}}});
  EXPECT_EQ(clipped.outcome, ClipOutcome::Cut);
  ASSERT_GE(clipped.vertices.size(), 3U);
  for (const ClipVertex& v : clipped.vertices) EXPECT_GT(v.position[3], 0);
}

TEST(Clip, TriangleWhollyBehindTheEyeIsGone) {
  const Clipped clipped = clip({{{-0.5F, 0.5F, -0.5F, -1}, {0.5F, 0.5F, -0.5F, -1}, {0, -0.5F, -0.5F, -2}}});
  EXPECT_LT(clipped.vertices.size(), 3U);
}

TEST(Clip, EdgesAlongTheVolumeAreNotOutlinedAndThoseAlongDistancesAre) {
  // The first vertex is outside of the near plane, then of a distance: new vertices where the outline leaves and returns.
  ClipVolume volume;
  volume.distances = 1;
  const float inside = 1, outside = -1;
  const auto outlined = [&](const Triangle& t, float first) {
    const std::array<ClipInput, 3> input{ClipInput{t[0], {&first, 1}}, ClipInput{t[1], {&inside, 1}}, ClipInput{t[2], {&inside, 1}}};
    ClipPolygon polygon;
    EXPECT_EQ(clipTriangle(input, ClipArithmetic::Exact, volume, polygon), ClipOutcome::Cut);
    std::vector<std::pair<bool, bool>> flags;
    for (int i = 0; i < polygon.size; ++i) {
      const ClipVertex& v = polygon.vertices[static_cast<size_t>(i)];
      flags.emplace_back(v.made, v.outlined);
    }
    return flags;
  };
  using Flags = std::vector<std::pair<bool, bool>>;
  const Triangle beforeNear{{{0, 0, -0.5F, 1}, {0.5F, 0, 0.5F, 1}, {0, 0.5F, 0.5F, 1}}};
  EXPECT_EQ(outlined(beforeNear, inside), (Flags{{true, true}, {false, true}, {false, true}, {true, false}}));
  const Triangle within{{{0, 0, 0.5F, 1}, {0.5F, 0, 0.5F, 1}, {0, 0.5F, 0.5F, 1}}};
  EXPECT_EQ(outlined(within, outside), (Flags{{true, true}, {false, true}, {false, true}, {true, true}}));
}

TEST(Clip, WideSidesCutAtTwiceTheVolume) {
  ClipVolume volume;
  volume.wideSides = true;
  const std::array<ClipInput, 3> input{ClipInput{{-3, 0, 0.5F, 1}, {}}, ClipInput{{0.5F, -0.5F, 0.5F, 1}, {}},
                                       ClipInput{{0.5F, 0.5F, 0.5F, 1}, {}}};
  ClipPolygon polygon;
  ASSERT_EQ(clipTriangle(input, ClipArithmetic::Exact, volume, polygon), ClipOutcome::Cut);
  ASSERT_EQ(polygon.size, 4);
  EXPECT_EQ(polygon.vertices[0].position[0], -2);
  EXPECT_EQ(polygon.vertices[3].position[0], -2);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
