// Copies positions, varyings and indices to the device, each array as the scene holds it (expanded only on demand).
#include "vkref/geometry.hpp"

#include <bit>
#include <cstring>

namespace rasterdiff::vkref {
namespace {

constexpr VkDeviceSize kSmallestBuffer = VkDeviceSize{64} << 10;
constexpr VkDeviceSize kBufferStep = VkDeviceSize{16} << 20;  ///< above it, sizes grow linearly
constexpr VkDeviceSize kArrayAlignment = 16;

VkDeviceSize roundUp(VkDeviceSize value, VkDeviceSize step) { return (value + step - 1) / step * step; }

/// Copies `words` 32-bit words a vertex: all vertices in order, or one an index.
void copyVertices(std::byte* to, const void* from, size_t vertices, size_t words,
                  const std::vector<uint32_t>* expandBy) {
  const size_t bytes = words * 4;
  if (!expandBy) {
    std::memcpy(to, from, vertices * bytes);
    return;
  }
  for (uint32_t index : *expandBy) {
    std::memcpy(to, static_cast<const std::byte*>(from) + index * bytes, bytes);
    to += bytes;
  }
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
  std::vector<const Draw*> sources;
  VkDeviceSize bytes = 0;
  uint32_t primitives = 0;
  const auto reserve = [&bytes](size_t size) {
    const VkDeviceSize offset = bytes;
    bytes = roundUp(bytes + size, kArrayAlignment);
    return offset;
  };
  for (const Draw& draw : scene.draws) {
    DrawCommand command;
    command.count = vertexCount(draw);
    command.indexed = draw.indices && !expand;
    command.firstPrimitive = primitives;
    const uint32_t own = primitiveCount(scene.state.topology, command.count);
    primitives += own;  // validate() has seen that all fit 32 bits
    if (own == 0) continue;
    const size_t vertices = command.indexed ? draw.positions.size() : command.count;
    command.positions = reserve(vertices * sizeof(ClipPosition));
    for (size_t v = 0; v < draw.varyings.size(); ++v) {
      command.varyings[v] = reserve(vertices * draw.varyings[v].components * sizeof(float));
    }
    if (command.indexed) command.indices = reserve(draw.indices->size() * sizeof(uint32_t));
    geometry.draws.push_back(command);
    sources.push_back(&draw);
  }
  if (geometry.draws.empty()) return geometry;

  Result<Pool<Buffer>::Lease> buffer =
      acquireBuffer(buffers, bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  geometry.buffer = std::move(*buffer);
  std::byte* mapped = geometry.buffer->mapped;
  for (size_t i = 0; i < sources.size(); ++i) {
    const Draw& draw = *sources[i];
    const DrawCommand& command = geometry.draws[i];
    const std::vector<uint32_t>* expandBy = draw.indices && expand ? &*draw.indices : nullptr;
    copyVertices(mapped + command.positions, draw.positions.data(), draw.positions.size(), 4, expandBy);
    for (size_t v = 0; v < draw.varyings.size(); ++v) {
      const Varying& varying = draw.varyings[v];
      copyVertices(mapped + command.varyings[v], varying.values.data(), draw.positions.size(), varying.components,
                   expandBy);
    }
    if (command.indexed) {
      std::memcpy(mapped + command.indices, draw.indices->data(), draw.indices->size() * sizeof(uint32_t));
    }
  }
  return geometry;
}

}  // namespace rasterdiff::vkref
