#include "rasterizer/lines/smooth_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rasterizer/fragment/place.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Outline = std::vector<Spot>;

/// The part of `outline` with inside(p) >= 0; inside is linear.
template <class Inside>
Outline cut(const Outline& outline, const Inside& inside) {
  Outline kept;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Spot& p = outline[i];
    const Spot& q = outline[(i + 1) % outline.size()];
    const double at = inside(p), next = inside(q);
    if (at >= 0) kept.push_back(p);
    if ((at < 0) != (next < 0)) {
      const double t = at / (at - next);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

double areaOf(const Outline& outline) {
  double twice = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Spot& p = outline[i];
    const Spot& q = outline[(i + 1) % outline.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return std::fabs(twice) / 2;
}

struct Rectangle {
  Spot centre;
  double alongX = 1, alongY = 0;            // unit vector along the line
  double halfLength = 0, halfWidth = 0.5;  // pixels

  /// Of the unit square at the origin that lies inside when the rectangle is `grown` pixels larger on each side.
  [[nodiscard]] double coverage(double grown) const {
    const double length = halfLength + grown, width = halfWidth + grown;
    if (length <= 0 || width <= 0) return 0;
    Outline part{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto along = [this](const Spot& p) { return (p.x - centre.x) * alongX + (p.y - centre.y) * alongY; };
    const auto across = [this](const Spot& p) { return (p.y - centre.y) * alongX - (p.x - centre.x) * alongY; };
    part = cut(part, [&](const Spot& p) { return length - along(p); });
    part = cut(part, [&](const Spot& p) { return length + along(p); });
    part = cut(part, [&](const Spot& p) { return width - across(p); });
    part = cut(part, [&](const Spot& p) { return width + across(p); });
    return std::clamp(areaOf(part), 0.0, 1.0);
  }
};

}  // namespace

bool drawsSmoothLines(const State& state) {
  return state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH && drawsLines(state);
}

Interval smoothCoverage(const RasterVertex& a, const RasterVertex& b, float width, const Limits& limits, int32_t x,
                        int32_t y) {
  const LineWidth supported = lineWidth(width, limits);
  const auto pixels = [](int64_t units) { return static_cast<double>(units) / LineWidth::kUnit; };
  const double dx = b.position.x - a.position.x, dy = b.position.y - a.position.y, length = std::hypot(dx, dy);
  Rectangle rectangle;
  rectangle.centre = {(a.position.x + b.position.x) / 2 - x, (a.position.y + b.position.y) / 2 - y};
  if (length > 0) {
    rectangle.alongX = dx / length;
    rectangle.alongY = dy / length;
  }
  rectangle.halfLength = length / 2;
  rectangle.halfWidth = pixels(supported.nominal) / 2;
  const auto boxOf = [](const RasterVertex& v) {
    return std::max(v.highest.x - v.lowest.x, v.highest.y - v.lowest.y) / double{kSubpixelOne};
  };
  const double ends = std::max({a.deviation, b.deviation, boxOf(a), boxOf(b)});
  const double slack = kSmoothSlack + ends;
  const double wider = pixels(supported.widest - supported.nominal) / 2;
  const double narrower = pixels(supported.nominal - supported.narrowest) / 2;
  return {rectangle.coverage(0), rectangle.coverage(-slack - narrower), rectangle.coverage(slack + wider)};
}

}  // namespace rasterdiff::rasterizer
