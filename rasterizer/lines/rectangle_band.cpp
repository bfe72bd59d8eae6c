// Rectangular lines under open rules: distance and projection over all places of the ends, in integers.
// [vk:primsrast-lines-basic]
#include <cmath>

#include "rasterizer/lines/end_box.hpp"
#include "rasterizer/lines/line_band.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "rasterizer/lines/smooth_line.hpp"
#include "rasterizer/lines/stipple.hpp"
#include "rasterizer/snap.hpp"

namespace rasterdiff::rasterizer {
namespace {

class RectangleBand final : public LineBand {
 public:
  RectangleBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style, const Rules& rules)
      : a_(a),
        b_(b),
        width_(lineWidth(style.width, rules.limits)),
        stipple_(style.stipple),
        length2_(squaredLength(a_, b_)) {
    const int64_t step = kSubpixelOne >> gridBits(rules);
    fixed_ = a_.fixed() && b_.fixed();
    ofPolygon_ = style.ofPolygon;
    smooth_ = style.mode == LineRasterizationMode::RECTANGULAR_SMOOTH;
    cornerMargin2_ = hasExactCorners(step) ? 0 : 3 * step + turn2();
    reach_ = static_cast<double>(width_.widest + cornerMargin2_) / 2 + static_cast<double>(a_.size() + b_.size()) + 2;
    if (smooth_) reach_ += 2 * kSmoothReach2;  // of any sample of such a pixel
    if (length2_.low == 0) reach_ += static_cast<double>(width_.widest);
  }

  BandVerdict classify(int64_t px, int64_t py) const override {
    if (smooth_) return classifySmooth(px, py);
    BandVerdict verdict = classifyOutline(px, py);
    if (verdict.coverage != Coverage::Out && stipple_.enabled) verdict = stippled(px, py, verdict);
    return verdict;
  }

  bool classifiesPixels() const override { return smooth_; }

  double reach() const override { return reach_; }

 private:
  // The ends' products are computed once a sample, and compared for each nested set of freedoms.
  struct Products {
    Range fromA, fromB;  ///< projection on the line, from either end
    Range cross;         ///< signed distance times length
  };

  [[nodiscard]] BandVerdict classifyOutline(int64_t px, int64_t py) const {
    if (length2_.low == 0) return {Coverage::Either, Freedom::SnapRounding, std::nullopt};  // within reach()
    const Products products{alongRange(px, py, a_, b_), alongRange(px, py, b_, a_), crossRange(px, py, a_, b_)};
    const Coverage all = decide(products, width_.narrowest, width_.widest, cornerMargin2_);
    if (all != Coverage::Either) return {all, Freedom::None, std::nullopt};
    Freedom freedom = Freedom::LineCorner;
    if (decide(products, width_.nominal, width_.nominal, 0) == Coverage::Either) {
      freedom = fixed_ ? Freedom::TieOwner : a_.made || b_.made ? Freedom::ClipVertexPosition : Freedom::SnapRounding;
    } else if (decide(products, width_.narrowest, width_.widest, 0) == Coverage::Either) {
      freedom = Freedom::LineWidthStep;
    }
    return {Coverage::Either, freedom, std::nullopt};
  }

  // [vk:primsrast-lines-smooth] a pixel as a whole, by its centre; what a stipple leaves out, smoothing may touch.
  [[nodiscard]] BandVerdict classifySmooth(int64_t px, int64_t py) const {
    constexpr int64_t kHalf = kSubpixelOne / 2;
    const auto centre = [](int64_t p) { return (p >> kSubpixelBits) * kSubpixelOne + kHalf; };
    const BandVerdict free{Coverage::Either, Freedom::SmoothLine, std::nullopt};
    if (length2_.low == 0) return free;  // within reach()
    const int64_t x = centre(px), y = centre(py);
    const Products products{alongRange(x, y, a_, b_), alongRange(x, y, b_, a_), crossRange(x, y, a_, b_)};
    const bool inside =
        decide(products, width_.narrowest, width_.widest, cornerMargin2_ + kSmoothInside2) == Coverage::In;
    if (inside) return stipple_.enabled ? free : BandVerdict{Coverage::In, Freedom::None, std::nullopt};
    if (decide(products, width_.narrowest, width_.widest, cornerMargin2_ + kSmoothReach2) == Coverage::Out) return {};
    return free;
  }

