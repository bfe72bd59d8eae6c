#include "rasterizer/methods/diamond_exit.hpp"

#include <algorithm>
#include <cstdlib>

#include "rasterizer/methods/integer_division.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr int64_t kHalf = kSubpixelOne / 2;

int64_t centreOf(int64_t pixel) { return pixel * kSubpixelOne + kHalf; }

}  // namespace

// Why one column has at most one pixel, and where the line leaves it: along a line with |slope| ≤ 1 the distance
// |x - xc| + |y - yc| is smallest at x = xc. So the column's diamond is the one in whose middle the line crosses
// x = xc; the line enters before that crossing and leaves after it. A segment produces the pixel if its start has not
// left the diamond yet and its end has.
DiamondLine::DiamondLine(SubpixelPosition a, SubpixelPosition b, DiamondRule rule) : rule_(rule), a_(a) {
  const int64_t dx = int64_t{b.x} - a.x, dy = int64_t{b.y} - a.y;
  xMajor_ = std::abs(dx) >= std::abs(dy);
  const int64_t along = xMajor_ ? dx : dy;
  if (along == 0) return;
  direction_ = along > 0 ? 1 : -1;
  run_ = std::abs(along);
  rise_ = (xMajor_ ? dy : dx) * direction_;

  // An end has left every diamond of columns that are two behind its own, and none of those ahead.
  first_ = floorDivide(xMajor_ ? a.x : a.y, kSubpixelOne) - 2 * direction_;
  while (hasLeft(a, first_)) first_ += direction_;
  int64_t last = floorDivide(xMajor_ ? b.x : b.y, kSubpixelOne) + 2 * direction_;
  while (!hasLeft(b, last)) last -= direction_;
  count_ = std::max<int64_t>(0, (last - first_) * direction_ + 1);
}

DiamondLine::Crossing DiamondLine::crossingAt(int64_t major) const {
  const int64_t startMajor = xMajor_ ? a_.x : a_.y, startMinor = xMajor_ ? a_.y : a_.x;
  // crossing · run, 1/65536 pixel²  // 2^30 · 2^29 + 2^30 · 2^30 ≤ 2^61
  return {run_ * startMinor + rise_ * (centreOf(major) - startMajor), run_ * kSubpixelOne};
}

/// Row (x-major) or column (y-major) of the diamond that the line crosses in the middle of a column or row.
int64_t DiamondLine::minor(int64_t major) const {
  const auto [crossing, divisor] = crossingAt(major);
  const int64_t pixel = floorDivide(crossing, divisor);
  if (floorRemainder(crossing, divisor) != 0) return pixel;
  // Exactly between two diamonds. Vulkan's shift moves an x-major line's crossing by ε · slope - ε², a y-major line's
  // by -ε + ε² · slope; Direct3D's bottom (right) corner belongs to the upper (left) diamond.
  const bool movedForward = rule_ == DiamondRule::Vulkan && xMajor_ && rise_ > 0;
  return movedForward ? pixel : pixel - 1;
}

PixelIndex DiamondLine::at(int64_t major) const {
  const auto along = static_cast<int32_t>(major), across = static_cast<int32_t>(minor(major));
  return xMajor_ ? PixelIndex{along, across} : PixelIndex{across, along};
}

/// Is the point at (dx, dy) from a pixel centre in its diamond?
bool DiamondLine::contains(int64_t dx, int64_t dy) const {
  const int64_t distance = std::abs(dx) + std::abs(dy);
  if (distance != kHalf) return distance < kHalf;
  // Moved by -(ε, ε²), points on the right edges come in, those on the left edges and the top and bottom corners go
  // out.
  if (rule_ == DiamondRule::Vulkan) return dx > 0;
  // The right corner is level with the centre: for y-major lines `hasLeft` never asks, and x-major ones do not own it.
  return dy > 0;
}

/// Is an end of the segment (on the line, after moving) behind the place where the line leaves the diamond?
bool DiamondLine::hasLeft(SubpixelPosition end, int64_t major) const {
  const PixelIndex pixel = at(major);
  const int64_t beyond = ((xMajor_ ? end.x : end.y) - centreOf(major)) * direction_;
  // A point that is level with the centre is inside, or on a border and moved backwards: out of the diamond, behind
  // the centre if the line runs towards smaller coordinates.
  const bool behindCentre = beyond > 0 || (beyond == 0 && rule_ == DiamondRule::Vulkan && direction_ < 0);
  return behindCentre && !contains(end.x - centreOf(pixel.x), end.y - centreOf(pixel.y));
}

DiamondLine::Range DiamondLine::within(const PixelArea& area) const {
  const int64_t low = xMajor_ ? area.left : area.top, high = xMajor_ ? area.right : area.bottom;  // low ≤ major < high
  const int64_t begin = direction_ > 0 ? low - first_ : first_ - (high - 1);
  const int64_t end = direction_ > 0 ? high - first_ : first_ - low + 1;
  const int64_t from = std::clamp<int64_t>(begin, 0, count_);
  return {from, std::clamp<int64_t>(end, from, count_)};
}

std::vector<PixelIndex> diamondExitPixels(SubpixelPosition a, SubpixelPosition b, DiamondRule rule,
                                          const PixelArea& area) {
  const DiamondLine line(a, b, rule);
  const DiamondLine::Range range = line.within(area);
  std::vector<PixelIndex> pixels;
  pixels.reserve(static_cast<size_t>(range.end - range.begin));
  for (int64_t i = range.begin; i < range.end; ++i) {
    const PixelIndex pixel = line.pixel(i);
    if (area.contains(pixel.x, pixel.y)) pixels.push_back(pixel);
  }
  return pixels;
}

}  // namespace rasterdiff::rasterizer
