// Rectangular lines, exactly: the distance from the segment and the projection on it are compared as squares, so that
// no square root is taken. Stippled ones are cut into rectangles of unit length. [vk:primsrast-lines-basic]
#include <cmath>

#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "rasterizer/lines/stipple.hpp"
#include "rasterizer/lines/wide_integer.hpp"

namespace rasterdiff::rasterizer {
namespace {

class RectangleCoverage final : public LineCoverage {
 public:
  RectangleCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules)
      : a_(ends.a.snapped),
        dx_(int64_t{ends.b.snapped.x} - a_.x),
        dy_(int64_t{ends.b.snapped.y} - a_.y),
        width_(lineWidth(style.width, rules.limits).nominal),
        stipple_(style.stipple),
        // The outline a - n, b - n, b + n, a + n with n along (-dy, dx) is positively oriented.
        ownsLow_(ownsLineTies(rules, dx_, dy_)),
        ownsHigh_(ownsLineTies(rules, -dx_, -dy_)),
        ownsStart_(ownsLineTies(rules, dy_, -dx_)),
        ownsEnd_(ownsLineTies(rules, -dy_, dx_)) {}

  // Differences ≤ 2^29, px - ax ≤ 2^28 + 2^23: cross and along ≤ 2^59, their squares ≤ 2^118.
  bool covers(int64_t px, int64_t py, bool& tie) const override {
    tie = false;
    const int64_t x = px - a_.x, y = py - a_.y;
    const int64_t along = x * dx_ + y * dy_, length2 = dx_ * dx_ + dy_ * dy_;
    if (along < 0 || along > length2) return false;
    const int64_t cross = dx_ * y - dy_ * x;
    const Int128 beyond = 4 * squared(cross) - squared(width_) * length2;  // |cross| against width / 2 · length
    if (beyond > 0) return false;
    bool owned = true;
    if (beyond == 0) owned = cross < 0 ? ownsLow_ : ownsHigh_;
    if (along == 0) owned = owned && ownsStart_;
    if (along == length2) owned = owned && ownsEnd_;
    tie = beyond == 0 || along == 0 || along == length2;
    if (!owned || !stipple_.enabled) return owned;
    return stipple_.draws(stipple_.start.s + static_cast<uint64_t>(unitRectangle(along, length2)));
  }

  ShapeFacts facts(int64_t px, int64_t py) const override {
    const int64_t x = px - a_.x, y = py - a_.y;
    const int64_t along = x * dx_ + y * dy_, length2 = dx_ * dx_ + dy_ * dy_, cross = dx_ * y - dy_ * x;
    const bool onSide = 4 * squared(cross) == squared(width_) * length2;
    const double length = std::sqrt(static_cast<double>(length2)), half = static_cast<double>(width_) / 2;
    const double across = static_cast<double>(cross) / length, forward = static_cast<double>(along) / length;
    ShapeFacts facts;
    facts.sides = {{"left side", (half + across) / kSubpixelOne, onSide && cross < 0, ownsLow_},
                   {"right side", (half - across) / kSubpixelOne, onSide && cross > 0, ownsHigh_},
                   {"start", forward / kSubpixelOne, along == 0, ownsStart_},
                   {"end", (length - forward) / kSubpixelOne, along == length2, ownsEnd_}};
    const double nx = -static_cast<double>(dy_) / length * half, ny = static_cast<double>(dx_) / length * half;
    const auto corner = [&](double cx, double cy) { facts.corners.push_back({cx / kSubpixelOne, cy / kSubpixelOne, 0}); };
    const double bx = static_cast<double>(a_.x + dx_), by = static_cast<double>(a_.y + dy_);
    corner(a_.x - nx, a_.y - ny);
    corner(bx - nx, by - ny);
    corner(bx + nx, by + ny);
    corner(a_.x + nx, a_.y + ny);
    if (stipple_.enabled && along >= 0 && along <= length2) {
      facts.stipple = stippleFacts(stipple_, stipple_.start.s + static_cast<uint64_t>(unitRectangle(along, length2)));
    }
    return facts;
  }

  double reach() const override { return static_cast<double>(width_) / 2 + 1; }

 private:
  // ⌊along / length⌋ in pixels; a sample between two rectangles is in the one that owns its edge.
  [[nodiscard]] int64_t unitRectangle(int64_t along, int64_t length2) const {
    const int64_t subpixels = squareRoot(squared(along) / length2);  // ⌊⌋ of a quotient of squares is exact
    const int64_t unit = subpixels / kSubpixelOne;
    const bool between = unit > 0 && squared(unit * kSubpixelOne) * length2 == squared(along);
    return between && !ownsStart_ ? unit - 1 : unit;
  }

  SubpixelPosition a_;
  int64_t dx_, dy_;
  int64_t width_;
  LineStipple stipple_;
  bool ownsLow_, ownsHigh_, ownsStart_, ownsEnd_;
};

}  // namespace

std::unique_ptr<LineCoverage> rectangleCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  if (ends.a.snapped == ends.b.snapped) return nullptr;
  return std::make_unique<RectangleCoverage>(ends, style, rules);
}

}  // namespace rasterdiff::rasterizer
