#include "rasterizer/lines/line_reach.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kRounding = 2;  // 1/256 pixel

int32_t pixelOf(double subpixels) { return static_cast<int32_t>(std::floor(subpixels / kSubpixelOne)); }

}  // namespace

LineReach::LineReach(SubpixelPosition a, SubpixelPosition b, double distance) : distance_(distance + kRounding) {
  if (a.y > b.y) std::swap(a, b);
  topX_ = a.x;
  topY_ = a.y;
  bottomX_ = b.x;
  bottomY_ = b.y;
}

Shape::Rows LineReach::rows() const { return {pixelOf(topY_ - distance_), pixelOf(bottomY_ + distance_)}; }

RowSpan LineReach::columns(int32_t y) const {
  const double low = double{kSubpixelOne} * y - distance_, high = double{kSubpixelOne} * (y + 1.0) + distance_;
  if (high < topY_ || low > bottomY_) return {};
  // The part of the segment that is near enough to the row.
  const double height = bottomY_ - topY_;
  const auto at = [&](double rowY) {
    if (rowY <= topY_) return topX_;
    if (rowY >= bottomY_) return bottomX_;
    return topX_ + (bottomX_ - topX_) * ((rowY - topY_) / height);
  };
  double from = topX_, to = bottomX_;
  if (height > 0) {
    from = at(low);
    to = at(high);
  }
  return {pixelOf(std::min(from, to) - distance_), pixelOf(std::max(from, to) + distance_) + 1};
}

Shape::Rows both(Shape::Rows a, Shape::Rows b) {
  if (a.first > a.last) return b;
  if (b.first > b.last) return a;
  return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

RowSpan both(RowSpan a, RowSpan b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

}  // namespace rasterdiff::rasterizer
