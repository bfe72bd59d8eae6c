// Bresenham lines under open rules. A device may use another algorithm than the diamond-exit rule if its fragments are
// at most one pixel aside and at most one more or one less: so no pixel by itself is certain, and all pixels that are
// no neighbour of an ideal one are out. What the fragments of one line must obey together is in bresenham_rules.hpp.
// [vk:primsrast-lines-bresenham]
#include <cstdlib>

#include "rasterizer/lines/end_box.hpp"
#include "rasterizer/lines/line_band.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "rasterizer/lines/stipple.hpp"
#include "rasterizer/methods/integer_division.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr int64_t kHalf = kSubpixelOne / 2;

struct MinorSpan {
  int64_t first = 0, last = -1;  ///< pixels, inclusive
};

/// The pixels that the diamond-exit rule may produce for some legal placement of the ends, for one choice of the major
/// axis. Coordinates are (major, minor).
class IdealPixels {
 public:
  IdealPixels(EndBox a, EndBox b, SubpixelPosition nominalA, SubpixelPosition nominalB, bool xMajor) : a_(a), b_(b) {
    ax_ = xMajor ? nominalA.x : nominalA.y;
    ay_ = xMajor ? nominalA.y : nominalA.x;
    bx_ = xMajor ? nominalB.x : nominalB.y;
    by_ = xMajor ? nominalB.y : nominalB.x;
    if (!xMajor) {
      std::swap(a_.x, a_.y);
      std::swap(b_.x, b_.y);
    }
    const auto away = [](int64_t nominal, Range r) { return std::max(nominal - r.low, r.high - nominal); };
    spread_ = std::max({away(ax_, a_.x), away(ay_, a_.y), away(bx_, b_.x), away(by_, b_.y)});
    direction_ = bx_ >= ax_ ? 1 : -1;
  }

  void moveMinor(int64_t subpixels) {
    ay_ += subpixels;
    by_ += subpixels;
    a_.y = {a_.y.low + subpixels, a_.y.high + subpixels};
    b_.y = {b_.y.low + subpixels, b_.y.high + subpixels};
  }

  /// A diamond is met if the line comes as near to its centre as ½ in |dx| + |dy|, nearest in the middle of its column
  /// or at the end before it. Moving both ends by m moves every point of the line by at most m each way.
  [[nodiscard]] MinorSpan inColumn(int64_t major) const {
    const int64_t centre = major * kSubpixelOne + kHalf;
    const int64_t nearest = std::clamp(centre, std::min(ax_, bx_), std::max(ax_, bx_));
    const int64_t room = kHalf + 2 * spread_ - std::llabs(centre - nearest);
    if (room < 0) return {};
    const Range crossing = minorAt(nearest);
    MinorSpan span{ceilDivide(crossing.low - room - kHalf, kSubpixelOne),
                   floorDivide(crossing.high + room - kHalf, kSubpixelOne)};
    while (span.first <= span.last && !endMayHaveLeft(major, span.first)) ++span.first;
    while (span.first <= span.last && !endMayHaveLeft(major, span.last)) --span.last;
    return span;
  }

  /// Pixels of a column that the line may pass through. Where the rule produces no fragment, the one that is allowed
  /// beyond its number can only be one of these, or one pixel aside of it.
  [[nodiscard]] MinorSpan touchedInColumn(int64_t major) const {
    const int64_t low = std::min(ax_, bx_), high = std::max(ax_, bx_);
    const int64_t left = major * kSubpixelOne, right = left + kSubpixelOne;
    if (right < low - spread_ || left > high + spread_) return {};
    const Range from = minorAt(std::clamp(left, low, high)), to = minorAt(std::clamp(right, low, high));
    return {floorDivide(std::min(from.low, to.low) - 2 * spread_, kSubpixelOne),
            floorDivide(std::max(from.high, to.high) + 2 * spread_, kSubpixelOne)};
  }

  /// Number of fragments before `major` on the way, if every column had one, and the first column had the start in it.
  [[nodiscard]] int64_t stepsTo(int64_t major) const { return (major - floorDivide(ax_, kSubpixelOne)) * direction_; }

 private:
  /// The nominal line at a major coordinate between its ends, between two integers. // ≤ 2^60
  [[nodiscard]] Range minorAt(int64_t major) const {
    const int64_t run = std::llabs(bx_ - ax_), rise = (by_ - ay_) * direction_;
    if (run == 0) return {std::min(ay_, by_), std::max(ay_, by_)};
    const int64_t crossing = ay_ * run + rise * (major - ax_);
    return {floorDivide(crossing, run), ceilDivide(crossing, run)};
  }

