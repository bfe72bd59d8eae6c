// Which side of a polygon is seen, where legal snapping decides it, and what of its outline has to be drawn then.
#include "rasterizer/facing_freedom.hpp"

#include <gtest/gtest.h>

#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

std::vector<RasterVertex> polygon(std::initializer_list<SubpixelPosition> corners, int32_t reach) {
  std::vector<RasterVertex> vertices;
  for (const SubpixelPosition& corner : corners) {
    RasterVertex vertex;
    vertex.snapped = corner;
    vertex.lowest = {corner.x - reach, corner.y - reach};
    vertex.highest = {corner.x + reach, corner.y + reach};
    vertices.push_back(vertex);
  }
  return vertices;
}

TEST(FacingFreedom, ACornerThatMayCrossTheOppositeEdgeLeavesTheSideFree) {
  EXPECT_TRUE(areaBand(polygon({{0, 0}, {2560, 0}, {1280, 1}}, 1)).sideIsFree());
  EXPECT_TRUE(areaBand(polygon({{0, 0}, {2560, 0}, {1280, 0}}, 1)).sideIsFree());
}

TEST(FacingFreedom, ACornerFarFromTheOppositeEdgeDoesNot) {
  const AreaBand band = areaBand(polygon({{0, 0}, {2560, 0}, {1280, 256}}, 1));
  EXPECT_EQ(band.area, 2560 * 256);
  EXPECT_TRUE(band.signIsCertain());
  EXPECT_FALSE(band.sideIsFree());
}

TEST(FacingFreedom, WhereEveryCornerHasOnePlaceNothingIsFree) {
  const AreaBand band = areaBand(polygon({{0, 0}, {2560, 0}, {1280, 0}}, 0));
  EXPECT_EQ(band.area, 0);
  EXPECT_FALSE(band.sideIsFree());
}

// The corner in the middle is `height` pixels below the line between the other two, which are off every grid.
Scene outline(PolygonMode mode, CullMode cull, double height) {
  Scene scene = testing::sceneOf({{1.3007, 4.3007}, {7.3007, 4.3007}, {4.3007, 4.3007 + height}});
  scene.state.polygonMode = mode;
  scene.state.cullMode = cull;
  return scene;
}

// Of the first corner.
std::vector<Candidate> atCorner(const Scene& scene) {
  const SampleQuery query{1, 4, 0};
  return candidates(scene, Rules::specification(Limits{}), {&query, 1})->front();
}

TEST(FacingFreedom, CornersOfAFlatTriangleMayBeCulledOrNot) {
  for (const CullMode cull : {CullMode::FRONT, CullMode::BACK}) {
    const std::vector<Candidate> found = atCorner(outline(PolygonMode::POINT, cull, 0.0005));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].coverage, Coverage::Either);
    EXPECT_EQ(found[0].freedom, Freedom::NearZeroArea);
  }
}

TEST(FacingFreedom, WithoutCullingTheCornersOfAFlatTriangleAreDrawn) {
  const std::vector<Candidate> found = atCorner(outline(PolygonMode::POINT, CullMode::NONE, 0.0005));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].coverage, Coverage::In);
}

TEST(FacingFreedom, CornersOfATriangleWithAreaAreCulledByOneSideOnly) {
  const std::vector<Candidate> front = atCorner(outline(PolygonMode::POINT, CullMode::FRONT, 2));
  const std::vector<Candidate> back = atCorner(outline(PolygonMode::POINT, CullMode::BACK, 2));
  ASSERT_EQ(front.size() + back.size(), 1U);
  EXPECT_EQ((front.empty() ? back : front)[0].coverage, Coverage::In);
}

TEST(FacingFreedom, EdgesOfAFlatTriangleMayAllBeMissing) {
  for (const CullMode cull : {CullMode::FRONT, CullMode::BACK}) {
    const Scene scene = outline(PolygonMode::LINE, cull, 0.0005);
    const Result<Frame> frame = render(scene, Rules::specification(Limits{}));
    ASSERT_TRUE(frame && frame->coverage);
    size_t possible = 0;
    for (const Coverage coverage : frame->coverage->data) {
      EXPECT_NE(coverage, Coverage::In);
      possible += coverage == Coverage::Either ? 1 : 0;
    }
    EXPECT_GE(possible, 6U);  // the pixels that the line passes
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
