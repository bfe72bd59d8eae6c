// What a draw may write: the scissor's rectangle, and what one profile makes of it. [choice:drawing-region]
#include <gtest/gtest.h>

#include "rasterizer/drawing_region.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene sceneWith(const Viewport& viewport, uint32_t samples = 1) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 128);
  scene.target.samples = samples;
  scene.viewport = viewport;
  return scene;
}

Rules roundedViewport() {
  Rules rules = testing::referenceRules();
  rules.choices.drawingRegion = DrawingRegionRule::RoundedViewport;
  return rules;
}

void expectArea(const PixelArea& area, int32_t left, int32_t top, int32_t right, int32_t bottom) {
  EXPECT_EQ(area.left, left);
  EXPECT_EQ(area.top, top);
  EXPECT_EQ(area.right, right);
  EXPECT_EQ(area.bottom, bottom);
}

TEST(DrawingRegion, IsNotCutByTheViewport) {
  expectArea(drawingRegion(sceneWith({8, 8, 16, 16}), 0, testing::referenceRules()).area, 0, 0, 128, 128);
}

TEST(DrawingRegion, RoundedViewportKeepsPixelsWithTheirCentreInside) {
  expectArea(drawingRegion(sceneWith({8, 8, 16, 16}), 0, roundedViewport()).area, 8, 8, 24, 24);
  expectArea(drawingRegion(sceneWith({8.25F, 8.75F, 16.5F, 16}), 0, roundedViewport()).area, 8, 9, 25, 25);
  expectArea(drawingRegion(sceneWith({8.25F, 24.75F, 16.5F, -16}), 0, roundedViewport()).area, 8, 9, 25, 25);
}

TEST(DrawingRegion, RoundedViewportOutsideOfTheTargetIsEmpty) {
  expectArea(drawingRegion(sceneWith({300, 8, 16, 16}), 0, roundedViewport()).area, 0, 0, 0, 0);
}

TEST(DrawingRegion, AtSeveralSamplesTheFarHalfOfThePixelBeforeLeaks) {
  const DrawingRegion region = drawingRegion(sceneWith({8, 8, 16, 16}, 4), 0, roundedViewport());
  const SampleArea reaching = region.of({2, 2, 20, 20}), inside = region.of({8, 8, 20, 20});
  EXPECT_TRUE(reaching.contains(7, 10, {160, 32}));
  EXPECT_FALSE(reaching.contains(7, 10, {96, 32}));
  EXPECT_FALSE(reaching.contains(6, 10, {224, 32}));
  EXPECT_TRUE(reaching.contains(10, 7, {32, 160}));
  EXPECT_FALSE(reaching.contains(10, 7, {32, 96}));
  EXPECT_TRUE(inside.contains(7, 10, {96, 32}));  // such a polygon has no sample there, and no border cuts it
}

TEST(DrawingRegion, BordersOfTilesDoNotLeak) {
  const DrawingRegion region = drawingRegion(sceneWith({64, 8, 16, 16}, 4), 0, roundedViewport());
  EXPECT_FALSE(region.of({2, 2, 70, 20}).contains(63, 10, {160, 32}));
}

TEST(DrawingRegion, APolygonBesideItDrawsNothing) {
  const DrawingRegion region = drawingRegion(sceneWith({8, 8, 16, 16}, 4), 0, roundedViewport());
  EXPECT_TRUE(region.of({2, 2, 7, 20}).columns(10, {224, 224}).empty());
}

}  // namespace
}  // namespace rasterdiff::rasterizer
