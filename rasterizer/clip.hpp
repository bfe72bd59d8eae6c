// Clipping in homogeneous coordinates against the view volume and user clip distances: whole rejection, or what is left
// of a triangle, line or point, with what is needed to carry attributes along.
// (Sutherland-Hodgman 1974; [vk:vertexpostproc-clipping])
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
  std::array<double, kMaxDistances> distances{};  ///< user clip distances, interpolated like smooth attributes
  bool made = false;              ///< by clipping
  bool outlined = true;           ///< [choice:cut-outline] Flagged: its corner and the edge to the next vertex are drawn
};

inline constexpr int kVolumePlanes = 6;
inline constexpr int kClipPlanes = kVolumePlanes + static_cast<int>(kMaxDistances);

struct ClipPolygon {
  static constexpr int kCapacity = 3 + kClipPlanes;  ///< each plane adds at most one vertex
  std::array<ClipVertex, kCapacity + 1> vertices;
  int size = 0;
};

enum class ClipOutcome : uint8_t { Inside, Rejected, Cut };

/// What is clipped against, for one draw.
struct ClipVolume {
  bool nearAtMinusW = false;  ///< near plane z = -w instead of z = 0
  bool nearAndFar = true;     ///< depth clipping is on. [vk:vertexpostproc-clipping] depthClipEnable / depthClampEnable
  uint32_t distances = 0;     ///< number of user clip distances
  bool wideSides = false;     ///< [choice:point-clip] polygons are cut at twice the volume's width and height
  DeliberateError error = DeliberateError::None;
};

[[nodiscard]] ClipVolume clipVolume(const State& state, const Draw& draw, DeliberateError error);

/// One vertex as the clipper takes it.
struct ClipInput {
  ClipPosition position;
  std::span<const float> distances;  ///< ClipVolume::distances of them
};

inline constexpr unsigned kSideMask = 0xF;  ///< +x, -x, +y, -y

/// Bit i set: outside plane i, in the order +x, -x, +y, -y, near, far, user distances.
[[nodiscard]] unsigned outcode(const ClipInput& vertex, const ClipVolume& volume);

/// Clips a triangle; `polygon` has 3 vertices if Inside (its own), more or fewer if Cut (0 to 2: nothing is left).
[[nodiscard]] ClipOutcome clipTriangle(std::span<const ClipInput, 3> triangle, ClipArithmetic arithmetic,
                                       const ClipVolume& volume, ClipPolygon& polygon);

/// Clips a convex polygon of at most 8 corners, whose weights do not count, by every plane; `polygon` has fewer than 3
/// vertices where nothing is left. User distances are not looked at.
void clipPolygon(std::span<const ClipPosition> corners, ClipArithmetic arithmetic, const ClipVolume& volume, ClipPolygon& polygon);

/// Clips a line; `polygon` gets its 2 vertices (0: nothing is left).
[[nodiscard]] ClipOutcome clipLine(std::span<const ClipInput, 2> line, ClipArithmetic arithmetic, const ClipVolume& volume,
                                   ClipPolygon& polygon);

}  // namespace rasterdiff::rasterizer
