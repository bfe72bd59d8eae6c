// Bresenham lines, exactly: the pixels of the diamond-exit rule, widened to columns (x-major) or rows (y-major); every
// sample of a pixel. [vk:primsrast-lines-bresenham]
#include "rasterizer/lines/bresenham_line.hpp"
#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/lines/stipple.hpp"

namespace rasterdiff::rasterizer {
namespace {

class BresenhamCoverage final : public LineCoverage {
 public:
  BresenhamCoverage(const DiamondLine& line, int64_t width, const LineStipple& stipple)
      : line_(line), width_(width), stipple_(stipple), first_(line.pixel(0)), last_(line.pixel(line.count() - 1)) {}

  bool covers(int64_t px, int64_t py, bool& tie) const override {
    tie = false;  // pixels are covered, not points
    const int64_t x = px >> kSubpixelBits, y = py >> kSubpixelBits, across = line_.xMajor() ? y : x;
    const int64_t i = column(x, y);
    if (i < 0 || i >= line_.count()) return false;
    const PixelIndex pixel = line_.pixel(i);
    const int64_t offset = across - (line_.xMajor() ? pixel.y : pixel.x);
    if (offset < 0 || offset >= width_) return false;
    return !stipple_.enabled || stipple_.draws(stipple_.start.s + static_cast<uint64_t>(i));
  }

  ShapeFacts facts(int64_t px, int64_t py) const override {
    const int64_t i = column(px >> kSubpixelBits, py >> kSubpixelBits);
    const DiamondLine::Crossing crossing = line_.crossing(i);
    ShapeFacts facts;
    facts.diamond = DiamondFacts{line_.xMajor(), i, line_.count(), line_.pixel(i), width_, crossing.numerator, crossing.denominator};
    if (stipple_.enabled && facts.diamond->inColumn()) {
      facts.stipple = stippleFacts(stipple_, stipple_.start.s + static_cast<uint64_t>(i));
    }
    return facts;
  }

  // The outermost pixels are centred within half a pixel of the line's own, and a pixel's corner is 0.71 from its
  // centre.
  double reach() const override { return static_cast<double>(width_ + 3) / 2 * kSubpixelOne; }

 private:
  // Number of the pixel's column (x-major) or row along the line.
  [[nodiscard]] int64_t column(int64_t x, int64_t y) const {
    const int64_t from = line_.xMajor() ? first_.x : first_.y, to = line_.xMajor() ? last_.x : last_.y;
    const int64_t along = line_.xMajor() ? x : y;
    return to > from || (to == from && line_.forward()) ? along - from : from - along;
  }

  DiamondLine line_;
  int64_t width_;
  LineStipple stipple_;
  PixelIndex first_, last_;
};

}  // namespace

DiamondLine bresenhamLine(SubpixelPosition a, SubpixelPosition b, int64_t width, DiamondExit rule) {
  const auto shift = static_cast<int32_t>((width - 1) * (kSubpixelOne / 2));
  const bool xMajor = std::llabs(int64_t{b.x} - a.x) >= std::llabs(int64_t{b.y} - a.y);
  for (SubpixelPosition* end : {&a, &b}) (xMajor ? end->y : end->x) -= shift;
  return {a, b, rule == DiamondExit::Vulkan ? DiamondRule::Vulkan : DiamondRule::Direct3D11};
}

std::unique_ptr<LineCoverage> bresenhamCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const int64_t width = bresenhamWidth(style.width, rules.limits).nominal;
  const DiamondLine line = bresenhamLine(ends.a.snapped, ends.b.snapped, width, rules.choices.diamondExit);
  if (line.count() == 0) return nullptr;
  return std::make_unique<BresenhamCoverage>(line, width, style.stipple);
}

}  // namespace rasterdiff::rasterizer
