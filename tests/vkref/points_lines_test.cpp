// Points and lines: masks, numbers, sizes and flat values that every driver has to agree on.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

using rasterdiff::testing::textMask;

class DriverPoints : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverPoints);
class DriverLines : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverLines);

Scene withTopology(PrimitiveTopology topology, const std::vector<Point>& points, uint32_t samples = 1) {
  Scene scene = sceneOf(points, 8, 8, samples);
  scene.state.topology = topology;
  return scene;
}

TEST_P(DriverPoints, PointOfSizeOneIsThePixelAroundIt) {
  const Scene scene = withTopology(PrimitiveTopology::POINT_LIST, {{2.5F, 1.5F}, {6.5F, 4.5F}, {0.5F, 7.5F}});
  EXPECT_EQ(textPrimitives(draw(scene)),
            "........\n"
            "..1.....\n"
            "........\n"
            "........\n"
            "......2.\n"
            "........\n"
            "........\n"
            "3.......\n");
}

// [vk:invariance-repeatability] a scene is drawn alike whatever was drawn before it.
TEST_P(DriverPoints, PointsOutsideOfASideAreDrawnAlikeAfterScenesWithAndWithoutViewports) {
  Scene outside = withTopology(PrimitiveTopology::POINT_LIST, {{-2, 4}, {4, 4}});
  outside.state.pointSize = 7;
  Scene viewports = outside;
  viewports.furtherViewports = {{viewports.viewport}};
  const Result<std::unique_ptr<Device>> fresh = openDevice({GetParam(), /*validate=*/true, /*timeoutSeconds=*/60});
  ASSERT_TRUE(fresh.has_value());
  const Result<Frame> first = render(viewports, **fresh);
  ASSERT_TRUE(first.has_value());
  const std::string one = textPrimitives(draw(outside)), several = textPrimitives(*first);
  EXPECT_EQ(textPrimitives(draw(viewports)), several) << "after a scene of one viewport, and as the first of all";
  EXPECT_EQ(textPrimitives(draw(outside)), one) << "after a scene of several viewports";
  EXPECT_EQ(textPrimitives(draw(viewports)), several);
}

TEST_P(DriverPoints, SizesComeFromTheVerticesOrFromTheState) {
  Scene scene = withTopology(PrimitiveTopology::POINT_LIST, {{1.5F, 2.5F}, {6, 2}, {4.5F, 6.5F}});
  scene.draws.front().pointSizes = {3, 2, 1};
  std::optional<Frame> frame = drawIf(caps().core().largePoints, scene, "draws[0].pointSizes");
  if (frame) {
    EXPECT_EQ(textPrimitives(*frame),
              "........\n"
              "111..22.\n"
              "111..22.\n"
              "111.....\n"
              "........\n"
              "........\n"
              "....3...\n"
              "........\n");
  }
  scene = withTopology(PrimitiveTopology::POINT_LIST, {{4, 4}});
  scene.state.pointSize = 4;
  frame = drawIf(caps().core().largePoints, scene, "state.pointSize");
  if (frame) {
    EXPECT_EQ(textMask(*frame),
              "........\n"
              "........\n"
              "..####..\n"
              "..####..\n"
              "..####..\n"
              "..####..\n"
              "........\n"
              "........\n");
  }
}

TEST_P(DriverPoints, PointsAreCoveredSampleBySample) {
  // A point of size 1 around (2, 2.5) covers x in 1.5..2.5: samples 1 and 3 of pixel 1, samples 0 and 2 of pixel 2.
  const Frame frame = draw(withTopology(PrimitiveTopology::POINT_LIST, {{2, 2.5F}}, 4));
  for (uint32_t s = 0; s < 4; ++s) {
    EXPECT_EQ(frame.primitive.at(1, 2, s), s == 1 || s == 3 ? 1U : 0U) << s;
    EXPECT_EQ(frame.primitive.at(2, 2, s), s == 0 || s == 2 ? 1U : 0U) << s;
  }
}

TEST_P(DriverPoints, IndexedPointsOfSeveralDrawsNumberOn) {
  Scene scene = withTopology(PrimitiveTopology::POINT_LIST, {{1.5F, 1.5F}, {3.5F, 1.5F}, {5.5F, 1.5F}});
  scene.draws.front().varyings = {vertexNumbers(3)};
  scene.draws.front().indices = {{2, 0}};
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().indices = {{1}};
  const Frame frame = draw(scene);
  const uint32_t expected[3][3] = {{5, 1, 2}, {1, 2, 0}, {3, 3, 1}};  // x, primitive, vertex
  for (const auto& [x, primitive, vertex] : expected) {
    EXPECT_EQ(frame.primitive.at(x, 1, 0), primitive);
    EXPECT_EQ(frame.varyings[0].values.at(x, 1, 0), static_cast<float>(vertex));
  }
}

TEST_P(DriverLines, HorizontalAndVerticalLinesAreOnePixelWide) {
  const Scene scene = withTopology(PrimitiveTopology::LINE_LIST, {{1, 2.5F}, {6, 2.5F}, {7.5F, 1}, {7.5F, 7}});
  EXPECT_EQ(textPrimitives(draw(scene)),
            "........\n"
            ".......2\n"
            ".11111.2\n"
            ".......2\n"
            ".......2\n"
            ".......2\n"
            ".......2\n"
            "........\n");
}

TEST_P(DriverLines, AStripNumbersItsLinesInOrder) {
  const Scene scene =
      withTopology(PrimitiveTopology::LINE_STRIP, {{0.5F, 1.5F}, {6.5F, 1.5F}, {6.5F, 6.5F}, {0.5F, 6.5F}});
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.primitive.at(3, 1, 0), 1U);
  EXPECT_EQ(frame.primitive.at(6, 4, 0), 2U);
  EXPECT_EQ(frame.primitive.at(3, 6, 0), 3U);
  EXPECT_EQ(frame.primitive.at(3, 4, 0), 0U);
}

