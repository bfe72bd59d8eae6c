#include "scene/polygon/polygon.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace rasterdiff {

Result<void> checkPolygon(const Polygon& polygon) {
  const size_t count = polygon.vertices.size();
  if (count < 3 || count > kMaxPolygonVertices) {
    return fail(ErrorCode::BadInput, "polygon", fmt::format("a polygon of {} vertices", count),
                fmt::format("give 3 to {} vertices", kMaxPolygonVertices));
  }
  for (size_t i = 0; i < count; ++i) {
    const SubpixelPosition p = polygon.vertices[i];
    if (std::abs(int64_t{p.x}) > kMaxPolygonCoordinate || std::abs(int64_t{p.y}) > kMaxPolygonCoordinate) {
      return fail(ErrorCode::BadInput, fmt::format("polygon vertex {}", i), "a coordinate is out of range",
                  fmt::format("keep within ±{} pixels", kMaxPolygonCoordinate / kSubpixelOne));
    }
  }
  return {};
}

}  // namespace rasterdiff
