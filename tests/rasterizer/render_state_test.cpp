// Pipeline state in the reference: viewport, culling, scissor, depth, topologies, order; small masks as text.
#include <gtest/gtest.h>

#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/text_mask.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Point;

Frame draw(const Scene& scene) { return render(scene, testing::referenceRules()).value(); }  // throws on an error
std::string mask(const Scene& scene) { return testing::textMask(draw(scene)); }

// Clockwise on the screen (y points down): Vulkan's area is negative.
const std::vector<Point> kClockwise{{1, 1}, {6, 1}, {1, 6}};
const std::vector<Point> kCounterClockwise{{1, 1}, {1, 6}, {6, 1}};
const char* const kCorner =
    "........\n"
    ".####...\n"
    ".###....\n"
    ".##.....\n"
    ".#......\n"
    "........\n"
    "........\n"
    "........\n";
const char* const kEmpty = "........\n........\n........\n........\n........\n........\n........\n........\n";

TEST(RenderCulling, FollowsTheTableOfModesAndFrontFaces) {
  for (const bool clockwise : {true, false}) {
    for (const FrontFace face : {FrontFace::CLOCKWISE, FrontFace::COUNTER_CLOCKWISE}) {
      for (const CullMode mode : {CullMode::NONE, CullMode::FRONT, CullMode::BACK, CullMode::FRONT_AND_BACK}) {
        Scene scene = testing::sceneOf(clockwise ? kClockwise : kCounterClockwise, 8);
        scene.state.frontFace = face;
        scene.state.cullMode = mode;
        const bool front = clockwise == (face == FrontFace::CLOCKWISE);
        const bool drawn = mode == CullMode::NONE || (mode == CullMode::FRONT && !front) || (mode == CullMode::BACK && front);
        EXPECT_EQ(mask(scene), drawn ? kCorner : kEmpty) << clockwise << static_cast<int>(face) << static_cast<int>(mode);
      }
    }
  }
}

TEST(RenderViewport, NegativeHeightFlipsThePictureAndTheWinding) {
  Scene scene = testing::sceneOf(kClockwise, 8);
  scene.viewport.y = 8;
  scene.viewport.height = -8;
  EXPECT_EQ(mask(scene),
            "........\n"
            "........\n"
            "........\n"
            ".#......\n"
            ".##.....\n"
            ".###....\n"
            ".####...\n"
            "........\n");
  scene.state.cullMode = CullMode::BACK;  // counter-clockwise is front: the flip makes it so
  EXPECT_NE(mask(scene), kEmpty);
  scene.state.cullMode = CullMode::FRONT;
  EXPECT_EQ(mask(scene), kEmpty);
}

TEST(RenderViewport, OffsetsAndFractionsMoveThePicture) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {8, 8}, {0, 0}, {8, 8}, {0, 8}}, 8);
  scene.viewport = {2.5F, 1.25F, 3, 4, 0, 1};
  // Columns 2.5 .. 5.5: centre 2.5 is on the left edge (owned), 5.5 on the right one (not). Rows 1.25 .. 5.25.
  EXPECT_EQ(mask(scene),
            "........\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "..###...\n"
            "........\n"
            "........\n"
            "........\n");
}

TEST(RenderViewport, ClipsToItsOwnRectangleNotToTheTarget) {
  Scene scene = testing::sceneOf({{-20, -20}, {40, -20}, {-20, 40}}, 8);
  scene.viewport = {2, 3, 4, 2, 0, 1};
  EXPECT_EQ(mask(scene), "........\n........\n........\n..####..\n..####..\n........\n........\n........\n");
}

TEST(RenderScissor, KeepsLeftAndTopAndDropsRightAndBottom) {
  Scene scene = testing::sceneOf({{-20, -20}, {40, -20}, {-20, 40}}, 8);
  scene.scissor = Rect2D{1, 2, 3, 4};
  EXPECT_EQ(mask(scene), "........\n........\n.###....\n.###....\n.###....\n.###....\n........\n........\n");
  scene.scissor = Rect2D{6, 7, 100, 100};
  EXPECT_EQ(mask(scene), "........\n........\n........\n........\n........\n........\n........\n......##\n");
  scene.scissor = Rect2D{8, 0, 5, 8};
  EXPECT_EQ(mask(scene), kEmpty);
}

TEST(RenderScissor, OfSizeZeroIsRefused) {
  Scene scene = testing::sceneOf(kClockwise, 8);
  scene.scissor = Rect2D{3, 3, 0, 5};
  EXPECT_EQ(render(scene, testing::referenceRules()).error().where, "scissor.width");
}

TEST(RenderTopology, StripAndFanMakeTheirTriangles) {
  Scene strip = testing::sceneOf({{1, 1}, {1, 5}, {3, 1}, {3, 5}, {5, 1}, {5, 5}}, 8);
  strip.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
  strip.state.cullMode = CullMode::FRONT;  // all of it is counter-clockwise, as its first triangle
  EXPECT_EQ(mask(strip), kEmpty);
  strip.state.cullMode = CullMode::BACK;
  EXPECT_EQ(testing::textCounts(draw(strip)), "........\n.1111...\n.1111...\n.1111...\n.1111...\n........\n........\n........\n");
  Scene fan = testing::sceneOf({{1, 1}, {5, 1}, {5, 5}, {1, 5}}, 8);
  fan.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  const Frame frame = draw(fan);
  EXPECT_EQ(testing::textCounts(frame), "........\n.1111...\n.1111...\n.1111...\n.1111...\n........\n........\n........\n");
  EXPECT_EQ(frame.primitive.at(4, 1, 0), 1U);
  EXPECT_EQ(frame.primitive.at(1, 4, 0), 2U);
}

