// Area, supersampling and procedural pictures: exact against rationals, sampled against definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "rasterizer/edge_function.hpp"
#include "rasterizer/methods/exact_area.hpp"
#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/procedural.hpp"
#include "rasterizer/methods/sampling_methods.hpp"
#include "rasterizer/methods/triangle_pixels.hpp"
#include "tests/methods/rational_geometry.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Rational;

Rational asRational(const ExactArea& area) {
  Rational sum = area.whole;
  for (const ExactArea::Part& part : area.parts) sum += Rational(part.numerator, part.denominator);
  return sum;
}

TEST(ExactArea, OfRandomTrianglesEqualsTheRationalAreaInEveryPixel) {
  Prng prng(1);
  for (int i = 0; i < 300; ++i) {
    SnappedTriangle triangle;
    const int32_t step = i % 3 == 0 ? 1 : i % 3 == 1 ? 128 : 256;
    for (SubpixelPosition& v : triangle.v) {
      v = {prng.between(-1024 / step, 1536 / step) * step, prng.between(-1024 / step, 1536 / step) * step};
    }
    for (int32_t y = -2; y < 5; ++y) {
      for (int32_t x = -2; x < 5; ++x) {
        const ExactArea area = coveredArea(triangle, {x, y});
        const Rational expected = testing::rationalDoubleArea(triangle, {x, y});
        ASSERT_EQ(asRational(area), expected) << x << ", " << y;
        const Rational pixels = expected / ExactArea::kFullPixel;
        ASSERT_LT(abs(Rational(area.pixels()) - pixels), Rational(1, 1ll << 50));  // the bound that the header states
      }
    }
  }
}

TEST(ExactArea, OfAllPixelsAddsUpToTheTriangle) {
  Prng prng(2);
  for (int i = 0; i < 40; ++i) {
    const SnappedTriangle triangle = i % 2 == 0 ? mediumTriangle(prng) : sliverTriangle(prng);
    Rational sum = 0;
    for (int32_t y = -1; y <= 41; ++y) {
      for (int32_t x = -1; x <= 41; ++x) sum += asRational(coveredArea(triangle, {x, y}));
    }
    EXPECT_EQ(sum, Rational(std::abs(doubleArea(triangle.v[0], triangle.v[1], triangle.v[2]))));
  }
}

TEST(ExactArea, OfHugeTrianglesStaysExact) {
  Prng prng(3);
  constexpr int32_t kFar = 1 << 28;
  for (int i = 0; i < 300; ++i) {
    SnappedTriangle triangle;
    for (SubpixelPosition& v : triangle.v) v = {prng.between(-kFar, kFar), prng.between(-kFar, kFar)};
    triangle.v[1] = {prng.between(0, 512), prng.between(0, 512)};
    for (int32_t y = 0; y < 2; ++y) {
      for (int32_t x = 0; x < 2; ++x) {
        ASSERT_EQ(asRational(coveredArea(triangle, {x, y})), testing::rationalDoubleArea(triangle, {x, y}));
      }
    }
  }
}

TEST(ExactArea, OfATriangleWithoutAreaIsZero) {
  EXPECT_EQ(coveredArea({{{{0, 0}, {512, 512}, {1024, 1024}}}}, {1, 1}).pixels(), 0);
}

TEST(Supersample, OneSampleAPixelIsTheCoverageOfPixelCentres) {
  Prng prng(4);
  const SamplePoints centre = regularSamples(1);
  for (int i = 0; i < 300; ++i) {
    const SnappedTriangle triangle = mediumTriangle(prng);
    PixelMask mask(40, 40);
    addTrianglePixels(triangle, mask);
    for (int32_t y = 0; y < 40; ++y) {
      for (int32_t x = 0; x < 40; ++x) ASSERT_EQ(coveredSamples(triangle, centre, {x, y}), mask.at(x, y));
    }
  }
}

TEST(Supersample, AGridOfNSquaredSamplesIsAPictureNTimesAsLarge) {
  Prng prng(5);
  for (const int32_t n : {2, 3, 7, 32}) {
    const SnappedTriangle triangle = tinyTriangle(prng);
    SnappedTriangle larger = triangle;
    for (SubpixelPosition& v : larger.v) v = {v.x * n, v.y * n};
    PixelMask mask(40 * n, 40 * n);
    addTrianglePixels(larger, mask);
    GrayImage fine(mask.width, mask.height);
    for (int32_t y = 0; y < fine.height; ++y) {
      for (int32_t x = 0; x < fine.width; ++x) fine.at(x, y) = mask.at(x, y);
    }
    const GrayImage coarse = resampleBox(fine, n);
    const SamplePoints points = regularSamples(n);
    for (int32_t y = 0; y < 40; ++y) {
      for (int32_t x = 0; x < 40; ++x) {
        ASSERT_EQ(coveredSamples(triangle, points, {x, y}) / static_cast<double>(n * n), coarse.at(x, y));
      }
    }
  }
}

