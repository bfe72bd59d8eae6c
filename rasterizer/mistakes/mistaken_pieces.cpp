#include "rasterizer/mistakes/mistaken_pieces.hpp"

#include <algorithm>
#include <bit>

namespace rasterdiff::rasterizer {
namespace {

using enum DeliberateError;

/// Sign of the area of the uncut triangle, as if a vertex behind the eye were where its quotients say.
bool turnsBehindEye(const Primitive& primitive) {
  return std::ranges::count_if(primitive.clip, [](const ClipPosition& p) { return p.w < 0; }) % 2 == 1;
}

/// The nearest number of 10 significant bits.
int64_t tenBits(int64_t value) {
  const auto magnitude = static_cast<uint64_t>(value < 0 ? -value : value);
  const int excess = std::max(0, static_cast<int>(std::bit_width(magnitude)) - 10);
  const auto kept = static_cast<int64_t>((magnitude + (excess > 0 ? uint64_t{1} << (excess - 1) : 0)) >> excess << excess);
  return value < 0 ? -kept : kept;
}

}  // namespace

bool mistakenFacing(bool front, const Primitive& primitive, DeliberateError error) {
  if (error == SwappedWinding) return !front;
  if (error == FacingUnflipped) return front != (primitive.viewport.y.scale < 0);
  if (error == FacingBehindEye) return front != turnsBehindEye(primitive);
  return front;
}

void mistakeEdges(std::array<EdgeFunction, 3>& edges, DeliberateError error) {
  for (EdgeFunction& edge : edges) {
    const bool horizontal = edge.dy == 0, vertical = edge.dx == 0;
    if (error == TiesCoveredByBoth || (error == TiesHorizontalBoth && horizontal) ||
        (error == TiesSlantedBoth && !horizontal && !vertical)) {
      edge.ownsTies = true;
    }
    if (error == TiesCoveredByNone || (error == TiesVerticalNone && vertical)) edge.ownsTies = false;
    if (error == EdgeTenBits) {
      edge.dx = tenBits(edge.dx);
      edge.dy = tenBits(edge.dy);
    }
  }
}

}  // namespace rasterdiff::rasterizer
