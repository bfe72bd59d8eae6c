// Puts a scene's vertices and indices into one buffer, and says what each draw command has to bind.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"
#include "vkref/capabilities.hpp"
#include "vkref/pool.hpp"

namespace rasterdiff::vkref {

/// One draw, and where its arrays lie in the buffer, bytes.
struct DrawCommand {
  uint32_t count = 0;           ///< vertices, or indices
  uint32_t firstVertex = 0;     ///< of the arrays
  bool indexed = false;
  uint32_t firstPrimitive = 0;  ///< primitives of all draws before
  uint32_t viewportIndex = 0;
  uint32_t shaderSampleMaskBits = 0;
  VkDeviceSize positions = 0, indices = 0;
  std::array<VkDeviceSize, kMaxVaryings> varyings{};
  VkDeviceSize pointSizes = 0, clipDistances = 0, cullDistances = 0;  ///< where the scene has them
};

struct Geometry {
  Pool<Buffer>::Lease buffer;  ///< null when nothing is drawn
  PrimitiveTopology topology = PrimitiveTopology::TRIANGLE_LIST;  ///< of the draws
  std::vector<DrawCommand> draws;
};

/// Draws without a whole primitive are left out. With `expand`, indexed draws become draws of one vertex an index, in
/// the order of the indices, and a draw with restarts becomes several: the same primitives, with consecutive vertex
/// numbers. Polygons that are drawn as lines or points then become a list of triangles.
/// A scene that draws points has a point size for every vertex.
/// `scene` has passed validate(). Error: NotOffered when memory ran out.
[[nodiscard]] Result<Geometry> upload(const Scene& scene, bool expand, Pool<Buffer>& buffers);

/// A buffer of at least `bytes`, rounded up so that scenes of like size share it.
[[nodiscard]] Result<Pool<Buffer>::Lease> acquireBuffer(Pool<Buffer>& buffers, VkDeviceSize bytes,
                                                        VkBufferUsageFlags usage);

}  // namespace rasterdiff::vkref
