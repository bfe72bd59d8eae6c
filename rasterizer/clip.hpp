// Clipping of triangles in homogeneous coordinates against the view volume: whole rejection, or a convex polygon with
// what is needed to carry attributes along. (Sutherland-Hodgman 1974; [vk:vertexpostproc-clipping])
#pragma once

#include <array>
#include <span>

#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// A vertex of the clipped polygon. Weights refer to the triangle's three vertices:
/// smooth: position and perspective attributes; linear: attributes that are linear on the screen.
/// [vk:vertexpostproc-clipping-shader-outputs]
struct ClipVertex {
  std::array<double, 4> position{};
  std::array<double, 3> smoothWeights{}, linearWeights{};
  std::array<double, 4> error{};  ///< bound on a float32 clipper's deviation from `position`, per coordinate
  bool made = false;              ///< by clipping
};

struct ClipPolygon {
  static constexpr int kCapacity = 3 + 6;  ///< each of six planes adds at most one vertex
  std::array<ClipVertex, kCapacity + 1> vertices;
  int size = 0;
};

enum class ClipOutcome : uint8_t { Inside, Rejected, Cut };

/// Bit i set: outside plane i, in the order +x, -x, +y, -y, near, far.
[[nodiscard]] unsigned outcode(const ClipPosition& position, bool negativeOneToOne, DeliberateError error);

/// Clips; `polygon` has 3 vertices if Inside (the triangle's own), up to 9 if Cut (0 to 2 mean that nothing is left).
[[nodiscard]] ClipOutcome clipTriangle(std::span<const ClipPosition, 3> triangle, const Rules& rules,
                                       bool negativeOneToOne, ClipPolygon& polygon);

}  // namespace rasterdiff::rasterizer
