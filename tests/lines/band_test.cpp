// Three-valued coverage against all legal placements: what is In must be covered by each, what is Out by none.
#include <gtest/gtest.h>

#include "rasterizer/lines/line_band.hpp"
#include "rasterizer/lines/line_reach.hpp"
#include "tests/lines/exact_oracle.hpp"
#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

RasterVertex boxedVertex(SubpixelPosition low, SubpixelPosition size) {
  RasterVertex vertex = vertexAt(low.x / 256.0, low.y / 256.0);
  vertex.highest = {low.x + size.x, low.y + size.y};
  return vertex;
}

struct Corner {
  long double x, y;
};

/// A device: ends somewhere in their boxes, an outline along a direction that it may compute from other places of them,
/// in real numbers, and each corner moved to a neighbouring point of the grid of `step` / 256 pixel (or not at all).
class Device {
 public:
  Device(const RasterVertex& a, const RasterVertex& b, double width, bool rectangular, int32_t step, Random& random) {
    const auto place = [&](const RasterVertex& v) {
      const auto within = [&](int32_t low, int32_t high) { return low + random.below(4 * (high - low) + 1) / 4.0L; };
      return Corner{within(v.lowest.x, v.highest.x), within(v.lowest.y, v.highest.y)};
    };
    const Corner p = place(a), q = place(b);
    const bool elsewhere = rectangular && random.below(2) == 0;
    const Corner from = elsewhere ? place(a) : p, to = elsewhere ? place(b) : q;
    const long double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length == 0) return;
    const long double half = width * 128;
    Corner n{-dy / length * half, dx / length * half};
    if (!rectangular)
      n = std::fabs(dx) >= std::fabs(dy) ? Corner{0, dx > 0 ? half : -half} : Corner{dy > 0 ? -half : half, 0};
    outline_ = {{p.x - n.x, p.y - n.y}, {q.x - n.x, q.y - n.y}, {q.x + n.x, q.y + n.y}, {p.x + n.x, p.y + n.y}};
    const int mode = random.below(3);
    for (Corner& corner : outline_) {
      for (long double* coordinate : {&corner.x, &corner.y}) {
        const long double units = *coordinate / step;
        if (mode == 0 || std::fabs(units - std::round(units)) < 1e-9L) continue;
        const bool down = mode == 1 ? units - std::floor(units) < 0.5L : random.below(2) == 0;
        *coordinate = step * (down ? std::floor(units) : std::ceil(units));
      }
    }
  }

  /// Distance to the nearest edge, > 0 inside; ties and rounding of this test lie within ±1e-9.
  [[nodiscard]] long double inside(int64_t px, int64_t py) const {
    if (outline_.empty()) return -1;
    long double least = 1e30L;
    for (size_t i = 0; i < 4; ++i) {
      const Corner &from = outline_[i], &to = outline_[(i + 1) % 4];
      const long double length = std::hypot(to.x - from.x, to.y - from.y);
      if (length == 0) return -1;
      const auto x = static_cast<long double>(px), y = static_cast<long double>(py);
      least = std::min(least, ((to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x)) / length);
    }
    return least;
  }

 private:
  std::vector<Corner> outline_;
};

struct Tally {
  int in = 0, out = 0, either = 0;
};

Tally compareWithDevices(bool rectangular, uint32_t seed) {
  Random random(seed);
  Limits limits = wideLimits();
  limits.strictLines = rectangular;
  Tally tally;
  for (int i = 0; i < 600; ++i) {
    const int32_t extent = i % 3 == 0 ? 1 : 6, step = i % 2 == 0 ? 1 : 16;
    limits.subPixelPrecisionBits = step == 1 ? 8 : 4;
    const Rules rules = rulesOf("spec", limits);
    const auto vertex = [&] {
      const SubpixelPosition size{random.below(2) * random.below(3) * step, random.below(2) * random.below(3) * step};
      return boxedVertex({random.onGrid(step, extent) + 512, random.onGrid(step, extent) + 512}, size);
    };
    const RasterVertex a = vertex(), b = vertex();
    const float width = std::array{1.0F, 2.0F, 3.0F, 1.2578125F, 4.5F}[static_cast<size_t>(random.below(5))];
    const LineStyle style = styleOf(rectangular ? Mode::RECTANGULAR : Mode::DEFAULT, width);
    const auto band = rectangular ? rectangleBand(a, b, style, rules) : parallelogramBand(a, b, style, rules);
    if (!band) continue;
    std::vector<Device> devices;
    for (int d = 0; d < 40; ++d) devices.emplace_back(a, b, width, rectangular, step, random);
    for (int k = 0; k < 60; ++k) {
      const int64_t px = random.below((extent + 4) * 256), py = random.below((extent + 4) * 256);
      const LineReach reach(a.snapped, b.snapped, band->reach());
      const RowSpan span = reach.columns(static_cast<int32_t>(py >> 8));
      const bool reached = (px >> 8) >= span.begin && (px >> 8) < span.end;
      const Coverage coverage = reached ? band->classify(px, py).coverage : Coverage::Out;
      tally.in += coverage == Coverage::In ? 1 : 0;
      tally.out += coverage == Coverage::Out ? 1 : 0;
      tally.either += coverage == Coverage::Either ? 1 : 0;
      for (const Device& device : devices) {
        const long double inside = device.inside(px, py);
        if (inside > 1e-9L) {
          EXPECT_NE(coverage, Coverage::Out) << px << "," << py;
        }
        if (inside < -1e-9L) {
          EXPECT_NE(coverage, Coverage::In) << px << "," << py;
        }
      }
    }
    if (::testing::Test::HasFailure()) break;
  }
  return tally;
}

