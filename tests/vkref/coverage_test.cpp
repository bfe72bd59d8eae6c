// Which samples a driver covers, who owns them and how often they were written, read back sample by sample.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

using rasterdiff::testing::textCounts;
using rasterdiff::testing::textMask;

class DriverCoverage : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverCoverage);

// No sample lies on an edge and vertices are on the 1/16 grid, so every driver has to give this mask.
constexpr const char* kTriangleMask =
    "........\n"
    ".#####..\n"
    ".####...\n"
    ".###....\n"
    ".##.....\n"
    ".#......\n"
    "........\n"
    "........\n";

std::vector<Point> triangle() { return {{1.25F, 1.25F}, {6.75F, 1.25F}, {1.25F, 6.5F}}; }

TEST_P(DriverCoverage, TriangleHasTheMaskOfItsInterior) {
  const Frame frame = draw(sceneOf(triangle()));
  EXPECT_EQ(textMask(frame), kTriangleMask);
  EXPECT_EQ(textCounts(frame).find_first_not_of(".1\n"), std::string::npos);
}

TEST_P(DriverCoverage, NegativeViewportHeightFlipsTheMask) {
  Scene scene = sceneOf(triangle());
  scene.viewport = {0, 8, 8, -8, 0, 1};
  EXPECT_EQ(textMask(draw(scene)),
            "........\n"
            "........\n"
            ".#......\n"
            ".##.....\n"
            ".###....\n"
            ".####...\n"
            ".#####..\n"
            "........\n");
}

TEST_P(DriverCoverage, FractionalViewportOriginMovesTheTriangle) {
  Scene scene = sceneOf({{0, 0}, {4, 0}, {4, 4}, {0, 0}, {4, 4}, {0, 4}});
  scene.viewport = {0.75F, 0.25F, 8, 8, 0, 1};  // the square is then 0.75..4.75 × 0.25..4.25
  EXPECT_EQ(textMask(draw(scene)),
            ".####...\n"
            ".####...\n"
            ".####...\n"
            ".####...\n"
            "........\n"
            "........\n"
            "........\n"
            "........\n");
}

TEST_P(DriverCoverage, ScissorCutsTheMask) {
  Scene scene = sceneOf(wholeTarget());
  scene.scissor = Rect2D{2, 1, 3, 100};
  EXPECT_EQ(textMask(draw(scene)),
            "........\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "..###...\n");
}

TEST_P(DriverCoverage, CullingRemovesTheFaceThatTheStateNames) {
  Scene scene = sceneOf(triangle());  // clockwise on screen
  scene.state.frontFace = FrontFace::CLOCKWISE;
  scene.state.cullMode = CullMode::BACK;
  EXPECT_EQ(textMask(draw(scene)), kTriangleMask);
  scene.state.cullMode = CullMode::FRONT;
  EXPECT_EQ(textMask(draw(scene)).find('#'), std::string::npos);
  scene.state.frontFace = FrontFace::COUNTER_CLOCKWISE;
  EXPECT_EQ(textMask(draw(scene)), kTriangleMask);
  scene.state.cullMode = CullMode::FRONT_AND_BACK;
  EXPECT_EQ(textMask(draw(scene)).find('#'), std::string::npos);
}

TEST_P(DriverCoverage, LaterDrawsNumberOnAndReplaceEarlierOnes) {
  Scene scene = sceneOf({{0, 0}, {16, 0}, {0, 16}, {0, 0}, {4, 0}, {0, 4}}, 4, 4);
  const Scene second = sceneOf({{2, 0}, {10, 0}, {2, 8}}, 4, 4);
  scene.draws.push_back(second.draws.front());
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.primitive.at(3, 3, 0), 3U);  // the second draw's first triangle
  EXPECT_EQ(frame.count.at(3, 3, 0), 2U);
  EXPECT_EQ(frame.primitive.at(0, 0, 0), 2U);
  EXPECT_EQ(frame.count.at(0, 0, 0), 2U);
  EXPECT_EQ(frame.primitive.at(0, 3, 0), 1U);
  EXPECT_EQ(frame.count.at(0, 3, 0), 1U);
}

TEST_P(DriverCoverage, OverdrawIsCountedExactlyBeyondAByte) {
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) {
    for (const Point& p : wholeTarget()) points.push_back(p);
  }
  const Frame frame = draw(sceneOf(points, 8, 8, 4));
  for (uint32_t count : frame.count.data) ASSERT_EQ(count, 1000U);
  for (uint32_t primitive : frame.primitive.data) ASSERT_EQ(primitive, 1000U);
}

TEST_P(DriverCoverage, FourSamplesLieAtTheStandardLocations) {
  // [vk:primsrast-multisampling] in 1/16 pixel: (6, 2) (14, 6) (2, 10) (10, 14)
  const float locations[4][2] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
  for (uint32_t s = 0; s < 4; ++s) {
    const float x = 2 + locations[s][0] / 16, y = 1 + locations[s][1] / 16;
    const float step = 1.0F / 16;  // the triangle's corners are on the grid, its interior holds the location
    const std::vector<Point> around = {{x - step, y - step}, {x + 2 * step, y - step}, {x - step, y + 2 * step}};
    const Frame frame = draw(sceneOf(around, 4, 4, 4));
    for (uint32_t other = 0; other < 4; ++other) {
      EXPECT_EQ(frame.primitive.at(2, 1, other), other == s ? 1U : 0U) << "sample " << s << ", read " << other;
      EXPECT_EQ(frame.count.at(2, 1, other), other == s ? 1U : 0U);
    }
  }
}

TEST_P(DriverCoverage, OddTargetsReadBackEverySample) {
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = sceneOf(wholeTarget(64, 64), 64, 64, samples);
    scene.target.width = 67;
    scene.target.height = 13;
    scene.viewport = {0, 0, 67, 13, 0, 1};
    const Frame frame = draw(scene);
    ASSERT_EQ(frame.primitive.data.size(), size_t{67} * 13 * samples);
    for (uint32_t primitive : frame.primitive.data) ASSERT_EQ(primitive, 1U);
  }
}

TEST_P(DriverCoverage, ASceneThatDrawsNothingIsEmpty) {
  Scene incomplete = sceneOf({{0, 0}, {16, 0}});
  Scene noIndices = sceneOf(wholeTarget());
  noIndices.draws.front().indices.emplace();
  for (const Scene& scene : {incomplete, noIndices}) {
    const Frame frame = draw(scene);
    EXPECT_EQ(textMask(frame).find('#'), std::string::npos);
    EXPECT_EQ(frame.count.at(0, 0, 0), 0U);
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