TEST(Supersample, ASquareOfHalfPixelsIsExactFromTwoByTwoOn) {
  // Half a pixel, cut along the middle of the columns of samples: the lecture's case of a matching pattern.
  const SnappedTriangle upper{{{{0, 0}, {128, 0}, {128, 256}}}}, lower{{{{0, 0}, {128, 256}, {0, 256}}}};
  for (int32_t n = 2; n <= kMaxSupersample; n += 2) {
    const SamplePoints points = regularSamples(n);
    const uint32_t covered = coveredSamples(upper, points, {0, 0}) + coveredSamples(lower, points, {0, 0});
    EXPECT_EQ(covered, static_cast<uint32_t>(n * n / 2));
  }
}

TEST(SamplingMethods, HaveUniqueNamesAndDistinctSamplesWithinThePixel) {
  std::set<std::string> names;
  for (const SamplingMethod& method : samplingMethods()) {
    names.insert(method.name);
    std::set<std::pair<int32_t, int32_t>> places;
    for (const SubpixelPosition p : method.points.offsets) {
      places.emplace(p.x, p.y);
      EXPECT_GE(std::min(p.x, p.y), 0);
      EXPECT_LT(std::max(p.x, p.y), 256 * method.points.scale);
    }
    EXPECT_EQ(places.size(), method.points.offsets.size());
  }
  EXPECT_EQ(names.size(), samplingMethods().size());
}

TEST(Procedural, MeansAgreeWithManySamples) {
  // 64 × 64 samples: the midpoint rule of the zone plate is within φ'' / 24 / 64² < 1e-3 of its mean; a checkerboard's
  // row of samples is off by at most half a sample at each of its borders, 2 · 8 borders of squares across and deep.
  constexpr int32_t kSide = 64;
  for (const ProceduralPicture& picture : proceduralPictures()) {
    const double bound = picture.name == "zone-plate" ? 1e-3 : 16 * 0.5 / kSide;
    for (const auto& [x, y] : {std::pair{3, 5}, {40, 90}, {100, 120}, {127, 127}, {64, 30}, {10, 60}}) {
      double sum = 0;
      for (int32_t k = 0; k < kSide * kSide; ++k)
        sum += picture.at(x + (k % kSide + 0.5) / kSide, y + (k / kSide + 0.5) / kSide);
      EXPECT_NEAR(picture.mean(x, y), sum / (kSide * kSide), bound) << picture.name << ' ' << x << ", " << y;
    }
  }
}

TEST(Procedural, PointSamplesOfTheZonePlateShowAFalseCentreInTheCorner) {
  // At (128, 0) the rings are as fine as the pixels: sampled once a pixel they look like rings around that corner.
  const ProceduralPicture& plate = proceduralPictures()[0];
  const GrayImage sampled = samplePicture(plate, regularSamples(1)), truth = meanPicture(plate);
  double lowest = 1, highest = 0;
  for (int32_t y = 0; y < 16; ++y) {
    lowest = std::min(lowest, sampled.at(126, y));
    highest = std::max(highest, sampled.at(126, y));
    EXPECT_LT(std::fabs(truth.at(126, y) - 0.5), 0.05);  // the truth has faded to grey there
  }
  EXPECT_GT(highest - lowest, 0.9);
}

TEST(Procedural, MoreSamplesMeanLessAliasingAndLessMoire) {
  for (const ProceduralPicture& picture : proceduralPictures()) {
    const GrayImage truth = meanPicture(picture);
    PictureError before = comparePictures(samplePicture(picture, regularSamples(1)), truth);
    EXPECT_GT(before.pixels.rms(), 0.1);
    for (const int32_t n : {4, 16}) {
      const PictureError now = comparePictures(samplePicture(picture, regularSamples(n)), truth);
      EXPECT_LT(now.pixels.rms(), before.pixels.rms()) << picture.name << ' ' << n;
      EXPECT_LT(now.blocks.rms(), before.blocks.rms()) << picture.name << ' ' << n;
      before = now;
    }
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