TEST(RectangleBand, HoldsForDevicesThatSnapEndsAndCorners) {
  const Tally tally = compareWithDevices(true, 11);
  EXPECT_GT(tally.in, 1000);
  EXPECT_GT(tally.out, 10000);
}

TEST(ParallelogramBand, HoldsForDevicesThatSnapEndsAndCorners) {
  const Tally tally = compareWithDevices(false, 12);
  EXPECT_GT(tally.in, 1000);
  EXPECT_GT(tally.out, 10000);
}

TEST(RectangleBand, IsAsNarrowAsASubpixelOrTwo) {
  const Rules rules = rulesOf("spec");
  const auto shape = makeLineShape(endsOf(2.3, 3.1, 60.7, 41.9), styleOf(Mode::RECTANGULAR, 3), rules);
  int either = 0, in = 0;
  for (int64_t y = 0; y < 64 * 256; y += 64) {
    for (int64_t x = 0; x < 64 * 256; x += 4) {
      const Coverage coverage = shape->classify(x, y).coverage;
      either += coverage == Coverage::Either ? 1 : 0;
      in += coverage == Coverage::In ? 1 : 0;
    }
  }
  EXPECT_GT(in, 100 * either / 4) << "the band is a few subpixels of three pixels";
}

// A device may take the direction from unsnapped ends and the position from snapped ones.
TEST(RectangleBand, ShortWideLinesMayBeTurned) {
  LineEnds ends = endsOf(40, 40, 41, 40);
  ends.a.highest.y += 1;
  ends.b.highest.y += 1;
  const auto shape = makeLineShape(ends, styleOf(Mode::RECTANGULAR, 40), rulesOf("spec"));
  // 19.5 pixels aside, a turn by 1/256 moves the end by 19.5 / 256 pixel, and another one for the ends' own places.
  EXPECT_EQ(shape->classify(40 * 256 - 35, 59 * 256 + 128).coverage, Coverage::Either);
  EXPECT_EQ(shape->classify(40 * 256 - 80, 59 * 256 + 128).coverage, Coverage::Out);
  EXPECT_EQ(shape->classify(40 * 256 + 128, 59 * 256 + 128).coverage, Coverage::In);
}

TEST(LineBands, NameTheirFreedoms) {
  const Rules rules = rulesOf("spec");
  const auto freedomAt = [&](const LineEnds& ends, const LineStyle& style, double x, double y) {
    const auto shape = makeLineShape(ends, style, rules);
    const BandVerdict verdict = shape->classify(static_cast<int64_t>(x * 256), static_cast<int64_t>(y * 256));
    return verdict.coverage == Coverage::Either ? verdict.freedom : Freedom::None;
  };
  const LineEnds level = endsOf(1, 2, 9, 2);
  EXPECT_EQ(freedomAt(level, styleOf(Mode::RECTANGULAR, 1), 4, 2.5), Freedom::TieOwner);
  EXPECT_EQ(freedomAt(level, styleOf(Mode::RECTANGULAR, 1), 4, 2.49), Freedom::None) << "corners on the grid stay";
  EXPECT_EQ(freedomAt(level, styleOf(Mode::RECTANGULAR, 2.0F + 1.0F / 256), 4, 3.0), Freedom::LineWidthStep);
  EXPECT_EQ(freedomAt(endsOf(1, 2, 9, 5), styleOf(Mode::RECTANGULAR, 1), 5 - 0.176, 3.5 + 0.469), Freedom::LineCorner);
  EXPECT_EQ(freedomAt(level, styleOf(Mode::BRESENHAM, 1), 4.5, 2.5), Freedom::BresenhamDeviation);
  LineEnds snapped = level;
  snapped.a.highest.y += 1;
  EXPECT_EQ(freedomAt(snapped, styleOf(Mode::RECTANGULAR, 1), 2, 2.5), Freedom::SnapRounding);
  snapped.a.made = true;
  EXPECT_EQ(freedomAt(snapped, styleOf(Mode::RECTANGULAR, 1), 2, 2.5), Freedom::ClipVertexPosition);
}

