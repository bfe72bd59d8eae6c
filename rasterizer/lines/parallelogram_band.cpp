// Lines without strictLines under open rules, as parallelograms: edge functions over all places of the ends.
// [vk:primsrast-lines-basic]
#include "rasterizer/lines/end_box.hpp"
#include "rasterizer/lines/line_band.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "rasterizer/snap.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// One choice of the major axis; coordinates are (major, minor), and b comes after a along the major axis.
class MajorAxis {
 public:
  MajorAxis(EndBox a, EndBox b, bool xMajor) : xMajor_(xMajor) {
    if (!xMajor) {
      std::swap(a.x, a.y);
      std::swap(b.x, b.y);
    }
    if (a.x.low + a.x.high > b.x.low + b.x.high) std::swap(a, b);
    a_ = a;
    b_ = b;
  }

  /// A legal placement may have no length, or run the other way.
  [[nodiscard]] bool degenerate() const { return a_.x.high >= b_.x.low; }

  /// Half-widths are narrowest / 2 and widest / 2 // 2 · cross ≤ 2^61, width · major ≤ 2^24 · 2^30
  [[nodiscard]] Coverage decide(int64_t px, int64_t py, int64_t narrowest, int64_t widest) const {
    const int64_t along = xMajor_ ? px : py, across = xMajor_ ? py : px;
    if (along < a_.x.low || along > b_.x.high) return Coverage::Out;
    bool in = along > a_.x.high && along < b_.x.low;
    bool below = true, above = true;  // beyond an edge for every placement
    forEachPlacement(a_, b_, [&](int64_t ax, int64_t ay, int64_t bx, int64_t by) {
      const int64_t cross = 2 * ((bx - ax) * (across - ay) - (by - ay) * (along - ax));
      const int64_t inner = narrowest * (bx - ax), outer = widest * (bx - ax);
      in = in && cross > -inner && cross < inner;
      below = below && cross > outer;
      above = above && cross < -outer;
    });
    if (below || above) return Coverage::Out;
    return in ? Coverage::In : Coverage::Either;
  }

 private:
  bool xMajor_;
  EndBox a_, b_;
};

class ParallelogramBand final : public LineBand {
 public:
  ParallelogramBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style, const Rules& rules)
      : width_(lineWidth(style.width, rules.limits)) {
    const EndBox boxA(a), boxB(b);
    fixed_ = boxA.fixed() && boxB.fixed();
    made_ = a.made || b.made;
    const Range x = magnitudes(boxB.x - boxA.x), y = magnitudes(boxB.y - boxA.y);
    if (x.high >= y.low) axes_.emplace_back(boxA, boxB, true);
    if (y.high > x.low) axes_.emplace_back(boxA, boxB, false);
    const int64_t step = kSubpixelOne >> gridBits(rules);
    const bool exact = width_.narrowest == width_.widest && width_.nominal % (2 * step) == 0;
    cornerMargin2_ = exact ? 0 : 2 * step;
    reach_ =
        static_cast<double>(width_.widest + cornerMargin2_) / 2 + static_cast<double>(boxA.size() + boxB.size()) + 2;
  }

  BandVerdict classify(int64_t px, int64_t py) const override {
    std::optional<BandVerdict> verdict;
    for (const MajorAxis& axis : axes_) {
      const BandVerdict one = classify(axis, px, py);
      verdict = verdict ? eitherOf(*verdict, one, Freedom::SnapRounding) : one;
    }
    return *verdict;
  }

  double reach() const override { return reach_; }

 private:
  [[nodiscard]] BandVerdict classify(const MajorAxis& axis, int64_t px, int64_t py) const {
    if (axis.degenerate()) return {Coverage::Either, Freedom::SnapRounding, std::nullopt};  // within reach()
    const Coverage all = axis.decide(px, py, width_.narrowest - cornerMargin2_, width_.widest + cornerMargin2_);
    if (all != Coverage::Either) return {all, Freedom::None, std::nullopt};
    Freedom freedom = Freedom::LineCorner;
    if (axis.decide(px, py, width_.nominal, width_.nominal) == Coverage::Either) {
      freedom = fixed_ ? Freedom::TieOwner : made_ ? Freedom::ClipVertexPosition : Freedom::SnapRounding;
    } else if (axis.decide(px, py, width_.narrowest, width_.widest) == Coverage::Either) {
      freedom = Freedom::LineWidthStep;
    }
    return {Coverage::Either, freedom, std::nullopt};
  }

  LineWidth width_;
  std::vector<MajorAxis> axes_;  ///< one, or both where a legal placement has either
  bool fixed_ = false, made_ = false;
  int64_t cornerMargin2_ = 0;
  double reach_ = 0;
};

}  // namespace

std::unique_ptr<LineBand> parallelogramBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style,
                                            const Rules& rules) {
  const EndBox boxA(a), boxB(b);
  if (boxA.fixed() && boxA == boxB) return nullptr;
  return std::make_unique<ParallelogramBand>(a, b, style, rules);
}

}  // namespace rasterdiff::rasterizer
