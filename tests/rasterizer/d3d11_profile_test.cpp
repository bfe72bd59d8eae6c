// Direct3D 11.3's rules, by examples computed by hand from its rules (its figures are not followed: one is known to be wrong).
#include <gtest/gtest.h>

#include <cmath>

#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint32_t kExtent = 8;

Rules d3d11() {
  Limits limits;
  limits.subPixelPrecisionBits = 4;  // the profile has its own grid, whatever a device advertises
  return *Rules::profile("d3d11", limits);
}

std::vector<std::string> drawn(const Scene& scene, const Rules& rules = d3d11()) {
  const Result<Frame> frame = render(scene, rules);
  if (!frame) return {frame.error().what};
  std::vector<std::string> rows;
  for (uint32_t y = 0; y < frame->height; ++y) {
    std::string& row = rows.emplace_back();
    for (uint32_t x = 0; x < frame->width; ++x) row += frame->primitive.at(x, y, 0) != 0 ? '#' : '.';
  }
  return rows;
}

Scene line(double x0, double y0, double x1, double y1) {
  Scene scene = testing::sceneOf({{x0, y0}, {x1, y1}}, kExtent);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
  return scene;
}

/// Columns of row 2 that a triangle covers whose left edge is vertical at x.
std::string columnsRightOf(double x) {
  return drawn(testing::sceneOf({{x, 0}, {8, 2.5}, {x, 5}}, kExtent))[2];
}

TEST(Direct3D11, VerticesGoToTheNearestOf256StepsAndHalvesToTheEvenOne) {
  EXPECT_EQ(columnsRightOf(2.5), "..######");               // a left edge owns its samples
  EXPECT_EQ(columnsRightOf(2.5 + 1.0 / 512), "..######");   // 640.5 / 256 → 640
  EXPECT_EQ(columnsRightOf(2.5 + 1.0 / 256), "...#####");   // 641 / 256 is on the grid
  EXPECT_EQ(columnsRightOf(2.5 + 3.0 / 512), "...#####");   // 641.5 → 642
  EXPECT_EQ(columnsRightOf(2.5 - 1.0 / 512), "..######");   // 639.5 → 640
}

TEST(Direct3D11, TopAndLeftEdgesOwnTheirSamples) {
  const Scene scene = testing::sceneOf({{1.5, 1.5}, {4.5, 1.5}, {4.5, 4.5}, {1.5, 1.5}, {4.5, 4.5}, {1.5, 4.5}}, kExtent);
  EXPECT_EQ(drawn(scene), (std::vector<std::string>{"........", ".###....", ".###....", ".###....", "........", "........",
                                                    "........", "........"}));
}

TEST(Direct3D11, ALineDrawsThePixelsWhoseDiamondsItLeaves) {
  EXPECT_EQ(drawn(line(1.5, 2.5, 4.5, 2.5))[2], ".###....");    // it ends within the last pixel's diamond
  EXPECT_EQ(drawn(line(1.5, 2.5, 5.25, 2.5))[2], ".####...");
  EXPECT_EQ(drawn(line(4.5, 2.5, 1.5, 2.5))[2], "..###...");
}

TEST(Direct3D11, TheBottomCornerBelongsToTheDiamond) {
  const std::vector<std::string> rows = drawn(line(1.5, 3, 4.5, 3));  // through bottom corners of row 2, top ones of row 3
  EXPECT_EQ(rows[2], ".###....");
  EXPECT_EQ(rows[3], "........");
}

TEST(Direct3D11, TheRightCornerBelongsToTheDiamondOfYMajorLines) {
  const std::vector<std::string> rows = drawn(line(3, 1.5, 3, 4.5));  // right corners of column 2, left ones of column 3
  for (const size_t y : {1U, 2U, 3U}) EXPECT_EQ(rows[y], "..#.....") << y;
  EXPECT_EQ(rows[4], "........");
}

TEST(Direct3D11, APointIsAPixelWideAndOwnsItsTopAndLeftBorder) {
  Scene scene = testing::sceneOf({{3.5, 3.5}, {6, 6}}, kExtent);
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  EXPECT_EQ(drawn(scene), (std::vector<std::string>{"........", "........", "........", "...#....", "........", ".....#..",
                                                    "........", "........"}));
}

