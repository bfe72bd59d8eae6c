// classifyExactly against every placement in boxes of up to four grid points a side: a vertex next to a grid line has
// three, and the placement that covers a sample may be none of the box's corners.
#include <gtest/gtest.h>

#include <random>

#include "rasterizer/freedom_band.hpp"

namespace rasterdiff::rasterizer {
namespace {

Primitive primitiveOf(const std::array<std::array<SubpixelPosition, 2>, 3>& boxes) {
  Primitive primitive;
  primitive.number = 1;
  for (const auto& [lowest, highest] : boxes) {
    RasterVertex vertex;
    vertex.lowest = lowest;
    vertex.highest = highest;
    vertex.snapped = {(lowest.x + highest.x) / 2, (lowest.y + highest.y) / 2};
    primitive.polygon.push_back(vertex);
  }
  return primitive;
}

bool isCulled(CullMode mode, int64_t area) {  // counter-clockwise is front
  if (area == 0) return true;
  return (static_cast<uint32_t>(mode) & static_cast<uint32_t>(area < 0 ? CullMode::FRONT : CullMode::BACK)) != 0;
}

// Does some placement on the grid cover the sample, its edges included?
bool somePlacementCovers(const Primitive& primitive, CullMode cullMode, int64_t px, int64_t py) {
  std::array<std::vector<SubpixelPosition>, 3> places;
  for (size_t k = 0; k < 3; ++k) {
    const RasterVertex& vertex = primitive.polygon[k];
    for (int32_t x = vertex.lowest.x; x <= vertex.highest.x; ++x) {
      for (int32_t y = vertex.lowest.y; y <= vertex.highest.y; ++y) places[k].push_back({x, y});
    }
  }
  for (const SubpixelPosition& a : places[0]) {
    for (const SubpixelPosition& b : places[1]) {
      for (const SubpixelPosition& c : places[2]) {
        const int64_t area = doubleArea(a, b, c);
        if (isCulled(cullMode, area)) continue;
        const int64_t sign = area > 0 ? 1 : -1;
        const auto inside = [&](SubpixelPosition from, SubpixelPosition to) {
          return sign * edgeFunction(from, to, TieOwner::TopLeft).at(px, py) >= 0;
        };
        if (inside(a, b) && inside(b, c) && inside(c, a)) return true;
      }
    }
  }
  return false;
}

// A right triangle with each vertex next to a grid point, and the sample on its acute corner: pulling that corner out in
// x alone covers the sample, pulling it out in both coordinates does not.
TEST(FreedomBandBoxes, SampleAtAnAcuteVertexIsFree) {
  const auto around = [](int32_t x, int32_t y) { return std::array<SubpixelPosition, 2>{{{x - 1, y - 1}, {x + 1, y + 1}}}; };
  const Primitive primitive = primitiveOf({around(31616, 17536), around(37504, 17536), around(31616, 12160)});
  const FreedomBand band(primitive, CullMode::NONE, FrontFace::COUNTER_CLOCKWISE);
  EXPECT_TRUE(somePlacementCovers(primitive, CullMode::NONE, 37504, 17536));
  EXPECT_EQ(band.classifyExactly(37504, 17536).coverage, Coverage::Either);
}

TEST(FreedomBandBoxes, NoPlacementThatCoversIsCalledOut) {
  std::mt19937 random(41);
  int reachable = 0, out = 0;
  for (int i = 0; i < 4000; ++i) {
    const int extent = i % 2 == 0 ? 24 : 600;
    const int largest = i % 4 == 3 ? 3 : 2;  // grid steps
    std::array<std::array<SubpixelPosition, 2>, 3> boxes;
    for (auto& [lowest, highest] : boxes) {
      lowest = {static_cast<int32_t>(random() % static_cast<unsigned>(extent)), static_cast<int32_t>(random() % static_cast<unsigned>(extent))};
      highest = {lowest.x + static_cast<int32_t>(random() % static_cast<unsigned>(largest + 1)),
                 lowest.y + static_cast<int32_t>(random() % static_cast<unsigned>(largest + 1))};
    }
    const Primitive primitive = primitiveOf(boxes);
    const CullMode cullMode = std::array{CullMode::NONE, CullMode::BACK, CullMode::FRONT}[static_cast<size_t>(i) % 3];
    const FreedomBand band(primitive, cullMode, FrontFace::COUNTER_CLOCKWISE);
    for (int k = 0; k < 4; ++k) {
      // Samples at and around a vertex: that is where corner placements miss some.
      const SubpixelPosition& near = boxes[static_cast<size_t>(k) % 3][0];
      const int64_t px = near.x + static_cast<int>(random() % 7) - 2, py = near.y + static_cast<int>(random() % 7) - 2;
      const bool covers = somePlacementCovers(primitive, cullMode, px, py);
      const Coverage coverage = band.classifyExactly(px, py).coverage;
      if (covers) {
        EXPECT_NE(coverage, Coverage::Out) << "triangle " << i << " at " << px << ", " << py;
        ++reachable;
      } else if (largest == 2) {
        EXPECT_EQ(coverage, Coverage::Out) << "triangle " << i << " at " << px << ", " << py;
        ++out;
      }
    }
  }
  EXPECT_GT(reachable, 2000);
  EXPECT_GT(out, 1000);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
