// Copies positions, varyings and indices to the device, each array as the scene holds it (expanded only on demand).
#include "vkref/geometry.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "scene/primitive_class.hpp"
#include "vkref/triangle_list.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr VkDeviceSize kSmallestBuffer = VkDeviceSize{64} << 10;
constexpr VkDeviceSize kBufferStep = VkDeviceSize{16} << 20;  ///< above it, sizes grow linearly
constexpr VkDeviceSize kArrayAlignment = 16;

VkDeviceSize roundUp(VkDeviceSize value, VkDeviceSize step) { return (value + step - 1) / step * step; }

/// A device that numbers primitives by the flat output of their provoking vertex needs triangles with vertices of their
/// own where polygons are drawn as lines or points: there, drivers take the output of any vertex.
bool asTriangleList(const State& state, bool expand) { return expand && polygonModeOf(state) != PolygonMode::FILL; }

/// The vertices of a draw in the order of memory: all positions, or one an index without the restarts.
struct VertexOrder {
  bool expanded = false;
  std::vector<uint32_t> indices;  ///< of an expanded draw
  size_t vertices = 0;

  VertexOrder(const Draw& draw, const State& state, bool expand) {
    const bool list = asTriangleList(state, expand);
    expanded = list || (expand && draw.indices);
    vertices = draw.positions.size();
    if (!expanded) return;
    if (list) {
      indices = triangleList(state, draw);
    } else {
      for (uint32_t index : *draw.indices) {
        if (!state.primitiveRestartEnable || index != kRestartIndex) indices.push_back(index);
      }
    }
    vertices = indices.size();
  }

  /// Copies `words` 32-bit words a vertex.
  void copy(std::byte* to, const void* from, size_t words) const {
    const size_t bytes = words * 4;
    if (!expanded) {
      std::memcpy(to, from, vertices * bytes);
      return;
    }
    for (uint32_t index : indices) {
      std::memcpy(to, static_cast<const std::byte*>(from) + index * bytes, bytes);
      to += bytes;
    }
  }
};

/// A draw of the scene with its place in the buffer.
struct Source {
  const Draw* draw = nullptr;
  VertexOrder order;
  DrawCommand command;
};

void copyArrays(const Source& source, const State& state, std::byte* mapped) {
  const Draw& draw = *source.draw;
  const DrawCommand& command = source.command;
  const auto copy = [&](VkDeviceSize to, const auto& values, size_t words) {
    source.order.copy(mapped + to, values.data(), words);
  };
  copy(command.positions, draw.positions, 4);
  for (size_t v = 0; v < draw.varyings.size(); ++v) {
    copy(command.varyings[v], draw.varyings[v].values, draw.varyings[v].components);
  }
  if (drawsPoints(state) && draw.pointSizes.empty()) {
    std::fill_n(reinterpret_cast<float*>(mapped + command.pointSizes), source.order.vertices, state.pointSize);
  } else if (drawsPoints(state)) {
    copy(command.pointSizes, draw.pointSizes, 1);
  }
  if (draw.clipDistanceCount > 0) copy(command.clipDistances, draw.clipDistances, draw.clipDistanceCount);
  if (draw.cullDistanceCount > 0) copy(command.cullDistances, draw.cullDistances, draw.cullDistanceCount);
  if (command.indexed) std::memcpy(mapped + command.indices, draw.indices->data(), draw.indices->size() * 4);
}

/// One command, or one for each run of vertices between restarts of an expanded draw.
void addCommands(const Source& source, const State& state, bool expand, std::vector<DrawCommand>& commands) {
  if (!source.order.expanded || !state.primitiveRestartEnable || asTriangleList(state, expand)) {
    commands.push_back(source.command);
    return;
  }
  DrawCommand piece = source.command;
  piece.count = 0;
  const auto end = [&] {
    const uint32_t primitives = primitiveCount(state.topology, piece.count);
    if (primitives > 0) commands.push_back(piece);
    piece.firstPrimitive += primitives;
    piece.firstVertex += piece.count;
    piece.count = 0;
  };
  for (uint32_t index : *source.draw->indices) {
    if (index == kRestartIndex) {
      end();
    } else {
      ++piece.count;
    }
  }
  end();
}

}  // namespace

Result<Pool<Buffer>::Lease> acquireBuffer(Pool<Buffer>& buffers, VkDeviceSize bytes, VkBufferUsageFlags usage) {
  const VkDeviceSize rounded = bytes <= kSmallestBuffer ? kSmallestBuffer
                               : bytes <= kBufferStep   ? std::bit_ceil(bytes)
                                                        : roundUp(bytes, kBufferStep);
  return buffers.acquire({rounded, usage}, rounded);
}

Result<Geometry> upload(const Scene& scene, bool expand, Pool<Buffer>& buffers) {
  Geometry geometry;
  geometry.topology =
      asTriangleList(scene.state, expand) ? PrimitiveTopology::TRIANGLE_LIST : scene.state.topology;
  std::vector<Source> sources;
  VkDeviceSize bytes = 0;
  uint32_t primitives = 0;
  for (const Draw& draw : scene.draws) {
    const uint32_t own = primitiveCount(scene.state, draw);
    if (own == 0) continue;
    Source source{&draw, VertexOrder(draw, scene.state, expand), {}};
    const auto reserve = [&](size_t values, size_t words) {
      const VkDeviceSize offset = bytes;
      bytes = roundUp(bytes + values * words * 4, kArrayAlignment);
      return offset;
    };
    DrawCommand& command = source.command;
    const size_t vertices = source.order.vertices;
    command.indexed = draw.indices && !expand;
    command.count = command.indexed ? vertexCount(draw) : static_cast<uint32_t>(vertices);
    command.firstPrimitive = primitives;
    command.viewportIndex = draw.viewportIndex;
    command.shaderSampleMaskBits = draw.shaderSampleMaskBits;
    command.positions = reserve(vertices, 4);
    for (size_t v = 0; v < draw.varyings.size(); ++v) {
      command.varyings[v] = reserve(vertices, draw.varyings[v].components);
    }
    if (drawsPoints(scene.state)) command.pointSizes = reserve(vertices, 1);
    command.clipDistances = reserve(vertices, draw.clipDistanceCount);
    command.cullDistances = reserve(vertices, draw.cullDistanceCount);
    if (command.indexed) command.indices = reserve(draw.indices->size(), 1);
    primitives += own;  // validate() has seen that all fit 32 bits
    addCommands(source, scene.state, expand, geometry.draws);
    sources.push_back(std::move(source));
  }
  if (sources.empty()) return geometry;

  Result<Pool<Buffer>::Lease> buffer =
      acquireBuffer(buffers, bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  geometry.buffer = std::move(*buffer);
  for (const Source& source : sources) copyArrays(source, scene.state, geometry.buffer->mapped);
  return geometry;
}

}  // namespace rasterdiff::vkref
