// Primitive restart: strips and fans begin anew, numbers of primitives go on.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverRestart : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverRestart);

constexpr uint32_t kRestart = kRestartIndex;

/// Two rectangles of 4 × 4 pixels side by side, no pixel centre on an edge; corners in the order of a strip.
Scene squares(PrimitiveTopology topology, std::vector<uint32_t> indices) {
  Scene scene = sceneOf({{0.25F, 0.25F}, {3.75F, 0.25F}, {0.25F, 3.875F}, {3.75F, 3.875F},  //
                         {4.25F, 0.25F}, {7.75F, 0.25F}, {4.25F, 3.875F}, {7.75F, 3.875F}},
                        8, 4);
  scene.state.topology = topology;
  scene.state.primitiveRestartEnable = true;
  scene.draws.front().indices = std::move(indices);
  scene.draws.front().varyings = {vertexNumbers(8)};
  return scene;
}

/// The flat value of the first sample that `primitive` (counted from 1) owns; -1 if it owns none.
float valueOf(const Frame& frame, uint32_t primitive) {
  for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
    if (frame.primitive.data[i] == primitive) return frame.varyings[0].values.data[i];
  }
  return -1;
}

TEST_P(DriverRestart, ATriangleStripBeginsAnewAndItsNumbersGoOn) {
  // A piece of two vertices is no triangle and takes no number.
  Scene scene = squares(PrimitiveTopology::TRIANGLE_STRIP, {0, 1, 2, 3, kRestart, 0, 4, kRestart, 4, 5, 6, 7});
  scene.draws.push_back(scene.draws.front());
  scene.draws.back().indices = {{kRestart, kRestart, 5, 7, 6}};
  const Frame frame = draw(scene);
  EXPECT_EQ(textPrimitives(frame).substr(0, 9), "11113333\n");
  EXPECT_EQ(textPrimitives(frame).substr(27, 9), "12223555\n");
  EXPECT_EQ(valueOf(frame, 1), 0.0F);
  EXPECT_EQ(valueOf(frame, 2), 1.0F);
  EXPECT_EQ(valueOf(frame, 3), 4.0F);
  EXPECT_EQ(valueOf(frame, 5), 5.0F);
}

TEST_P(DriverRestart, TheLastVertexProvokesAcrossRestartsToo) {
  Scene scene = squares(PrimitiveTopology::TRIANGLE_STRIP, {0, 1, 2, 3, kRestart, 4, 5, 6, 7});
  scene.state.provokingVertexMode = ProvokingVertexMode::LAST_VERTEX;
  const Frame frame = draw(scene);
  const float expected[] = {2, 3, 6, 7};
  for (uint32_t p = 0; p < 4; ++p) EXPECT_EQ(valueOf(frame, p + 1), expected[p]) << p;
}

TEST_P(DriverRestart, AFanAndALineStripBeginAnew) {
  const Frame fan = draw(squares(PrimitiveTopology::TRIANGLE_FAN, {0, 1, 3, 2, kRestart, 4, 5, 7, 6}));
  const float fanValues[] = {1, 3, 5, 7};  // [vk:drawing-triangle-fans] the second vertex of each triangle provokes
  for (uint32_t p = 0; p < 4; ++p) EXPECT_EQ(valueOf(fan, p + 1), fanValues[p]) << p;
  const Frame lines = draw(squares(PrimitiveTopology::LINE_STRIP, {2, 0, 1, kRestart, 5, kRestart, 4, 6, 7}));
  const float lineValues[] = {2, 0, 4, 6};
  for (uint32_t p = 0; p < 4; ++p) EXPECT_EQ(valueOf(lines, p + 1), lineValues[p]) << p;
  EXPECT_EQ(lines.primitive.at(5, 0, 0), 0U);  // no line from piece to piece
}

TEST_P(DriverRestart, AListDropsThePrimitiveThatARestartCutsShort) {
  const Scene scene = squares(PrimitiveTopology::TRIANGLE_LIST, {0, 1, kRestart, 4, 5, 6, kRestart, 0, 1, 2});
  const bool offered = caps().features.listRestart.primitiveTopologyListRestart;
  const std::optional<Frame> frame = drawIf(offered, scene, "draws[0].indices");
  if (!frame) return;
  EXPECT_EQ(valueOf(*frame, 1), 4.0F);
  EXPECT_EQ(valueOf(*frame, 2), 0.0F);
}

TEST_P(DriverRestart, WithoutRestartTheStripGoesOn) {
  Scene scene = squares(PrimitiveTopology::TRIANGLE_STRIP, {0, 1, 2, 3, 4, 5, 6, 7});
  scene.state.primitiveRestartEnable = false;
  EXPECT_EQ(draw(scene).primitive.at(7, 3, 0), 6U);
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