TEST(Direct3D11, TheSquareOfAPointIsThatAroundTheSnappedVertex) {
  const auto columns = [](double x, std::string_view profile) {
    Scene scene = testing::sceneOf({{x, 3.5}}, kExtent);
    scene.state.topology = PrimitiveTopology::POINT_LIST;
    return drawn(scene, *Rules::profile(profile, Limits{}))[3];
  };
  // Unrounded, the square would begin 1/1024 pixel to the right of the centre of pixel 2.
  EXPECT_EQ(columns(3 + 1.0 / 1024, "reference"), "...#....");
  EXPECT_EQ(columns(3 + 1.0 / 1024, "d3d11"), "..#.....");
  EXPECT_EQ(columns(3 + 1.0 / 512, "d3d11"), "..#.....");   // 768.5 → 768, the even one
  EXPECT_EQ(columns(3 + 3.0 / 1024, "d3d11"), "...#....");  // 768.75 → 769
}

/// The depth of pixel (2, 2) under a triangle with these depths at its corners (0, 0), (8, 0) and (0, 8).
float depthOf(std::array<double, 3> z, DepthFormat format, float constant, float slope) {
  Scene scene = testing::sceneOf({{0, 0, z[0]}, {8, 0, z[1]}, {0, 8, z[2]}}, kExtent);
  scene.target.depthFormat = format;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = constant;
  scene.state.depthBiasSlopeFactor = slope;
  return render(scene, d3d11())->depth->at(2, 2, 0);
}

TEST(Direct3D11, TheSlopeIsTheLargerOfBothDirections) {
  // 1/16 per pixel in x and 1/32 in y; at (2.5, 2.5): 0.15625 + 0.078125. The gradient's length would give 0.0699.
  EXPECT_EQ(depthOf({0, 0.5, 0.25}, DepthFormat::D32_SFLOAT, 0, 1), 0.234375F + 0.0625F);
}

TEST(Direct3D11, AUnitOfAFloatDepthIsTheStepOfItsLargestExponent) {
  EXPECT_EQ(depthOf({0.5, 0.5, 0.5}, DepthFormat::D32_SFLOAT, 4, 0), 0.5F + 4 * 0x1p-24F);  // 2^(-1 - 23)
}

TEST(Direct3D11, AUnitOfAFixedPointDepthIsOneStep) {
  const auto stepsAt = [](float constant) {
    return std::lround(depthOf({0.25, 0.25, 0.25}, DepthFormat::D16_UNORM, constant, 0) * 65535);
  };
  EXPECT_EQ(stepsAt(0), 16384);  // 16383.75
  EXPECT_EQ(stepsAt(3), 16387);
}

TEST(Direct3D11, LinesHaveNoDepthBias) {
  Scene scene = testing::sceneOf({{0.5, 2.5, 0.5}, {7.5, 2.5, 0.5}}, kExtent);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = 1000;
  EXPECT_EQ(render(scene, d3d11())->depth->at(2, 2, 0), 0.5F);
}

TEST(Direct3D11, TheCentroidOfAPartlyCoveredPixelIsItsFirstCoveredSample) {
  // Left of x = 2.5 lie samples 0 (6/16) and 2 (2/16) of pixel 2, right of it 1 (14/16) and 3 (10/16). The value is x.
  const auto centroidAt = [](double left, double right) {
    Scene scene = testing::sceneOf({{left, 0}, {right, 0}, {right, 8}, {left, 0}, {right, 8}, {left, 8}}, kExtent, 4);
    Varying x{.name = "x", .interpolation = Interpolation::centroid, .components = 1};
    for (const double v : {left, right, right, left, right, left}) x.values.push_back(static_cast<float>(v));
    scene.draws.front().varyings.push_back(x);
    const Frame frame = *render(scene, d3d11());
    return std::pair(frame.varyings[0].values.at(2, 2, left > 2 ? 1 : 0), frame.varyings[0].values.at(3, 2, 0));
  };
  EXPECT_FLOAT_EQ(centroidAt(0, 2.5).first, 2.375F);
  EXPECT_FLOAT_EQ(centroidAt(2.5, 8).first, 2.875F);
  EXPECT_FLOAT_EQ(centroidAt(2.5, 8).second, 3.5F);  // wholly covered: the centre
}

}  // namespace
}  // namespace rasterdiff::rasterizer
