// Narrow triangles, which have an arithmetic of their own (span_narrow-inl.h): lines that nearly touch a sample, at the limits
// of its proof, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include <hwy/targets.h>

#include "modular.hpp"
#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/integer_spans.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Narrow {
  int32_t side;          ///< of the target, pixels
  int32_t least, most;   ///< height of the long edge, subpixels
  int32_t slope;         ///< its largest, 1/16
  int32_t widest;        ///< subpixels
};

/// The long edge passes a sample at a distance of 0, ±1 or ±2 of the least amount that integers allow; tie if that is 0.
std::pair<SnappedTriangle, bool> nearMiss(Prng& random, const Narrow& narrow) {
  while (true) {
    const int64_t dy = random.between(narrow.least, narrow.most);
    const int64_t dx = random.between(-narrow.slope, narrow.slope) * dy / 16 + random.between(-2000, 2000);
    const int64_t inverse = testing::inverseModulo(dx, dy), k = random.between(-2, 2);
    if (inverse == 0) continue;
    const int64_t down = (((inverse * k) % dy) + dy) % dy;  // from the top vertex to the sample: (down · dx) mod dy = k
    const int64_t ya = 256 * int64_t{random.below(static_cast<uint32_t>(narrow.side))} + 128 - down;
    const int64_t xa = 256 * int64_t{random.below(static_cast<uint32_t>(narrow.side))} + 128 - (down * dx - k) / dy;
    const int64_t apex = random.between(0, static_cast<int32_t>(dy));
    const auto at = [](int64_t x, int64_t y) { return SubpixelPosition{static_cast<int32_t>(x), static_cast<int32_t>(y)}; };
    const SnappedTriangle t{{at(xa, ya), at(xa + dx, ya + dy), at(xa + dx * apex / dy + random.between(-narrow.widest, narrow.widest), ya + apex)}};
    if (std::ranges::all_of(t.v, [&](auto v) { return v.x >= 0 && v.x <= narrow.side * 256 && std::abs(v.y) <= 1 << 20; }))
      return {t, k == 0};
  }
}

void expectNoFlips(const Narrow& narrow, uint32_t samples, int count) {
  Prng random(17);
  int ties = 0;
  const auto side = static_cast<uint32_t>(narrow.side);
  auto mask = *CoverageMask::create(side, side, samples), expected = mask;
  for (int tried = 0; tried < count; ++tried) {
    const auto [triangle, tie] = nearMiss(random, narrow);
    ties += tie;
    expected.clear();
    drawIntegerSpans(triangle, expected);
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      mask.clear();
      drawCoverage({&triangle, 1}, mask);
      const auto& v = triangle.v;
      ASSERT_EQ(mask.differing(expected), 0u) << hwy::TargetName(target) << ": " << v[0].x << ' ' << v[0].y << ' ' << v[1].x << ' '
                                              << v[1].y << ' ' << v[2].x << ' ' << v[2].y;
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  EXPECT_GT(ties, 0);
}

TEST(NarrowTriangles, LinesThatNearlyTouchASampleOfATallBlockDoNotFlipIt) {
  expectNoFlips({1024, 200 * 256, 1008 * 256, 14, 300}, 1, 300);
  expectNoFlips({1024, 1000 * 256, 1008 * 256, 0, 13 * 256}, 1, 300);
}

TEST(NarrowTriangles, LinesThatNearlyTouchASampleOfAWideBlockDoNotFlipIt) {
  expectNoFlips({1024, 200 * 256, 1023 * 256, 64, 300}, 1, 200);
  expectNoFlips({4096, 4000 * 256, 4096 * 256, 15, 20 * 256}, 1, 60);
}

TEST(NarrowTriangles, LinesThatNearlyTouchACentreDoNotFlipOtherSamples) {
  expectNoFlips({600, 200 * 256, 1008 * 256, 14, 300}, 4, 60);
  expectNoFlips({600, 200 * 256, 590 * 256, 40, 300}, 16, 20);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
