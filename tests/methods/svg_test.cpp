// SVG polygons, drawn as scenes: they cover what the winding number says.
#include <gtest/gtest.h>

#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/polygon_methods.hpp"
#include "rasterizer/render.hpp"
#include "scene/polygon/polygon_draw.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// The lecture's example, line break included.
constexpr std::string_view kLecture =
    "<polygon fill=\"#ED18ED\"\npoints=\"464.781,631.819 478.417,309.091 471.599,642.045 \"/>";

Result<Scene> sceneOf(const SvgPolygon& polygon, uint32_t width, uint32_t height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.viewport.width = static_cast<float>(width);
  scene.viewport.height = static_cast<float>(height);
  Result<Draw> draw = polygonDraw({&polygon, 1}, scene.viewport, 0.5, {});
  if (!draw) return tl::unexpected(draw.error());
  scene.draws.push_back(std::move(*draw));
  return scene;
}

TEST(SvgPolygon, TheLecturesExampleDrawnAsASceneCoversWhatTheScanlineCovers) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(kLecture, "lecture.svg");
  ASSERT_TRUE(polygons.has_value());
  const Result<Scene> scene = sceneOf(polygons->front(), 1024, 768);
  ASSERT_TRUE(scene.has_value()) << scene.error().what;
  const Result<Frame> frame = render(*scene, testing::referenceRules());
  ASSERT_TRUE(frame.has_value());
  const Result<PixelMask> mask = drawPolygonScanline(polygons->front().polygon, FillRule::NonZero, 1024, 768);
  uint64_t covered = 0;
  for (uint32_t y = 0; y < 768; ++y) {
    for (uint32_t x = 0; x < 1024; ++x) {
      const uint8_t expected = mask->at(static_cast<int32_t>(x), static_cast<int32_t>(y));
      ASSERT_EQ(frame->count.at(x, y, 0), expected) << x << ", " << y;
      covered += expected;
    }
  }
  EXPECT_EQ(covered, 1172u);  // the triangle has an area of 1169.9 pixels
}

TEST(SvgPolygon, ScenesOfConcavePolygonsCoverEverySampleOnce) {
  Prng prng(4);
  for (int i = 0; i < 200; ++i) {
    const SvgPolygon polygon{concavePolygon(prng), FillRule::NonZero};
    const Result<Scene> scene = sceneOf(polygon, kInputExtent, kInputExtent);
    ASSERT_TRUE(scene.has_value()) << scene.error().what;
    const Result<Frame> frame = render(*scene, testing::referenceRules());
    const PixelMask exact = drawPolygonByWinding(polygon.polygon, FillRule::NonZero, kInputExtent, kInputExtent);
    for (size_t k = 0; k < exact.covered.size(); ++k) ASSERT_EQ(frame->count.data[k], exact.covered[k]);
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