  // The line must leave the diamond: an end that is surely inside does not, nor does one that is before its middle.
  [[nodiscard]] bool endMayHaveLeft(int64_t major, int64_t minor) const {
    const int64_t x = major * kSubpixelOne + kHalf, y = minor * kSubpixelOne + kHalf;
    const int64_t farX = std::max(std::llabs(b_.x.low - x), std::llabs(b_.x.high - x));
    const int64_t farY = std::max(std::llabs(b_.y.low - y), std::llabs(b_.y.high - y));
    const bool mayPassMiddle = direction_ > 0 ? b_.x.high >= x : b_.x.low <= x;
    return mayPassMiddle && farX + farY >= kHalf;
  }

  EndBox a_, b_;
  int64_t ax_ = 0, ay_ = 0, bx_ = 0, by_ = 0;
  int64_t spread_ = 0;
  int64_t direction_ = 1;
};

struct Variant {
  bool xMajor;
  int64_t width;
  IdealPixels ideal;
};

class BresenhamBand final : public LineBand {
 public:
  BresenhamBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style, const Rules& rules)
      : stipple_(style.stipple), ofPolygon_(style.ofPolygon) {
    const EndBox boxA(a), boxB(b);
    const Range x = magnitudes(boxB.x - boxA.x), y = magnitudes(boxB.y - boxA.y);
    const BresenhamWidth width = bresenhamWidth(style.width, rules.limits);
    const auto add = [&](bool xMajor, int64_t w) {
      IdealPixels ideal(boxA, boxB, a.snapped, b.snapped, xMajor);
      ideal.moveMinor(-(w - 1) * kHalf);
      variants_.push_back({xMajor, w, ideal});
    };
    for (const bool xMajor : {true, false}) {
      if (xMajor ? x.high < y.low : y.high <= x.low) continue;
      add(xMajor, width.nominal);
      if (width.other != width.nominal) add(xMajor, width.other);
    }
    reach_ = static_cast<double>(std::max(width.nominal, width.other) + 6) / 2 * kSubpixelOne +
             static_cast<double>(boxA.size() + boxB.size());
  }

  BandVerdict classify(int64_t px, int64_t py) const override {
    const int64_t x = px >> kSubpixelBits, y = py >> kSubpixelBits;
    for (const Variant& variant : variants_) {
      const int64_t major = variant.xMajor ? x : y, minor = variant.xMajor ? y : x;
      if (!mayProduce(variant, major, minor) || !mayDraw(variant, major)) continue;
      const bool unknown = stipple_.enabled && stipple_.start.free;
      return {Coverage::Either, unknown ? (ofPolygon_ ? Freedom::StippleCarry : Freedom::LineClip) : Freedom::BresenhamDeviation, std::nullopt};
    }
    return {};
  }

  double reach() const override { return reach_; }

 private:
  /// A fragment one pixel aside of an ideal one, or one of the width - 1 that follow it in its column.
  [[nodiscard]] static bool mayProduce(const Variant& variant, int64_t major, int64_t minor) {
    const MinorSpan touched = variant.ideal.touchedInColumn(major);
    if (touched.first <= touched.last && minor >= touched.first - 1 && minor <= touched.last + variant.width) return true;
    for (int64_t column = major - 1; column <= major + 1; ++column) {
      const MinorSpan span = variant.ideal.inColumn(column);
      if (span.first <= span.last && minor >= span.first - 1 && minor <= span.last + variant.width) return true;
    }
    return false;
  }

  /// The fragment's number along the line is known up to the deviations at the start: one column aside, one fragment
  /// more or less, a start that is not in the column of its pixel, and the legal places of the start.
  [[nodiscard]] bool mayDraw(const Variant& variant, int64_t major) const {
    constexpr int64_t kDeviation = 4;
    if (!stipple_.enabled) return true;
    if (stipple_.start.free) return stippleOutcome(stipple_).mayDraw;
    const int64_t steps = variant.ideal.stepsTo(major);
    const auto counter = [](uint64_t start, int64_t offset) {
      return start + static_cast<uint64_t>(std::max<int64_t>(offset, 0));
    };
    return stippleOutcome(stipple_, counter(stipple_.start.lowest, steps - kDeviation),
                          counter(stipple_.start.highest, steps + kDeviation))
        .mayDraw;
  }

  LineStipple stipple_;
  bool ofPolygon_ = false;
  std::vector<Variant> variants_;
  double reach_ = 0;
};

}  // namespace

std::unique_ptr<LineBand> bresenhamBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style,
                                        const Rules& rules) {
  const EndBox boxA(a), boxB(b);
  if (boxA.fixed() && boxA == boxB) return nullptr;
  return std::make_unique<BresenhamBand>(a, b, style, rules);
}

}  // namespace rasterdiff::rasterizer
