// Lists, strips and fans, indexed or not, under both provoking vertex modes: numbers and flat values of primitives.
#include <algorithm>

#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverTopology : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverTopology);

/// Four triangles side by side in a strip of height 4, in the order of a triangle strip.
std::vector<Point> stripPoints() {
  return {{0.25F, 0.25F}, {0.25F, 3.75F}, {4.25F, 0.25F}, {4.25F, 3.75F}, {7.875F, 0.25F}, {7.875F, 3.75F}};
}

constexpr const char* kStripPrimitives =
    "11113333\n"
    "11123334\n"
    "11223344\n"
    "12223444\n";

/// A fan around the middle of the left edge.
std::vector<Point> fanPoints() {
  return {{0.25F, 2.125F}, {0.25F, 0.25F}, {7.75F, 0.25F}, {7.75F, 3.75F}, {0.25F, 3.75F}};
}

/// The same scene with its vertices reversed in memory and indices that restore their order.
Scene indexed(Scene scene) {
  Draw& draw = scene.draws.front();
  const uint32_t vertices = static_cast<uint32_t>(draw.positions.size());
  std::reverse(draw.positions.begin(), draw.positions.end());
  for (Varying& varying : draw.varyings) std::reverse(varying.values.begin(), varying.values.end());
  draw.indices.emplace();
  for (uint32_t i = 0; i < vertices; ++i) draw.indices->push_back(vertices - 1 - i);
  return scene;
}

/// [vk:drawing-primitive-topologies] the vertex that provokes primitive p (counted from 0).
uint32_t provokingVertex(PrimitiveTopology topology, ProvokingVertexMode mode, uint32_t p) {
  const bool last = mode == ProvokingVertexMode::LAST_VERTEX;
  if (topology == PrimitiveTopology::TRIANGLE_LIST) return 3 * p + (last ? 2 : 0);
  if (topology == PrimitiveTopology::TRIANGLE_STRIP) return p + (last ? 2 : 0);
  return p + (last ? 2 : 1);
}

TEST_P(DriverTopology, StripNumbersItsTrianglesInOrder) {
  Scene scene = sceneOf(stripPoints(), 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
  EXPECT_EQ(textPrimitives(draw(scene)), kStripPrimitives);
  EXPECT_EQ(textPrimitives(draw(indexed(scene))), kStripPrimitives);
}

TEST_P(DriverTopology, ListOfTheSameTrianglesHasTheSameNumbers) {
  const std::vector<Point> strip = stripPoints();
  std::vector<Point> list;
  for (size_t p = 0; p + 2 < strip.size(); ++p) list.insert(list.end(), {strip[p], strip[p + 1], strip[p + 2]});
  const Scene scene = sceneOf(list, 8, 4);
  EXPECT_EQ(textPrimitives(draw(scene)), kStripPrimitives);
  EXPECT_EQ(textPrimitives(draw(indexed(scene))), kStripPrimitives);
}

TEST_P(DriverTopology, FanNumbersItsTrianglesInOrder) {
  Scene scene = sceneOf(fanPoints(), 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  constexpr const char* kFanPrimitives =
      "11111112\n"
      "11122222\n"
      "33222222\n"
      "33333332\n";
  EXPECT_EQ(textPrimitives(draw(scene)), kFanPrimitives);
  EXPECT_EQ(textPrimitives(draw(indexed(scene))), kFanPrimitives);
}

TEST_P(DriverTopology, FlatValuesComeFromTheProvokingVertex) {
  for (const auto topology : {PrimitiveTopology::TRIANGLE_LIST, PrimitiveTopology::TRIANGLE_STRIP,
                              PrimitiveTopology::TRIANGLE_FAN}) {
    for (const auto mode : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
      Scene scene = sceneOf(topology == PrimitiveTopology::TRIANGLE_FAN ? fanPoints() : stripPoints(), 8, 4, 4);
      scene.state.topology = topology;
      scene.state.provokingVertexMode = mode;
      scene.draws.front().varyings.push_back(vertexNumbers(scene.draws.front().positions.size()));
      const Frame plain = draw(scene);
      uint64_t covered = 0;
      for (size_t i = 0; i < plain.primitive.data.size(); ++i) {
        const uint32_t primitive = plain.primitive.data[i];
        if (primitive == 0) continue;
        ++covered;
        ASSERT_EQ(plain.varyings[0].values.data[i],
                  static_cast<float>(provokingVertex(topology, mode, primitive - 1)));
      }
      EXPECT_GE(covered, 40U);
      // Indices change where vertices are fetched from, and nothing else.
      Scene other = indexed(scene);
      const Frame fetched = draw(other);
      EXPECT_EQ(fetched.primitive.data, plain.primitive.data);
      EXPECT_EQ(fetched.count.data, plain.count.data);
      EXPECT_EQ(fetched.varyings[0].values.data, plain.varyings[0].values.data);
    }
  }
}

TEST_P(DriverTopology, VerticesBeyondTheLastWholePrimitiveDrawNothing) {
  std::vector<Point> points = wholeTarget(8, 4);
  points.push_back({0, 0});
  points.push_back({8, 0});
  EXPECT_EQ(textPrimitives(draw(sceneOf(points, 8, 4))).find('2'), std::string::npos);
  Scene second = sceneOf(points, 8, 4);
  second.draws.push_back(second.draws.front());
  EXPECT_EQ(draw(second).primitive.at(0, 0, 0), 2U);  // the cut-off vertices of draw 0 are not numbered either
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
