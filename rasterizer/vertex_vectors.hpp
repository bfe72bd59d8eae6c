// VertexStage::original for vectors of vertices, with the same bits: what the kernels need of the vertices of one draw. Vertices that
// are clipped, or lie where doubles alone do not decide, are left to VertexStage.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rasterizer/clip.hpp"
#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/fragment/plane_corners.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// A corner of the plane of depths, in pixels, and how well it is known.
struct DepthVertex {
  double x = 0, y = 0, z = 0;
  double deviation = 0;  ///< pixels, in x and in y
  double error = 0;      ///< of z
};

/// Set beside the bits of outcode(): the vertex has no place on the screen that its triangle could be drawn from.
inline constexpr uint32_t kNoPlace = uint32_t{1} << 31;

/// The vertices of one draw side by side. Of those with a code there is nothing but the code.
struct StagedVertices {
  std::vector<SubpixelPosition> snapped;
  std::vector<uint32_t> codes;      ///< outcode(), or with kNoPlace: w is not positive or something is not finite
  std::vector<DepthVertex> depths;  ///< empty for scenes without depth

  /// Room for `size` vertices.
  StagedVertices(size_t size, bool deep);
};

/// What of a vertex the planes of values are laid through.
[[nodiscard]] DepthVertex depthVertex(const RasterVertex& vertex, const PlanePlaces& places);

/// Closed rules without deliberate errors: those of a profile.
[[nodiscard]] bool stagesInVectors(const Rules& rules);

/// Stages vertices [first, first + positions.size()) of a draw; `volume` has no user distances. Returns how many have a w that is
/// not 1.
uint64_t stageVertices(std::span<const ClipPosition> positions, const VertexStage& stage, const ClipVolume& volume, size_t first,
                       StagedVertices& to);

}  // namespace rasterdiff::rasterizer
