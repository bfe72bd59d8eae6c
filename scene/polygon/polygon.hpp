// A polygon on the subpixel grid: one contour and the rule that says what it encloses. Filling pixels is left to
// rasterizer/methods, cutting into triangles to triangulation.hpp.
#pragma once

#include <vector>

#include "scene/result.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff {

/// One closed contour (the last vertex is joined to the first), in any winding; it may be concave and cross itself.
struct Polygon {
  std::vector<SubpixelPosition> vertices;
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

enum class FillRule : uint8_t {
  EvenOdd,  ///< inside where the winding number is odd (parity)
  NonZero,  ///< inside where it is not zero
};

inline constexpr size_t kMaxPolygonVertices = size_t{1} << 20;
/// Largest |coordinate|, 1/256 pixel, that keeps all products of the polygon methods within 64 bits.
inline constexpr int32_t kMaxPolygonCoordinate = 1 << 28;

/// At least three vertices, at most kMaxPolygonVertices, all coordinates in range. Error: BadInput.
[[nodiscard]] Result<void> checkPolygon(const Polygon& polygon);

}  // namespace rasterdiff
