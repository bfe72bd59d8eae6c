// The planes of the value oracle hold the exact values of the triangles that it says are seen, rounded once.
#include "rasterizer/kernels/value_oracle.hpp"

#include "value_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

TEST(ValueOracle, HoldsTheExactValuesOfWhatIsSeen) {
  constexpr uint32_t kWidth = 60, kHeight = 40;
  Prng random(81);
  std::vector<SnappedTriangle> triangles;
  for (int k = 0; k < 40; ++k) {
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = {random.between(-2000, 256 * 65), random.between(-2000, 256 * 45)};
    triangles.push_back(t);
  }
  const testing::ValueLoad load =
      testing::makeLoad(triangles, {ValueKind::Perspective, ValueKind::Flat, ValueKind::Noperspective}, random);
  for (const uint32_t samples : {1u, 4u}) {
    auto target = *ValueTarget::create(kWidth, kHeight, samples, {true, true, true, 3});
    drawValuesOracle(load.view(), target);
    size_t seen = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
      for (uint32_t x = 0; x < kWidth; ++x)
        for (uint32_t s = 0; s < samples; ++s) {
          const size_t i = target.index(x, y, s);
          if (target.primitive[i] == 0) continue;
          ++seen;
          const size_t t = target.primitive[i] - 1;
          const SampleLocation at = target.locations()[s];
          const SubpixelPosition corner{static_cast<int32_t>(x) * kSubpixelOne, static_cast<int32_t>(y) * kSubpixelOne};
          const SubpixelPosition sample{corner.x + at.x * kSampleUnit, corner.y + at.y * kSampleUnit};
          const SubpixelPosition centre{corner.x + kSubpixelOne / 2, corner.y + kSubpixelOne / 2};
          const auto valuesOf = [&](size_t c) { return std::array{load.values[9 * t + c], load.values[9 * t + 3 + c], load.values[9 * t + 6 + c]}; };
          const std::array w{load.reciprocalW[3 * t], load.reciprocalW[3 * t + 1], load.reciprocalW[3 * t + 2]};
          ASSERT_EQ(target.depth[i], static_cast<float>(exactValue(triangles[t], sample, {load.depth[3 * t], load.depth[3 * t + 1], load.depth[3 * t + 2]})));
          ASSERT_EQ(target.varyings[0][i], static_cast<float>(exactPerspectiveValue(triangles[t], centre, valuesOf(0), w)));
          ASSERT_EQ(target.varyings[1][i], valuesOf(1)[0]);
          ASSERT_EQ(target.varyings[2][i], static_cast<float>(exactValue(triangles[t], centre, valuesOf(2))));
        }
    EXPECT_GT(seen, 2000u);
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
