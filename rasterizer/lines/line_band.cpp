#include "rasterizer/lines/line_band.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

/// [vk:primsrast-lines-basic] without strictLines a line may follow the rules for Bresenham lines instead.
class NonStrictBand final : public LineBand {
 public:
  NonStrictBand(std::unique_ptr<LineBand> parallelogram, std::unique_ptr<LineBand> bresenham)
      : parallelogram_(std::move(parallelogram)), bresenham_(std::move(bresenham)) {}
  BandVerdict classify(int64_t px, int64_t py) const override {
    return eitherOf(parallelogram_->classify(px, py), bresenham_->classify(px, py), Freedom::LineAlgorithm);
  }
  double reach() const override { return std::max(parallelogram_->reach(), bresenham_->reach()); }

 private:
  std::unique_ptr<LineBand> parallelogram_, bresenham_;
};

}  // namespace

BandVerdict eitherOf(const BandVerdict& a, const BandVerdict& b, Freedom freedom) {
  if (a.coverage == b.coverage) return a;
  return {Coverage::Either, freedom, std::nullopt};
}

std::unique_ptr<LineBand> lineBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style,
                                   const Rules& rules) {
  switch (lineKind(style, rules.limits)) {
    case LineKind::Rectangle:
      return rectangleBand(a, b, style, rules);
    case LineKind::Bresenham:
      return bresenhamBand(a, b, style, rules);
    case LineKind::Parallelogram:
      break;
  }
  std::unique_ptr<LineBand> parallelogram = parallelogramBand(a, b, style, rules);
  if (!parallelogram) return nullptr;
  return std::make_unique<NonStrictBand>(std::move(parallelogram), bresenhamBand(a, b, style, rules));
}

}  // namespace rasterdiff::rasterizer
