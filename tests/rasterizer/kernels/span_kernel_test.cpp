// The fast kernel equals the oracle, bit for bit, on every instruction set of this machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "every_target.hpp"
#include "kernel_families.hpp"
#include "modular.hpp"
#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "rasterizer/kernels/integer_spans.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::inverseModulo;
using testing::onEveryTarget;

CoverageMask oracle(std::span<const SnappedTriangle> triangles, uint32_t width, uint32_t height, uint32_t samples) {
  auto mask = *CoverageMask::create(width, height, samples);
  const bool far = std::ranges::any_of(triangles, [](const SnappedTriangle& t) {
    return std::ranges::any_of(t.v, [](SubpixelPosition v) { return std::abs(v.x) >= 1 << 29 || std::abs(v.y) >= 1 << 29; });
  });
  EXPECT_FALSE(far) << "beyond the oracle";
  drawCoverageOracle(triangles, mask);
  return mask;
}

/// Few triangles a mask, so that they do not hide one another.
void expectEqual(const testing::Family& family, uint32_t width, uint32_t height, uint32_t samples, size_t masks, size_t each) {
  Prng random(samples * 977 + width);
  for (size_t k = 0; k < masks; ++k) {
    std::vector<SnappedTriangle> triangles;
    while (triangles.size() < each) triangles.push_back(family.make(random));
    const CoverageMask expected = oracle(triangles, width, height, samples);
    onEveryTarget([&] {
      auto mask = *CoverageMask::create(width, height, samples);
      drawCoverage(triangles, mask);
      ASSERT_EQ(mask.differing(expected), 0u) << family.name << ", mask " << k << ", " << samples << " samples";
    });
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(SpanKernel, EqualsTheOracleOnHardTrianglesAtOneSample) {
  for (const auto& family : testing::hardFamilies(331, 203)) expectEqual(family, 331, 203, 1, 150, 3);
}

TEST(SpanKernel, EqualsTheOracleOnManyTrianglesAtOnce) {
  for (const auto& family : testing::hardFamilies(331, 203)) expectEqual(family, 331, 203, 1, 1, 600);
}

TEST(SpanKernel, EqualsTheOracleAtEverySampleCount) {
  for (const uint32_t samples : {2u, 4u, 8u, 16u})
    for (const auto& family : testing::hardFamilies(150, 90)) expectEqual(family, 150, 90, samples, 40, 3);
}

TEST(SpanKernel, EqualsTheOracleOnTargetsOfAwkwardSizes) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {63u, 7u}, {64u, 8u}, {65u, 9u}, {33u, 129u}, {700u, 3u}})
    for (const auto& family : testing::hardFamilies(static_cast<int32_t>(width), static_cast<int32_t>(height)))
      if (family.name != "slivers inside the target") expectEqual(family, width, height, 4, 20, 4);
}

TEST(SpanKernel, ThreadCountDoesNotChangeTheMask) {
  Prng random(5);
  const auto families = testing::hardFamilies(640, 360);
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < 40000) triangles.push_back(families[4].make(random));
  auto one = *CoverageMask::create(640, 360, 4);
  drawCoverage(triangles, one, 1);
  EXPECT_GT(one.count(), 100000u);
  for (const unsigned threads : {2u, 3u, 8u, 0u}) {
    auto many = *CoverageMask::create(640, 360, 4);
    drawCoverage(triangles, many, threads);
    EXPECT_EQ(many.differing(one), 0u) << threads;
  }
}

TEST(SpanKernel, DrawingNothingCoversNothing) {
  auto mask = *CoverageMask::create(8, 8, 4);
  drawCoverage({}, mask, 0);
  EXPECT_EQ(mask.count(), 0u);
}

/// What a sample sees of the long edge of its triangle.
struct NearMiss {
  SnappedTriangle triangle;
  bool tie = false;
};

