// Through which points the planes of a triangle's values are laid. [choice:plane-positions]
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

struct PlaneCorners {
  std::array<FramebufferPosition, 3> corners;
  double deviation = 0;  ///< pixels by which a legal corner may be elsewhere, in x and in y
};

/// Which of its answers the choice has, under closed rules or open ones.
struct PlanePlaces {
  bool snapped = false, either = false;
  explicit PlanePlaces(const Rules& rules)
      : snapped(rules.choices.planePositions != PlanePositions::Unsnapped && !rules.open),
        either(isOpen(rules, Choice::PlanePositions) && !rules.open) {}
};

[[nodiscard]] inline PlaneCorners planeCorners(const PlanePlaces& places, const std::array<const RasterVertex*, 3>& v) {
  PlaneCorners result;
  for (size_t i = 0; i < 3; ++i) {
    FramebufferPosition& corner = result.corners[i];
    corner = v[i]->position;
    const double x = v[i]->snapped.x / double{kSubpixelOne}, y = v[i]->snapped.y / double{kSubpixelOne};
    if (places.snapped) {
      corner.x = x;
      corner.y = y;
      continue;
    }
    result.deviation = std::max(result.deviation, v[i]->deviation);
    if (places.either) result.deviation = std::max({result.deviation, std::fabs(corner.x - x), std::fabs(corner.y - y)});
  }
  return result;
}

}  // namespace rasterdiff::rasterizer
