// Which side of a polygon is seen, as far as legal placements of its corners leave it open; what follows from the side
// (culling, FrontFacing) is its users' matter.
#pragma once

#include <cstdlib>
#include <vector>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// Twice a polygon's area, and by how much legal placements of its corners may change it at most. 1/65536 pixel².
struct AreaBand {
  int64_t area = 0;    ///< of the nominal corners; sign as doubleArea
  int64_t margin = 0;  ///< 0: every corner has one legal place

  /// Every legal placement has the same sign. [vk:primsrast-polygons-basic]
  [[nodiscard]] bool signIsCertain() const { return std::llabs(area) > margin; }
  /// Some legal placement may show the other side, or none at all.
  [[nodiscard]] bool sideIsFree() const { return margin > 0 && !signIsCertain(); }
};

[[nodiscard]] AreaBand areaBand(const std::vector<RasterVertex>& polygon);

/// May a legal placement of its vertices show the primitive's other side, or none? Uncut, vertices at the same clip position
/// are at the same place wherever that is.
[[nodiscard]] bool sideIsFree(const Primitive& primitive);

}  // namespace rasterdiff::rasterizer
