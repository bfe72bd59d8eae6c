// Lines of a device without strictLines, exactly: a parallelogram whose ends are parallel to the minor axis.
// [vk:primsrast-lines-basic] Samples on its edges follow the rules for polygons. // [vk:primsrast-polygons-basic]
#include <cstdlib>
#include <utility>

#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/lines/line_width.hpp"

namespace rasterdiff::rasterizer {
namespace {

class ParallelogramCoverage final : public LineCoverage {
 public:
  ParallelogramCoverage(SubpixelPosition a, SubpixelPosition b, int64_t width, const Rules& rules) : width_(width) {
    xMajor_ = std::llabs(int64_t{b.x} - a.x) >= std::llabs(int64_t{b.y} - a.y);
    if (xMajor_ ? a.x > b.x : a.y > b.y) std::swap(a, b);
    a_ = a;
    dx_ = int64_t{b.x} - a.x;
    dy_ = int64_t{b.y} - a.y;
    ownsLow_ = ownsLineTies(rules, dx_, dy_);
    ownsHigh_ = ownsLineTies(rules, -dx_, -dy_);
    // The ends of an x-major line run upward at its left and downward at its right, positively oriented.
    ownsStart_ = xMajor_ ? ownsLineTies(rules, 0, -1) : ownsLineTies(rules, 1, 0);
    ownsEnd_ = xMajor_ ? ownsLineTies(rules, 0, 1) : ownsLineTies(rules, -1, 0);
  }

  // 2 · cross ≤ 2^60; width · major ≤ 2^24 · 2^29
  bool covers(int64_t px, int64_t py, bool& tie) const override {
    tie = false;
    const int64_t x = px - a_.x, y = py - a_.y;
    const int64_t major = xMajor_ ? dx_ : dy_, along = xMajor_ ? x : y;
    if (along < 0 || along > major) return false;
    const int64_t cross = dx_ * y - dy_ * x;
    const int64_t low = 2 * cross + width_ * major, high = width_ * major - 2 * cross;
    if (low < 0 || high < 0) return false;
    tie = low == 0 || high == 0 || along == 0 || along == major;
    return (low > 0 || ownsLow_) && (high > 0 || ownsHigh_) && (along > 0 || ownsStart_) && (along < major || ownsEnd_);
  }

  ShapeFacts facts(int64_t px, int64_t py) const override {
    const int64_t x = px - a_.x, y = py - a_.y;
    const int64_t major = xMajor_ ? dx_ : dy_, along = xMajor_ ? x : y, cross = dx_ * y - dy_ * x;
    const int64_t low = 2 * cross + width_ * major, high = width_ * major - 2 * cross;
    const auto pixels = [](int64_t subpixels) { return static_cast<double>(subpixels) / kSubpixelOne; };
    const auto across = [&](int64_t value) { return static_cast<double>(value) / (2.0 * static_cast<double>(major)) / kSubpixelOne; };
    ShapeFacts facts;
    facts.sides = {{xMajor_ ? "upper side" : "right side", across(low), low == 0, ownsLow_},
                   {xMajor_ ? "lower side" : "left side", across(high), high == 0, ownsHigh_},
                   {xMajor_ ? "left end" : "upper end", pixels(along), along == 0, ownsStart_},
                   {xMajor_ ? "right end" : "lower end", pixels(major - along), along == major, ownsEnd_}};
    const double half = pixels(width_) / 2, aside = xMajor_ ? 0 : half, down = xMajor_ ? half : 0;
    for (const double sign : {-1.0, 1.0}) {
      facts.corners.push_back({pixels(a_.x) + sign * aside, pixels(a_.y) + sign * down, 0});
      facts.corners.push_back({pixels(a_.x + dx_) + sign * aside, pixels(a_.y + dy_) + sign * down, 0});
    }
    return facts;
  }

  double reach() const override { return static_cast<double>(width_) / 2 + 1; }

 private:
  SubpixelPosition a_;
  int64_t dx_ = 0, dy_ = 0;  ///< major component > 0
  int64_t width_;
  bool xMajor_ = true;
  bool ownsLow_ = false, ownsHigh_ = false, ownsStart_ = false, ownsEnd_ = false;
};

}  // namespace

std::unique_ptr<LineCoverage> parallelogramCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  if (ends.a.snapped == ends.b.snapped) return nullptr;
  return std::make_unique<ParallelogramCoverage>(ends.a.snapped, ends.b.snapped,
                                                 lineWidth(style.width, rules.limits).nominal, rules);
}

}  // namespace rasterdiff::rasterizer
