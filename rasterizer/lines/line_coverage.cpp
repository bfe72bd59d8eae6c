#include "rasterizer/lines/line_coverage.hpp"

#include "rasterizer/mistakes/mistaken_line.hpp"

namespace rasterdiff::rasterizer {

bool ownsLineTies(const Rules& rules, int64_t dx, int64_t dy) {
  switch (rules.error) {
    case DeliberateError::TiesCoveredByBoth:
      return true;
    case DeliberateError::TiesCoveredByNone:
      return false;
    case DeliberateError::TieOwnerBottomRight:
      return ownsTies(TieOwner::BottomRight, dx, dy);
    default:
      return ownsTies(tieRule(rules.choices), dx, dy);
  }
}

std::unique_ptr<LineCoverage> lineCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  if (ends.removed) return nullptr;
  if (rules.error != DeliberateError::None) {
    if (std::optional<std::unique_ptr<LineCoverage>> mistaken = mistakenLine(ends, style, rules)) return std::move(*mistaken);
  }
  if (rules.choices.lineArithmetic == LineArithmetic::Float32Corners) return floatCornerCoverage(ends, style, rules);
  switch (lineKind(style, rules.limits)) {
    case LineKind::Rectangle:
      return rectangleCoverage(ends, style, rules);
    case LineKind::Parallelogram:
      if (rules.variation && rules.variation->bresenhamByDefault) return bresenhamCoverage(ends, style, rules);
      return parallelogramCoverage(ends, style, rules);
    case LineKind::Bresenham:
      return bresenhamCoverage(ends, style, rules);
  }
  return nullptr;
}

}  // namespace rasterdiff::rasterizer