TEST_P(DriverLines, FlatValuesComeFromTheProvokingVertex) {
  for (const auto topology : {PrimitiveTopology::LINE_LIST, PrimitiveTopology::LINE_STRIP}) {
    for (const auto mode : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
      for (const bool indexed : {false, true}) {
        Scene scene = withTopology(topology, {{0.5F, 1.5F}, {6.5F, 1.5F}, {6.5F, 6.5F}, {0.5F, 6.5F}});
        scene.state.provokingVertexMode = mode;
        Draw& lines = scene.draws.front();
        if (indexed) lines.indices = {{3, 2, 1, 0}};
        lines.varyings = {vertexNumbers(4)};
        const Frame frame = draw(scene);
        uint32_t covered = 0;
        for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
          if (frame.primitive.data[i] == 0) continue;
          ++covered;
          const uint32_t primitive = frame.primitive.data[i] - 1;
          const uint32_t first = topology == PrimitiveTopology::LINE_LIST ? 2 * primitive : primitive;
          const uint32_t position = first + (mode == ProvokingVertexMode::LAST_VERTEX ? 1 : 0);
          ASSERT_EQ(frame.varyings[0].values.data[i], static_cast<float>(indexed ? 3 - position : position));
        }
        EXPECT_GE(covered, 10U);
      }
    }
  }
}

TEST_P(DriverLines, WideLinesAreAsWideAsTheStateSays) {
  Scene scene = withTopology(PrimitiveTopology::LINE_LIST, {{1, 3.5F}, {6, 3.5F}});
  scene.state.lineWidth = 3;
  const std::optional<Frame> frame = drawIf(caps().core().wideLines, scene, "state.lineWidth");
  if (!frame) return;
  EXPECT_EQ(textMask(*frame),
            "........\n"
            "........\n"
            ".#####..\n"
            ".#####..\n"
            ".#####..\n"
            "........\n"
            "........\n"
            "........\n");
}

TEST_P(DriverLines, RectangularLinesCoverSamplesAndBresenhamLinesWholePixels) {
  // y = 2.25: a rectangle of width 1 is 1.75..2.75; Bresenham lights the pixels of row 2.
  for (const auto mode : {LineRasterizationMode::RECTANGULAR, LineRasterizationMode::BRESENHAM}) {
    Scene scene = withTopology(PrimitiveTopology::LINE_LIST, {{1, 2.25F}, {6, 2.25F}}, 4);
    scene.state.lineRasterizationMode = mode;
    const bool rectangular = mode == LineRasterizationMode::RECTANGULAR;
    const Limits& limits = device().limits();
    const std::optional<Frame> frame = drawIf(rectangular ? limits.rectangularLines : limits.bresenhamLines, scene,
                                              "state.lineRasterizationMode");
    if (!frame) continue;
    for (uint32_t s = 0; s < 4; ++s) {  // [vk:primsrast-multisampling] y of the samples: 2, 6, 10, 14 sixteenths
      EXPECT_EQ(frame->primitive.at(3, 2, s), !rectangular || s != 3 ? 1U : 0U) << "sample " << s;
      EXPECT_EQ(frame->primitive.at(3, 1, s), rectangular && s == 3 ? 1U : 0U) << "sample " << s;
    }
  }
}

TEST_P(DriverLines, SmoothLinesAreDrawnOrRefused) {
  Scene scene = withTopology(PrimitiveTopology::LINE_LIST, {{1, 2.5F}, {6, 2.5F}});
  scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR_SMOOTH;
  const std::optional<Frame> frame =
      drawIf(device().limits().smoothLines, scene, "state.lineRasterizationMode");
  if (!frame) return;
  EXPECT_EQ(frame->primitive.at(3, 2, 0), 1U);
}

TEST_P(DriverLines, StippleKeepsThePixelsOfItsBits) {
  for (const auto mode : {LineRasterizationMode::DEFAULT, LineRasterizationMode::RECTANGULAR,
                          LineRasterizationMode::BRESENHAM}) {
    Scene scene = sceneOf({{0, 1.5F}, {16, 1.5F}, {0, 3.5F}, {16, 3.5F}}, 16, 8);
    scene.state.topology = PrimitiveTopology::LINE_LIST;
    scene.state.lineRasterizationMode = mode;
    scene.state.stippledLineEnable = true;
    scene.state.lineStipplePattern = 0x0F05;
    const Limits& limits = device().limits();
    const bool offered = mode == LineRasterizationMode::BRESENHAM ? limits.stippledBresenhamLines
                                                                  : limits.stippledRectangularLines;
    std::optional<Frame> frame = drawIf(offered, scene, "state.stippledLineEnable");
    if (!frame) continue;
    const std::string row = "#.#.....####....";  // [vk:primsrast-lines-stipple] bit 0 first, anew for each line of a list
    EXPECT_EQ(textMask(*frame).substr(17, 16), row);
    EXPECT_EQ(textMask(*frame).substr(3 * 17, 16), row);
    scene.state.lineStippleFactor = 2;
    frame = draw(scene);
    EXPECT_EQ(textMask(*frame).substr(17, 16), "##..##..........");
  }
}

TEST_P(DriverLines, BresenhamLinesExcludeSampleShading) {
  Scene scene = withTopology(PrimitiveTopology::LINE_LIST, {{1, 2.5F}, {6, 2.5F}}, 4);
  scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
  scene.state.sampleShadingEnable = true;
  EXPECT_FALSE(drawIf(false, scene, "state.lineRasterizationMode").has_value());
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
