#include "harness/export/amber_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "rasterizer/assembly.hpp"
#include "scene/file/enum_names.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness {
namespace {

/// One vertex buffer: rows of bits.
struct Buffer {
  std::string name, type;
  uint32_t location = 0;
  std::string rows{};
};

uint32_t bits(float value) { return std::bit_cast<uint32_t>(value); }

using Four = std::array<uint32_t, 4>;

Four fourOf(const std::vector<float>& values, size_t first, size_t count) {
  Four row{};
  for (size_t i = 0; i < std::min<size_t>(count, 4); ++i) row[i] = bits(values[first + i]);
  return row;
}

class VertexWriter {
 public:
  explicit VertexWriter(const Scene& scene) : scene_(scene) {
    buffers_ = {{"positions", "vec4<uint32>", kAmberPosition}, {"numbers", "vec2<uint32>", kAmberNumbers}};
    if (scene.draws.empty()) return;
    const Draw& first = scene.draws[0];
    distances_ = first.clipDistanceCount + first.cullDistanceCount;
    for (uint32_t i = 0; 4 * i < distances_; ++i) {
      buffers_.push_back({fmt::format("distances{}", i), "vec4<uint32>", kAmberDistances + i});
    }
    varyings_ = buffers_.size();
    for (uint32_t v = 0; v < first.varyings.size(); ++v) {
      buffers_.push_back({fmt::format("varying{}", v), "vec4<uint32>", kAmberVaryings + v});
    }
  }

  void add(const Draw& draw, uint32_t vertex, uint32_t primitive) {
    const ClipPosition& p = draw.positions[vertex];
    write(0, Four{bits(p.x), bits(p.y), bits(p.z), bits(p.w)});
    const float size = draw.pointSizes.empty() ? scene_.state.pointSize : draw.pointSizes[vertex];
    write(1, std::array{primitive, bits(size)});
    std::vector<float> all;
    for (uint32_t i = 0; i < draw.clipDistanceCount; ++i) all.push_back(draw.clipDistances[vertex * size_t{draw.clipDistanceCount} + i]);
    for (uint32_t i = 0; i < draw.cullDistanceCount; ++i) all.push_back(draw.cullDistances[vertex * size_t{draw.cullDistanceCount} + i]);
    for (size_t i = 0; 4 * i < distances_; ++i) write(2 + i, fourOf(all, 4 * i, distances_ - 4 * i));
    for (size_t v = 0; v < draw.varyings.size(); ++v) {
      const Varying& varying = draw.varyings[v];
      write(varyings_ + v, fourOf(varying.values, vertex * size_t{varying.components}, varying.components));
    }
    ++count_;
  }

  [[nodiscard]] AmberVertices take() {
    AmberVertices vertices;
    vertices.count = count_;
    for (const Buffer& buffer : buffers_) {
      vertices.buffers += fmt::format("BUFFER {} DATA_TYPE {} DATA\n{}END\n\n", buffer.name, buffer.type, buffer.rows);
      vertices.bindings += fmt::format("  VERTEX_DATA {} LOCATION {}\n", buffer.name, buffer.location);
    }
    return vertices;
  }

 private:
  template <size_t n>
  void write(size_t buffer, const std::array<uint32_t, n>& row) {
    fmt::format_to(std::back_inserter(buffers_[buffer].rows), "{}\n", fmt::join(row, " "));
  }

  const Scene& scene_;
  std::vector<Buffer> buffers_;
  size_t distances_ = 0, varyings_ = 2;
  uint32_t count_ = 0;
};

PrimitiveTopology listOf(PrimitiveTopology topology) {
  switch (topologyClassOf(topology)) {
    case TopologyClass::Point: return PrimitiveTopology::POINT_LIST;
    case TopologyClass::Line: return PrimitiveTopology::LINE_LIST;
    case TopologyClass::Triangle: break;
  }
  return PrimitiveTopology::TRIANGLE_LIST;
}

}  // namespace

AmberVertices amberVertices(const Scene& scene) {
  VertexWriter writer(scene);
  uint32_t primitive = 0;
  for (const Draw& draw : scene.draws) {
    for (const rasterizer::AssembledTriangle& assembled : rasterizer::assemble(draw, scene.state)) {
      ++primitive;
      // Turned, which changes no winding, and exchanged in lines, so that the provoking vertex comes first.
      const auto begin = assembled.vertices.begin(), end = begin + assembled.count;
      const auto provoking = static_cast<size_t>(std::find(begin, end, assembled.provoking) - begin);
      for (size_t i = 0; i < assembled.count; ++i) writer.add(draw, assembled.vertices[(provoking + i) % assembled.count], primitive);
    }
  }
  AmberVertices vertices = writer.take();
  vertices.topology = enumName(listOf(scene.state.topology));
  return vertices;
}

}  // namespace rasterdiff::harness
