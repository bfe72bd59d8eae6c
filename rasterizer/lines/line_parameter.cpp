#include "rasterizer/lines/line_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/lines/line_width.hpp"

namespace rasterdiff::rasterizer {
namespace {

LineParameter through(const FramebufferPosition& start, double dx, double dy) {
  return {-(start.x * dx + start.y * dy), dx, dy, 0};
}

}  // namespace

LineParameter lineParameter(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const FramebufferPosition &a = ends.a.position, &b = ends.b.position;
  const double x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
  if (!(length2 > 0)) return {};
  const LineKind kind = lineKind(style, rules.limits);
  // t = (p - a) · (b - a) / |b - a|²
  if (kind == LineKind::Rectangle) return through(a, x / length2, y / length2);
  const bool xMajor = std::fabs(x) >= std::fabs(y);
  LineParameter parameter = xMajor ? through(a, 1 / x, 0) : through(a, 0, 1 / y);
  // A point e pixels beside the line along the minor axis projects e · minor / |b - a|² farther.
  double beside = static_cast<double>(lineWidth(style.width, rules.limits).widest) / (2 * LineWidth::kUnit);
  const BresenhamWidth width = bresenhamWidth(style.width, rules.limits);
  beside = std::max(beside, static_cast<double>(std::max(width.nominal, width.other)) / 2);
  beside += kind == LineKind::Bresenham ? 2 : 1;  // centres of pixels, and fragments that may be one aside
  parameter.alternative = beside * (xMajor ? std::fabs(y) : std::fabs(x)) / length2;
  return parameter;
}

}  // namespace rasterdiff::rasterizer
