// Clip and cull distances of every count, and viewports that draws choose.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

using rasterdiff::testing::textMask;

class DriverDistances : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverDistances);
class DriverViewports : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverViewports);

/// Distance `own` of `count` at each vertex is values[vertex]; the others are 1.
std::vector<float> distances(uint32_t count, uint32_t own, const std::vector<float>& values) {
  std::vector<float> all;
  for (float value : values) {
    for (uint32_t d = 0; d < count; ++d) all.push_back(d == own ? value : 1);
  }
  return all;
}

constexpr const char* kRightHalf =
    "....####\n....####\n....####\n....####\n....####\n....####\n....####\n....####\n";

TEST_P(DriverDistances, EveryClipDistanceCutsWhereItTurnsNegative) {
  for (uint32_t count = 1; count <= 8; ++count) {
    for (uint32_t own = 0; own < count; ++own) {
      Scene scene = sceneOf(wholeTarget());  // x at the vertices: 0, 16, 0; the distance is x - 4
      scene.draws.front().clipDistanceCount = count;
      scene.draws.front().clipDistances = distances(count, own, {-4, 12, -4});
      EXPECT_EQ(textMask(draw(scene)), kRightHalf) << own << " of " << count;
    }
  }
}

TEST_P(DriverDistances, ACullDistanceDiscardsWhereItIsNegativeAtAllVertices) {
  for (uint32_t count = 1; count <= 8; ++count) {
    Scene scene = sceneOf(wholeTarget());
    scene.draws.front().cullDistanceCount = count;
    scene.draws.front().cullDistances = distances(count, count - 1, {-4, 12, -4});
    EXPECT_EQ(draw(scene).primitive.at(0, 0, 0), 1U) << count;  // not negative at all of them
    scene.draws.front().cullDistances = distances(count, count - 1, {-4, -1, -4});
    EXPECT_EQ(draw(scene).primitive.at(0, 0, 0), 0U) << count;
  }
}

TEST_P(DriverDistances, BothKindsWorkTogetherWithPointsLinesAndVaryings) {
  for (const auto topology :
       {PrimitiveTopology::POINT_LIST, PrimitiveTopology::LINE_LIST, PrimitiveTopology::TRIANGLE_LIST}) {
    Scene scene = sceneOf({{0, 2.5F}, {16, 2.5F}, {0, 16}, {2.5F, 5.5F}, {2.5F, 0}, {6.5F, 6.5F}});
    scene.state.topology = topology;
    Draw& draw1 = scene.draws.front();
    draw1.varyings = {constantVarying("a", 6, {1, 2, 3}), constantVarying("b", 6, {4})};
    draw1.clipDistanceCount = draw1.cullDistanceCount = 4;
    draw1.clipDistances = distances(4, 2, {-4, 12, -4, -1.5F, -1.5F, 2.5F});
    draw1.cullDistances = distances(4, 3, {1, 1, 1, 1, 1, 1});
    const Frame frame = draw(scene);
    uint32_t covered = 0;
    for (uint32_t y = 0; y < 8; ++y) {
      for (uint32_t x = 0; x < 8; ++x) {
        if (frame.primitive.at(x, y, 0) == 0) continue;
        ++covered;
        EXPECT_GE(x, 4U);
        EXPECT_EQ(frame.varyings[0].values.at(x, y, 0, 2), 3.0F);
        EXPECT_EQ(frame.varyings[1].values.at(x, y, 0), 4.0F);
      }
    }
    EXPECT_GE(covered, 1U);
    draw1.cullDistances = distances(4, 3, {-1, -1, -1, -1, -1, -1});
    EXPECT_EQ(textMask(draw(scene)).find('#'), std::string::npos);
  }
}

TEST_P(DriverViewports, EachDrawGoesToItsOwnViewportAndScissor) {
  Scene scene = sceneOf(wholeTarget());  // covers its viewport, and is clipped there
  scene.viewport = {0, 0, 4, 4, 0, 1};
  scene.scissor = Rect2D{0, 0, 4, 3};
  scene.furtherViewports = {{{4, 0, 4, 8, 0, 1}, Rect2D{5, 1, 3, 4}}, {{1, 5, 2, 2, 0.5F, 1}, Rect2D{1, 5, 2, 2}}};
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().viewportIndex = 2;
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().viewportIndex = 1;
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().indices = {{0, 1, 2}};
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthWriteEnable = scene.state.depthTestEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  const Frame frame = draw(scene);
  EXPECT_EQ(textPrimitives(frame),
            "4444....\n"
            "4444.333\n"
            "4444.333\n"
            ".....333\n"
            ".....333\n"
            ".22.....\n"
            ".22.....\n"
            "........\n");
  EXPECT_EQ(frame.depth->at(1, 5, 0), 0.75F);  // the third viewport's own depth range
  EXPECT_EQ(frame.depth->at(5, 1, 0), 0.5F);
}

TEST_P(DriverViewports, ViewportsWorkTogetherWithPointsAndDistances) {
  Scene scene = sceneOf({{2.5F, 1.5F}, {4.5F, 1.5F}});
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.furtherViewports = {{{2, 4, 8, 8, 0, 1}, std::nullopt}};
  scene.draws.front().clipDistanceCount = 1;
  scene.draws.front().clipDistances = {1, -1};
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().viewportIndex = 1;
  scene.draws.back().clipDistances = {-1, 1};
  EXPECT_EQ(textPrimitives(draw(scene)),
            "........\n"
            "..1.....\n"
            "........\n"
            "........\n"
            "........\n"
            "......4.\n"
            "........\n"
            "........\n");
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
