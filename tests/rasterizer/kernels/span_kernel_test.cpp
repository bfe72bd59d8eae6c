// The fast kernel equals the oracle, bit for bit, on every instruction set of this machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include <hwy/targets.h>

#include "kernel_families.hpp"
#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "rasterizer/kernels/integer_spans.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// Runs `test` once for each instruction set that was built and is here.
template <class F>
void onEveryTarget(const F& test) {
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
}

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

int64_t inverseModulo(int64_t a, int64_t m) {
  int64_t r0 = m, r1 = ((a % m) + m) % m, s0 = 0, s1 = 1;
  while (r1 != 0) {
    const int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, s0 - q * s1);
  }
  return r0 == 1 ? ((s0 % m) + m) % m : 0;
}

// The proof of span_setup-inl.h at its limits: edges up to 2^23 subpixels long and high that pass a sample at a distance
// of 0, ±1 or ±2 of the smallest amount that integers allow, anywhere in a target of 16,384 pixels.
TEST(SpanKernel, LinesThatNearlyTouchASampleAtTheLimitsOfTheFastRangeDoNotFlipIt) {
  constexpr int32_t kRange = 1 << 22;
  Prng random(99);
  size_t tried = 0, ties = 0;
  auto mask = *CoverageMask::create(16384, 16, 1), expected = mask;
  while (tried < 3000) {
    const int64_t dy = random.between(kRange / 2, 2 * kRange), dx = random.between(-2 * kRange, 2 * kRange);
    const int64_t inverse = inverseModulo(dx, dy), k = random.between(-2, 2);
    if (inverse == 0) continue;
    const int64_t down = (((inverse * k) % dy) + dy) % dy;  // from the top vertex to the sample: (down · dx) mod dy = k
    const int64_t row = random.below(16), sampleY = 256 * row + 128, ya = sampleY - down;
    const int64_t pixel = random.below(16384), sampleX = 256 * pixel + 128;
    const int64_t xa = sampleX - (down * dx - k) / dy;
    const SnappedTriangle base{{SubpixelPosition{static_cast<int32_t>(xa), static_cast<int32_t>(ya)},
                                {static_cast<int32_t>(xa + dx), static_cast<int32_t>(ya + dy)},
                                {random.between(-kRange, kRange), random.between(-kRange, kRange)}}};
    if (std::ranges::any_of(base.v, [](SubpixelPosition v) { return std::abs(v.x) > kRange || std::abs(v.y) > kRange; }))
      continue;
    ++tried, ties += k == 0;
    expected.clear();
    drawIntegerSpans(base, expected);
    onEveryTarget([&] {
      mask.clear();
      drawCoverage({&base, 1}, mask);
      ASSERT_EQ(mask.differing(expected), 0u) << xa << ' ' << ya << ' ' << dx << ' ' << dy << ' ' << k;
    });
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(ties, 300u);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
