// The methods of the table: the exact ones are exact on hard triangles, the others are what their names promise.
#include "rasterizer/kernels/coverage_methods.hpp"

#include <gtest/gtest.h>

#include "kernel_families.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"

namespace rasterdiff::rasterizer {
namespace {

uint64_t wrongSamples(const CoverageMethod& method, const std::vector<SnappedTriangle>& triangles, uint32_t samples) {
  uint64_t wrong = 0;
  for (const SnappedTriangle& t : triangles) {
    auto mask = *CoverageMask::create(97, 61, samples), expected = mask;
    drawCoverageOracle({&t, 1}, expected);
    method.draw({&t, 1}, mask);
    wrong += mask.differing(expected);
  }
  return wrong;
}

TEST(CoverageMethods, EveryExactMethodEqualsTheOracleOnHardTriangles) {
  for (const auto& family : testing::hardFamilies(97, 61)) {
    Prng random(3);
    std::vector<SnappedTriangle> triangles;
    while (triangles.size() < 60) triangles.push_back(family.make(random));
    for (const CoverageMethod& method : coverageMethods())
      for (const uint32_t samples : {1u, 4u})
        if (method.exact) {
          EXPECT_EQ(wrongSamples(method, triangles, samples), 0u) << method.name << ": " << family.name;
        }
  }
}

TEST(CoverageMethods, EveryMethodDrawsTheInsideOfALargeTriangle) {
  const SnappedTriangle t{{SubpixelPosition{1000, 1000}, {20000, 3000}, {5000, 14000}}};
  auto expected = *CoverageMask::create(97, 61, 1);
  drawCoverageOracle({&t, 1}, expected);
  for (const CoverageMethod& method : coverageMethods())
    EXPECT_LE(wrongSamples(method, {t}, 1), expected.count() / 100) << method.name;
}

TEST(CoverageMethods, MethodsWithoutATieRuleOrWithFewerBitsAreWrongOnTies) {
  Prng random(7);
  const auto ties = testing::hardFamilies(97, 61)[0];
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < 200) triangles.push_back(ties.make(random));
  EXPECT_GT(wrongSamples(*coverageMethod("cross-products"), triangles, 1), 0u);
  EXPECT_GT(wrongSamples(*coverageMethod("edge-walking"), triangles, 1), 0u);
}

TEST(CoverageMethods, AnUnknownNameIsNull) { EXPECT_EQ(coverageMethod("magic"), nullptr); }

}  // namespace
}  // namespace rasterdiff::rasterizer