TEST(LineBands, WithoutStrictLinesAParallelogramOrABresenhamLine) {
  Limits limits = wideLimits();
  limits.strictLines = false;
  const auto shape = makeLineShape(endsOf(1, 2, 9, 4), styleOf(Mode::DEFAULT, 4), rulesOf("spec", limits));
  EXPECT_EQ(shape->classify(5 * 256 + 10, 3 * 256 + 10).coverage, Coverage::Either)
      << "no pixel of a Bresenham line is certain";
  EXPECT_EQ(shape->classify(5 * 256 + 10, 3 * 256 + 10).freedom, Freedom::LineAlgorithm);
  EXPECT_EQ(shape->classify(5 * 256 + 10, 8 * 256).coverage, Coverage::Out);
}

TEST(LineBands, ACutLineMayBeDrawnUncut) {
  const Rules rules = rulesOf("spec");
  LineEnds ends = endsOf(2, 2.5, 8, 2.5);
  ends.b.made = true;
  ends.uncut = {vertexAt(2, 2.5), vertexAt(12, 2.5)};
  const LineStyle style = styleOf(Mode::RECTANGULAR, 1);
  const auto shape = makeLineShape(ends, style, rules);
  EXPECT_EQ(shape->classify(5 * 256, 2 * 256 + 128).coverage, Coverage::In);
  EXPECT_EQ(shape->classify(10 * 256, 2 * 256 + 128).coverage, Coverage::Either);
  EXPECT_EQ(shape->classify(10 * 256, 2 * 256 + 128).freedom, Freedom::LineClip);
  EXPECT_TRUE(shape->columns(2).end >= 12);
  EXPECT_EQ(shape->classify(14 * 256, 2 * 256 + 128).coverage, Coverage::Out);
  ends.removed = true;
  const auto removed = makeLineShape(ends, style, rules);
  EXPECT_EQ(removed->classify(5 * 256, 2 * 256 + 128).freedom, Freedom::LineClip);
  bool tie = false;
  EXPECT_FALSE(removed->covers(5 * 256, 2 * 256 + 128, tie));
  EXPECT_EQ(makeLineShape(ends, style, rulesOf("reference")), nullptr);
}

TEST(BresenhamBand, HoldsAllFragmentsOfAllPlacementsAndTheirNeighbours) {
  Random random(13);
  const Rules rules = rulesOf("spec"), exact = rulesOf("reference");
  int out = 0, either = 0;
  for (int i = 0; i < 300; ++i) {
    const auto vertex = [&] {
      return boxedVertex({random.onGrid(i % 2 == 0 ? 64 : 1, 8) + 1024, random.onGrid(i % 2 == 0 ? 64 : 1, 8) + 1024},
                         {16 * random.below(2), 16 * random.below(2)});
    };
    LineEnds ends;
    ends.a = vertex();
    ends.b = vertex();
    const LineStyle style = styleOf(Mode::BRESENHAM, static_cast<float>(random.below(3) + 1));
    const auto shape = makeLineShape(ends, style, rules);
    std::vector<std::unique_ptr<Shape>> placements;
    for (unsigned corner = 0; corner < 16; ++corner) {
      const auto pick = [&](unsigned bit, int32_t low, int32_t high) { return (corner & bit) != 0 ? high : low; };
      const SubpixelPosition a{pick(1, ends.a.lowest.x, ends.a.highest.x), pick(2, ends.a.lowest.y, ends.a.highest.y)};
      const SubpixelPosition b{pick(4, ends.b.lowest.x, ends.b.highest.x), pick(8, ends.b.lowest.y, ends.b.highest.y)};
      placements.push_back(makeLineShape(subpixelEnds(a, b), style, exact));
    }
    for (int32_t y = 0; y < 16; ++y) {
      for (int32_t x = 0; x < 16; ++x) {
        bool near = false;
        for (const auto& placement : placements) {
          for (int32_t k = 0; k < 9 && placement && !near; ++k) {
            bool tie = false;
            near = placement->covers((x + k % 3 - 1) * 256 + 128, (y + k / 3 - 1) * 256 + 128, tie);
          }
        }
        const Coverage coverage = shape ? shape->classify(x * 256 + 100, y * 256 + 100).coverage : Coverage::Out;
        if (near) {
          ASSERT_EQ(coverage, Coverage::Either) << x << "," << y << " line " << i;
        }
        out += coverage == Coverage::Out ? 1 : 0;
        either += !near && coverage == Coverage::Either ? 1 : 0;
      }
    }
  }
  EXPECT_GT(out, 20000);
  EXPECT_LT(either, 2000) << "few pixels beyond the neighbours are called free";
}

}  // namespace
}  // namespace rasterdiff::rasterizer
