// The vertex buffers of an Amber script: floats as the bits that the vertex shader turns back, strips and fans as lists,
// and with each vertex the number of its primitive, since gl_PrimitiveID asks for geometry shaders.
#pragma once

#include <cstdint>
#include <string>

#include "scene/scene.hpp"

namespace rasterdiff::harness {

struct AmberVertices {
  uint32_t count = 0;       ///< vertices of all draws; primitive follows primitive
  std::string topology;     ///< TRIANGLE_LIST, LINE_LIST or POINT_LIST
  std::string buffers;      ///< the BUFFER commands
  std::string bindings;     ///< VERTEX_DATA lines of a pipeline
};

/// Vertex shader locations.
inline constexpr uint32_t kAmberPosition = 0;   ///< uvec4: bits of the clip position
inline constexpr uint32_t kAmberNumbers = 1;    ///< uvec2: 1-based primitive, bits of the point size
inline constexpr uint32_t kAmberDistances = 2;  ///< two uvec4: bits of clip distances, then of cull distances
inline constexpr uint32_t kAmberVaryings = 4;   ///< a uvec4 each

/// The first vertex of each primitive is its provoking one.
[[nodiscard]] AmberVertices amberVertices(const Scene& scene);

}  // namespace rasterdiff::harness
