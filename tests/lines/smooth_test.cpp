// Smooth lines: how much of a pixel a rectangle covers, by hand; which pixels are free, and which are not.
#include <gtest/gtest.h>

#include <cmath>

#include "rasterizer/lines/smooth_line.hpp"
#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

RasterVertex at(double x, double y) {
  RasterVertex vertex;
  vertex.position = {x, y, 0};
  vertex.snapped = vertex.lowest = vertex.highest = {static_cast<int32_t>(x * 256), static_cast<int32_t>(y * 256)};
  return vertex;
}

Limits wide() {
  Limits limits;
  limits.smoothLines = true;
  limits.lineWidthMax = 16;
  limits.lineWidthGranularity = 1.0F / 128;
  return limits;
}

Scene smooth(const std::vector<testing::Point>& ends, float width) {
  Scene scene = testing::sceneOf(ends, 16);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR_SMOOTH;
  scene.state.lineWidth = width;
  return scene;
}

TEST(SmoothLine, CoverageIsTheAreaOfThePixelInsideOfTheRectangle) {
  const RasterVertex a = at(2.25, 5), b = at(6, 5);
  EXPECT_EQ(smoothCoverage(a, b, 2, wide(), 3, 4).value, 1);      // rows 4 and 5, columns 2.25 to 6
  EXPECT_EQ(smoothCoverage(a, b, 2, wide(), 2, 4).value, 0.75);
  EXPECT_EQ(smoothCoverage(a, b, 2, wide(), 2, 6).value, 0);
  EXPECT_EQ(smoothCoverage(a, b, 1, wide(), 4, 4).value, 0.5);
  EXPECT_EQ(smoothCoverage(a, b, 1, wide(), 2, 5).value, 0.375);
  // A slope of 1 through the pixel's corners, √½ wide: all but two triangles with legs of 1/2.
  EXPECT_NEAR(smoothCoverage(at(0, 0), at(8, 8), std::sqrt(0.5F), Limits{.lineWidthMin = 0, .lineWidthMax = 2}, 3, 3).value,
              0.75, 1e-3);  // widths are kept in 1/256 pixel
}

TEST(SmoothLine, LegalCoverageIsThatOfRectanglesHalfAPixelLargerOrSmaller) {
  const Interval edge = smoothCoverage(at(2, 5.25), at(6, 5.25), 2, wide(), 4, 4);  // rows 4.25 to 6.25
  EXPECT_EQ(edge.value, 0.75);
  EXPECT_EQ(edge.lo, 0.25);
  EXPECT_EQ(edge.hi, 1);
  EXPECT_EQ(smoothCoverage(at(2, 5.25), at(6, 5.25), 2, wide(), 4, 7).hi, 0);
}

TEST(SmoothLine, WhatIsNearIsFreeAndWhatIsFarOrInsideIsNot) {
  const Result<Frame> frame = render(smooth({{4.5, 8}, {12.5, 8}}, 4), Rules::specification(wide()));  // rows 6 to 9
  const Plane<Coverage> coverage = frame->coverage.value();
  const auto row = [&](uint32_t y) {
    std::string text;
    for (uint32_t x = 0; x < 16; ++x) text += ".#?"[static_cast<size_t>(coverage.at(x, y, 0))];
    return text;
  };
  EXPECT_EQ(row(3), "................");
  EXPECT_EQ(row(5), "...???????????..");
  EXPECT_EQ(row(7), "...??#######??..");
}

TEST(SmoothLine, NoProfileSaysMore) {
  const Scene scene = smooth({{4.5, 8}, {12.5, 8}}, 4);
  const Result<Rules> profile = Rules::profile("lavapipe", wide());
  ASSERT_TRUE(profile.has_value());
  EXPECT_TRUE(render(scene, *profile)->coverage.has_value());
}

TEST(SmoothLine, AlphaIsMultipliedByTheCoverage) {
  Scene scene = smooth({{4, 8}, {12, 8}}, 1);
  scene.draws[0].varyings = {{.name = "c", .components = 4, .values = {1, 1, 1, 0.5F, 1, 1, 1, 0.5F}}};
  const Frame frame = *render(scene, *Rules::profile("reference", wide()));
  const VaryingPlane& colour = frame.varyings[0];
  EXPECT_EQ(colour.values.at(6, 7, 0, 0), 1);
  EXPECT_EQ(colour.values.at(6, 7, 0, 3), 0.25F);
  EXPECT_NEAR(colour.bounds->at(6, 7, 0, 3).lo, 0, 1e-6);  // roundings
  EXPECT_NEAR(colour.bounds->at(6, 7, 0, 3).hi, 0.5, 1e-6);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