TEST(RenderOrder, LaterPrimitivesWinAndAllAreCounted) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}, {0, 0}, {4, 0}, {0, 4}}, 8);
  Draw second;
  for (const Point& p : {Point{0, 0}, Point{2, 0}, Point{0, 2}}) second.positions.push_back(testing::fromPixels(p, 8));
  scene.draws.push_back(second);
  const Frame frame = draw(scene);
  EXPECT_EQ(testing::textCounts(frame).substr(0, 9), "3221111.\n");
  EXPECT_EQ(frame.primitive.at(0, 0, 0), 3U) << "numbers go on over the draws";
  EXPECT_EQ(frame.primitive.at(2, 0, 0), 2U);
  EXPECT_EQ(frame.primitive.at(4, 0, 0), 1U);
  EXPECT_EQ(frame.primitive.at(7, 7, 0), 0U);
}

Scene twoLayers(CompareOp op, float near, float far) {
  Scene scene = testing::sceneOf({{0, 0, far}, {16, 0, far}, {0, 16, far}, {0, 0, near}, {16, 0, near}, {0, 16, near}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.target.depthClearValue = 0.5F;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = op;
  return scene;
}

struct DepthCase {
  CompareOp op;
  uint32_t winner, count;
  float stored;
};

// The clear value is 0.5, the first layer lies at 0.75, the second at 0.25.
TEST(RenderDepth, EveryComparisonDecidesTwoLayers) {
  for (const DepthCase& c : {DepthCase{CompareOp::NEVER, 0, 0, 0.5F}, DepthCase{CompareOp::LESS, 2, 1, 0.25F},
                             DepthCase{CompareOp::EQUAL, 0, 0, 0.5F}, DepthCase{CompareOp::LESS_OR_EQUAL, 2, 1, 0.25F},
                             DepthCase{CompareOp::GREATER, 1, 1, 0.75F}, DepthCase{CompareOp::NOT_EQUAL, 2, 2, 0.25F},
                             DepthCase{CompareOp::GREATER_OR_EQUAL, 1, 1, 0.75F}, DepthCase{CompareOp::ALWAYS, 2, 2, 0.25F}}) {
    const Frame frame = draw(twoLayers(c.op, 0.25F, 0.75F));
    EXPECT_EQ(frame.primitive.at(3, 3, 0), c.winner) << static_cast<int>(c.op);
    EXPECT_EQ(frame.count.at(3, 3, 0), c.count) << static_cast<int>(c.op);
    EXPECT_EQ(frame.depth->at(3, 3, 0), c.stored) << static_cast<int>(c.op);
  }
}

TEST(RenderDepth, WithoutWriteBothLayersMeetTheClearValue) {
  Scene scene = twoLayers(CompareOp::LESS, 0.375F, 0.25F);
  scene.state.depthWriteEnable = false;
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.count.at(3, 3, 0), 2U);
  EXPECT_EQ(frame.depth->at(3, 3, 0), 0.5F);
}

TEST(RenderDepth, WithoutTestNothingIsWritten) {
  Scene scene = twoLayers(CompareOp::LESS, 0.25F, 0.75F);
  scene.state.depthTestEnable = false;
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.count.at(3, 3, 0), 2U);
  EXPECT_EQ(frame.depth->at(3, 3, 0), 0.5F);
}

TEST(RenderDepth, IsEvaluatedAtEachSample) {
  Scene scene = testing::sceneOf({{0, 0, 0}, {16, 0, 1}, {0, 16, 0}}, 8, 4);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  const Frame frame = draw(scene);
  const double xs[4] = {6, 14, 2, 10};
  for (uint32_t s = 0; s < 4; ++s) EXPECT_EQ(frame.depth->at(3, 4, s), static_cast<float>((3 + xs[s] / 16) / 16));
}

TEST(RenderClipping, ATriangleBehindAndInFrontOfTheEyeShowsItsFrontPart) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {4, 4}}, 8);
  // The third vertex is behind the eye: what is visible opens away from the edge between the first two.
  scene.draws[0].positions = {{-0.5F, 0.0F, 0.5F, 1}, {0.5F, 0.0F, 0.5F, 1}, {0, -1, 0.5F, -1}};
  EXPECT_EQ(mask(scene).substr(4 * 9), "........\n........\n........\n........\n");
  EXPECT_EQ(mask(scene).substr(3 * 9, 8), "..####..");
}

TEST(RenderErrors, AnInvalidSceneIsRefusedWithItsField) {
  Scene scene = testing::sceneOf(kClockwise, 8);
  scene.draws[0].indices = std::vector<uint32_t>{0, 1, 9};
  const Result<Frame> frame = render(scene, testing::referenceRules());
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::BadInput);
  EXPECT_EQ(frame.error().where, "draws[0].indices[2]");
}

}  // namespace
}  // namespace rasterdiff::rasterizer
