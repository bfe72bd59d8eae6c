#include "rasterizer/freedom_band.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rasterdiff::rasterizer {
namespace {

Primitive randomPrimitive(std::mt19937& random, int32_t boxSize, int32_t extent) {
  Primitive primitive;
  primitive.number = 1;
  for (int i = 0; i < 3; ++i) {
    RasterVertex vertex;
    const auto coordinate = [&] { return static_cast<int32_t>(random() % static_cast<unsigned>(extent)); };
    vertex.lowest = {coordinate(), coordinate()};
    vertex.highest = {vertex.lowest.x + static_cast<int32_t>(random() % static_cast<unsigned>(boxSize + 1)),
                      vertex.lowest.y + static_cast<int32_t>(random() % static_cast<unsigned>(boxSize + 1))};
    vertex.snapped = vertex.lowest;
    primitive.polygon.push_back(vertex);
  }
  return primitive;
}

enum class Answer { Never, Sometimes, Always };

// All placements on the full grid inside the boxes, closed triangles (a tie may go either way).
Answer bruteForce(const Primitive& primitive, int64_t px, int64_t py, bool& strictAlways) {
  bool always = true, ever = false;
  strictAlways = true;
  const auto& p = primitive.polygon;
  std::array<SubpixelPosition, 3> v;
  const std::function<void(size_t)> place = [&](size_t k) {
    if (k == 3) {
      const int64_t area = doubleArea(v[0], v[1], v[2]);
      bool closed = area != 0, open = area != 0;
      for (size_t i = 0; i < 3 && area != 0; ++i) {
        const int64_t value = edgeFunction(v[i], v[(i + 1) % 3], TieOwner::TopLeft).at(px, py) * (area > 0 ? 1 : -1);
        closed = closed && value >= 0;
        open = open && value > 0;
      }
      ever = ever || closed;
      always = always && closed;
      strictAlways = strictAlways && open;
      return;
    }
    for (int32_t x = p[k].lowest.x; x <= p[k].highest.x; ++x) {
      for (int32_t y = p[k].lowest.y; y <= p[k].highest.y; ++y) {
        v[k] = {x, y};
        place(k + 1);
      }
    }
  };
  place(0);
  return !ever ? Answer::Never : always ? Answer::Always : Answer::Sometimes;
}

TEST(FreedomBand, AgreesWithAllPlacementsOfTwoByTwoBoxes) {
  std::mt19937 random(5);
  int in = 0, out = 0, either = 0;
  for (int i = 0; i < 3000; ++i) {
    const Primitive primitive = randomPrimitive(random, 1, i % 2 == 0 ? 24 : 1024);
    const FreedomBand band(primitive, CullMode::NONE, FrontFace::COUNTER_CLOCKWISE);
    const auto at = [&] { return static_cast<int64_t>(random() % (i % 2 == 0 ? 26 : 1024)); };
    for (int k = 0; k < 8; ++k) {
      const int64_t px = at(), py = at();
      bool strictAlways = false;
      const Answer expected = bruteForce(primitive, px, py, strictAlways);
      const BandVerdict verdict = band.classifyExactly(px, py);
      if (verdict.coverage == Coverage::In) {
        EXPECT_TRUE(strictAlways);
        ++in;
      } else if (verdict.coverage == Coverage::Out) {
        EXPECT_EQ(expected, Answer::Never);
        ++out;
      } else {
        EXPECT_NE(expected, Answer::Never);
        ++either;
      }
      if (strictAlways && expected == Answer::Always) {
        EXPECT_NE(verdict.coverage, Coverage::Out);
      }
    }
  }
  EXPECT_GT(in, 500);
  EXPECT_GT(out, 500);
  EXPECT_GT(either, 500);
}

TEST(FreedomBand, RowsContainEverySampleThatTheyCallPossibleOrCertain) {
  std::mt19937 random(9);
  for (int i = 0; i < 2000; ++i) {
    const Primitive primitive = randomPrimitive(random, 2, 8 * 256);
    const FreedomBand band(primitive, CullMode::NONE, FrontFace::COUNTER_CLOCKWISE);
    for (int y = 0; y < 8; ++y) {
      const FreedomBand::Row row = band.row(128, y * 256 + 128, {0, 8});
      for (int x = 0; x < 8; ++x) {
        const Coverage coverage = band.classify(x * 256 + 128, y * 256 + 128).coverage;
        const bool possible = x >= row.possible.begin && x < row.possible.end;
        const bool certain = x >= row.certain.begin && x < row.certain.end;
        if (certain) {
          EXPECT_EQ(coverage, Coverage::In);
        }
        if (!possible) {
          EXPECT_EQ(coverage, Coverage::Out);
        }
      }
    }
  }
}

TEST(FreedomBand, SampleOnAFixedEdgeNamesTheTieAndItsEdge) {
  Primitive primitive;
  for (const SubpixelPosition p : {SubpixelPosition{0, 0}, SubpixelPosition{1024, 0}, SubpixelPosition{0, 1024}}) {
    RasterVertex vertex;
    vertex.snapped = vertex.lowest = vertex.highest = p;
    primitive.polygon.push_back(vertex);
  }
  const FreedomBand band(primitive, CullMode::NONE, FrontFace::COUNTER_CLOCKWISE);
  const BandVerdict verdict = band.classify(512, 512);
  EXPECT_EQ(verdict.coverage, Coverage::Either);
  EXPECT_EQ(verdict.freedom, Freedom::TieOwner);
  ASSERT_TRUE(verdict.tieEdge);
  EXPECT_EQ((*verdict.tieEdge)[0], (SubpixelPosition{1024, 0}));
  EXPECT_EQ((*verdict.tieEdge)[1], (SubpixelPosition{0, 1024}));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
