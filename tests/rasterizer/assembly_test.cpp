// Primitive assembly against the tables of the specification, written out as data.
#include "rasterizer/assembly.hpp"

#include <gtest/gtest.h>

namespace rasterdiff::rasterizer {
namespace {

using Vertices = std::array<uint32_t, 3>;
using enum ProvokingVertexMode;
using enum PrimitiveTopology;

State stateOf(PrimitiveTopology topology, ProvokingVertexMode mode) {
  State state;
  state.topology = topology;
  state.provokingVertexMode = mode;
  return state;
}

Draw drawOf(uint32_t positions) {
  Draw draw;
  draw.positions.resize(positions);
  return draw;
}

std::vector<Vertices> orders(const std::vector<AssembledTriangle>& triangles) {
  std::vector<Vertices> result;
  for (const AssembledTriangle& triangle : triangles) result.push_back(triangle.vertices);
  return result;
}

std::vector<uint32_t> provoking(const std::vector<AssembledTriangle>& triangles) {
  std::vector<uint32_t> result;
  for (const AssembledTriangle& triangle : triangles) result.push_back(triangle.provoking);
  return result;
}

// [vk:drawing-primitive-topologies] order of vertices; [vk:vertexpostproc-flatshading] provoking vertex of primitive i.
struct Table {
  const char* name;
  PrimitiveTopology topology;
  ProvokingVertexMode mode;
  std::vector<Vertices> vertices;  // of seven vertices (nine in a list)
  std::vector<uint32_t> provoking;
};

class Assembly : public ::testing::TestWithParam<Table> {};

TEST_P(Assembly, FollowsTheTablesOfTheSpecification) {
  const Table& table = GetParam();
  const Draw draw = drawOf(table.topology == TRIANGLE_LIST ? 9 : 7);
  const std::vector<AssembledTriangle> triangles = assemble(draw, stateOf(table.topology, table.mode));
  EXPECT_EQ(orders(triangles), table.vertices);
  EXPECT_EQ(provoking(triangles), table.provoking);
}

TEST_P(Assembly, WithIndicesIsThatOfTheVerticesTheyName) {
  const Table& table = GetParam();
  Draw draw = drawOf(40);
  const uint32_t count = table.topology == TRIANGLE_LIST ? 9 : 7;
  draw.indices.emplace();
  const auto vertexAt = [](uint32_t i) { return (i * 13 + 5) % 40; };
  for (uint32_t i = 0; i < count; ++i) draw.indices->push_back(vertexAt(i));
  std::vector<Vertices> expected;
  for (const Vertices& v : table.vertices) expected.push_back({vertexAt(v[0]), vertexAt(v[1]), vertexAt(v[2])});
  std::vector<uint32_t> expectedProvoking;
  for (const uint32_t v : table.provoking) expectedProvoking.push_back(vertexAt(v));
  const std::vector<AssembledTriangle> triangles = assemble(draw, stateOf(table.topology, table.mode));
  EXPECT_EQ(orders(triangles), expected);
  EXPECT_EQ(provoking(triangles), expectedProvoking);
}

INSTANTIATE_TEST_SUITE_P(
    Tables, Assembly,
    ::testing::Values(
        Table{"ListFirst", TRIANGLE_LIST, FIRST_VERTEX, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}, {0, 3, 6}},
        Table{"ListLast", TRIANGLE_LIST, LAST_VERTEX, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}, {2, 5, 8}},
        Table{"StripFirst", TRIANGLE_STRIP, FIRST_VERTEX, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 6}}, {0, 1, 2, 3, 4}},
        Table{"StripLast", TRIANGLE_STRIP, LAST_VERTEX, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 6}}, {2, 3, 4, 5, 6}},
        Table{"FanFirst", TRIANGLE_FAN, FIRST_VERTEX, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}, {5, 6, 0}}, {1, 2, 3, 4, 5}},
        Table{"FanLast", TRIANGLE_FAN, LAST_VERTEX, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}}, {2, 3, 4, 5, 6}}),
    [](const auto& testInfo) { return testInfo.param.name; });

TEST(AssemblyCounts, IncompletePrimitivesAreIgnored) {
  for (const auto topology : {TRIANGLE_LIST, TRIANGLE_STRIP, TRIANGLE_FAN}) {
    for (uint32_t vertices = 0; vertices < 3; ++vertices) {
      EXPECT_TRUE(assemble(drawOf(vertices), stateOf(topology, FIRST_VERTEX)).empty()) << vertices;
    }
  }
  EXPECT_EQ(assemble(drawOf(5), stateOf(TRIANGLE_LIST, FIRST_VERTEX)).size(), 1U);
  EXPECT_EQ(assemble(drawOf(8), stateOf(TRIANGLE_LIST, FIRST_VERTEX)).size(), 2U);
}

TEST(AssemblyCounts, AnEmptyIndexListDrawsNothing) {
  Draw draw = drawOf(9);
  draw.indices.emplace();
  EXPECT_TRUE(assemble(draw, stateOf(TRIANGLE_LIST, FIRST_VERTEX)).empty());
}

TEST(AssemblyMutants, EachChangesItsOwnRuleOnly) {
  Draw strip = drawOf(5);
  const State state = stateOf(TRIANGLE_STRIP, FIRST_VERTEX);
  const auto parity = assemble(strip, state, DeliberateError::StripParityIgnored);
  EXPECT_EQ(orders(parity), (std::vector<Vertices>{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}}));
  const auto wrongEnd = assemble(strip, state, DeliberateError::WrongProvokingVertex);
  EXPECT_EQ(orders(wrongEnd), orders(assemble(strip, state)));
  EXPECT_EQ(provoking(wrongEnd), (std::vector<uint32_t>{2, 2, 4}));
  Draw list = drawOf(6);
  list.indices = {0, 1, 2, 3, 4, 5};
  const auto lastIndex = assemble(list, stateOf(TRIANGLE_LIST, FIRST_VERTEX), DeliberateError::IndexOffByOne);
  EXPECT_EQ(orders(lastIndex), (std::vector<Vertices>{{0, 1, 2}, {3, 4, 4}}));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