/// An edge up to 2·`range` subpixels long and high that passes a sample of a target of `width` × 16 pixels at a distance of
/// 0, ±1 or ±2 of the smallest amount that integers allow. The triangle is `thin` (at most 100 px, so that it stays in few
/// windows) or has its third vertex anywhere.
NearMiss nearMiss(Prng& random, int32_t range, uint32_t width, bool thin) {
  while (true) {
    const int64_t dy = random.between(range / 2, 2 * range), dx = random.between(-2 * range, 2 * range);
    const int64_t inverse = inverseModulo(dx, dy), k = random.between(-2, 2);
    if (inverse == 0) continue;
    const int64_t down = (((inverse * k) % dy) + dy) % dy;  // from the top vertex to the sample: (down · dx) mod dy = k
    const int64_t ya = 256 * random.below(16) + 128 - down;
    const int64_t sampleX = 256 * int64_t{random.below(width)} + 128, xa = sampleX - (down * dx - k) / dy;
    const int64_t apex = random.between(0, static_cast<int32_t>(std::min<int64_t>(dy, 2 * range - 1)));
    const auto at = [](int64_t x, int64_t y) { return SubpixelPosition{static_cast<int32_t>(x), static_cast<int32_t>(y)}; };
    const SubpixelPosition third = thin ? at(xa + dx * apex / dy + random.between(-25600, 25600), ya + apex)
                                        : at(random.between(-range, range), random.between(-range, range));
    const SnappedTriangle t{{at(xa, ya), at(xa + dx, ya + dy), third}};
    if (std::ranges::all_of(t.v, [=](SubpixelPosition v) { return std::abs(v.x) <= range && std::abs(v.y) <= range; }))
      return {t, k == 0};
  }
}

void expectNoFlips(int32_t range, uint32_t width, bool thin, int count) {
  Prng random(99);
  int ties = 0;
  auto mask = *CoverageMask::create(width, 16, 1), expected = mask;
  for (int tried = 0; tried < count; ++tried) {
    const NearMiss miss = nearMiss(random, range, width, thin);
    ties += miss.tie;
    expected.clear();
    drawIntegerSpans(miss.triangle, expected);
    onEveryTarget([&] {
      mask.clear();
      drawCoverage({&miss.triangle, 1}, mask);
      const auto& v = miss.triangle.v;
      ASSERT_EQ(mask.differing(expected), 0u) << v[0].x << ' ' << v[0].y << ' ' << v[1].x << ' ' << v[1].y << ' ' << v[2].x
                                              << ' ' << v[2].y;
    });
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(ties, count / 20);
}

// The proof of span_setup-inl.h at its limits, anywhere in a target of 16,384 pixels.
constexpr int32_t kFastRange = 1 << 22;

TEST(SpanKernel, LinesThatNearlyTouchASampleAtTheLimitsOfTheFastRangeDoNotFlipIt) {
  expectNoFlips(kFastRange, 16384, false, 2000);
}

TEST(SpanKernel, ThinTrianglesThatNearlyTouchASampleAtTheLimitsOfTheFastRangeDoNotFlipIt) {
  expectNoFlips(kFastRange, 16384, true, 2000);
}

TEST(SpanKernel, LinesThatNearlyTouchASampleBeyondTheFastRangeDoNotFlipIt) { expectNoFlips(1 << 25, 32768, false, 200); }

TEST(SpanKernel, EqualsTheOracleOnTallAndNarrowTriangles) {
  const testing::Family family{"tall", [](Prng& random) {
    const int32_t x = random.between(0, 150 * 256);
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = {x + random.between(0, 100 * 256), random.between(-2000, 2100 * 256)};
    return t;
  }};
  for (const uint32_t samples : {1u, 4u}) expectEqual(family, 230, 2060, samples, 12, 4);
}

TEST(SpanKernel, FullWindowsStayFullUnderLaterTriangles) {
  // Covers all windows; the others lie on top, so that full ones are skipped.
  std::vector<SnappedTriangle> triangles{{{SubpixelPosition{-500000, -500000}, {1500000, -500000}, {-500000, 1500000}}}};
  Prng random(4);
  while (triangles.size() < 40) triangles.push_back(testing::hardFamilies(700, 90)[7].make(random));
  for (const uint32_t samples : {1u, 4u}) onEveryTarget([&] {
      auto mask = *CoverageMask::create(700, 90, samples);
      drawCoverage(triangles, mask);
      EXPECT_EQ(mask.count(), 700u * 90 * samples);
      mask.clear();
      drawCoverage({}, mask);
      EXPECT_EQ(mask.count(), 0u);
    });
}

}  // namespace
}  // namespace rasterdiff::rasterizer
