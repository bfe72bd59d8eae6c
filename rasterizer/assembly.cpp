#include "rasterizer/assembly.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Positions in the vertex stream of primitive i; rotated so that the provoking vertex is at the end the mode names.
std::array<uint32_t, 3> stream(PrimitiveTopology topology, bool firstProvokes, bool ignoreParity, uint32_t i) {
  switch (topology) {
    case PrimitiveTopology::TRIANGLE_LIST: return {3 * i, 3 * i + 1, 3 * i + 2};
    case PrimitiveTopology::TRIANGLE_STRIP: {
      if (i % 2 == 0 || ignoreParity) return {i, i + 1, i + 2};
      if (firstProvokes) return {i, i + 2, i + 1};
      return {i + 1, i, i + 2};
    }
    case PrimitiveTopology::TRIANGLE_FAN:
      if (firstProvokes) return {i + 1, i + 2, 0};
      return {0, i + 1, i + 2};
  }
  return {};
}

}  // namespace

std::vector<AssembledTriangle> assemble(const Draw& draw, const State& state, DeliberateError error) {
  const uint32_t vertices = vertexCount(draw);
  const uint32_t primitives = primitiveCount(state.topology, vertices);
  const bool firstProvokes = state.provokingVertexMode == ProvokingVertexMode::FIRST_VERTEX;
  const bool ignoreParity = error == DeliberateError::StripParityIgnored;

  std::vector<AssembledTriangle> triangles(primitives);
  for (uint32_t i = 0; i < primitives; ++i) {
    AssembledTriangle& triangle = triangles[i];
    triangle.vertices = stream(state.topology, firstProvokes, ignoreParity, i);
    if (draw.indices) {
      for (uint32_t& vertex : triangle.vertices) {
        if (error == DeliberateError::IndexOffByOne && vertex + 1 == vertices) --vertex;
        vertex = (*draw.indices)[vertex];
      }
    }
    const bool takeFirst = firstProvokes != (error == DeliberateError::WrongProvokingVertex);
    triangle.provoking = triangle.vertices[takeFirst ? 0 : 2];
  }
  return triangles;
}

}  // namespace rasterdiff::rasterizer
