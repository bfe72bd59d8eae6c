// The tables of vertex orders, applied to each run of vertices between restarts.
#include "vkref/triangle_list.hpp"

#include <array>

namespace rasterdiff::vkref {
namespace {

/// [vk:drawing-triangle-strips] [vk:drawing-triangle-fans] the vertices of triangle p within its run.
std::array<size_t, 3> verticesOf(PrimitiveTopology topology, bool last, size_t p) {
  if (topology == PrimitiveTopology::TRIANGLE_LIST) return {3 * p, 3 * p + 1, 3 * p + 2};
  if (topology == PrimitiveTopology::TRIANGLE_FAN) {
    return last ? std::array<size_t, 3>{0, p + 1, p + 2} : std::array<size_t, 3>{p + 1, p + 2, 0};
  }
  if (p % 2 == 0) return {p, p + 1, p + 2};
  return last ? std::array<size_t, 3>{p + 1, p, p + 2} : std::array<size_t, 3>{p, p + 2, p + 1};
}

}  // namespace

std::vector<uint32_t> triangleList(const State& state, const Draw& draw) {
  const bool last = state.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX;
  std::vector<uint32_t> list, run;
  const auto end = [&] {
    const uint32_t triangles = primitiveCount(state.topology, static_cast<uint32_t>(run.size()));
    for (uint32_t p = 0; p < triangles; ++p) {
      for (size_t vertex : verticesOf(state.topology, last, p)) list.push_back(run[vertex]);
    }
    run.clear();
  };
  for (uint32_t i = 0; i < vertexCount(draw); ++i) {
    const uint32_t vertex = draw.indices ? (*draw.indices)[i] : i;
    if (draw.indices && state.primitiveRestartEnable && vertex == kRestartIndex) {
      end();
    } else {
      run.push_back(vertex);
    }
  }
  end();
  return list;
}

}  // namespace rasterdiff::vkref