  // `margin2`: twice the distance by which the outline may be off, 1/256 pixel. Distances from the edges that are
  // larger than the margin decide; they are compared as squares, times the largest or smallest squared length.
  // // along² ≤ 2^120, margin2² · length² ≤ 2^44 · 2^60
  [[nodiscard]] Coverage decide(const Products& p, int64_t narrowest, int64_t widest, int64_t margin2) const {
    const Int128 farEnough = squared(margin2) * length2_.high;
    const auto inside = [&](int64_t along) { return along > 0 && 4 * squared(along) > farEnough; };
    const auto outside = [&](int64_t along) { return along < 0 && 4 * squared(along) > farEnough; };
    const Range across = magnitudes(p.cross);
    const int64_t out = widest + margin2, in = narrowest - margin2;
    if (outside(p.fromA.high) || outside(p.fromB.high) || 4 * squared(across.low) > squared(out) * length2_.high) {
      return Coverage::Out;
    }
    const bool covered =
        inside(p.fromA.low) && inside(p.fromB.low) && in > 0 && 4 * squared(across.high) < squared(in) * length2_.low;
    return covered ? Coverage::In : Coverage::Either;
  }

  // Corners that are points of the grid by themselves stay.
  [[nodiscard]] bool hasExactCorners(int64_t step) const {
    if (!fixed_ || width_.narrowest != width_.widest || length2_.low == 0) return false;
    const int64_t length = squareRoot(length2_.low);
    if (squared(length) != length2_.low) return false;
    const auto onGrid = [&](Range from, Range to) {
      return width_.nominal * (to.low - from.low) % (2 * length * step) == 0;
    };
    return onGrid(a_.x, b_.x) && onGrid(a_.y, b_.y);
  }

  // The outline may be turned by ends that were snapped (or not) differently where its direction is computed: its
  // corners move by width / 2 · Δend / length each way, and never by more than the width.
  [[nodiscard]] int64_t turn2() const {
    const int64_t length = squareRoot(length2_.low);
    const int64_t most = 2 * width_.widest;
    if (length == 0) return most;
    return std::min(most, (width_.widest * (a_.size() + b_.size()) + length - 1) / length);
  }

  [[nodiscard]] BandVerdict stippled(int64_t px, int64_t py, const BandVerdict& outline) const {
    StippleOutcome plain, carried;
    if (stipple_.start.free || length2_.low == 0) {
      plain = carried = stippleOutcome(stipple_);
    } else {
      // Distance along the line, 1/256 pixel; dashes are cut with float32 positions and snapped.
      const Range along = alongRange(px, py, a_, b_);
      const int64_t slack = cornerMargin2_ + 3;
      const int64_t nearest = along.low > 0 ? squareRoot(squared(along.low) / length2_.high) - slack : 0;
      const int64_t farthest = along.high > 0 ? squareRootUp(squared(along.high) / length2_.low + 1) + slack : slack;
      const auto unit = [](int64_t subpixels) {
        return static_cast<uint64_t>(std::max<int64_t>(0, subpixels)) >> kSubpixelBits;
      };
      plain = stippleOutcome(stipple_, stipple_.start.lowest + unit(nearest), stipple_.start.highest + unit(farthest));
      const auto low = static_cast<int64_t>(std::floor(stipple_.start.carried - stipple_.start.uncertainty));
      const auto high = static_cast<int64_t>(std::ceil(stipple_.start.carried + stipple_.start.uncertainty));
      carried = stippleOutcome(stipple_, unit(low + nearest), unit(high + farthest));
    }
    StippleOutcome outcome = plain;
    outcome.add(carried);
    if (!outcome.mayDraw) return {};
    if (!outcome.mayDiscard) return outline;
    Freedom freedom = fixed_ ? Freedom::LineCorner : Freedom::SnapRounding;
    if (plain.certain()) freedom = Freedom::StippleCarry;
    if (stipple_.start.free) freedom = ofPolygon_ ? Freedom::StippleCarry : Freedom::LineClip;
    return {Coverage::Either, freedom, std::nullopt};
  }

  EndBox a_, b_;
  LineWidth width_;
  LineStipple stipple_;
  Range length2_;
  bool fixed_ = false, smooth_ = false, ofPolygon_ = false;
  int64_t cornerMargin2_ = 0;
  double reach_ = 0;
};

}  // namespace

std::unique_ptr<LineBand> rectangleBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style,
                                        const Rules& rules) {
  const EndBox boxA(a), boxB(b);
  const bool smooth = style.mode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  if (!smooth && boxA.fixed() && boxA == boxB) return nullptr;
  return std::make_unique<RectangleBand>(a, b, style, rules);
}

}  // namespace rasterdiff::rasterizer
