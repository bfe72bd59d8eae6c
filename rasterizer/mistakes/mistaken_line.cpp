#include "rasterizer/mistakes/mistaken_line.hpp"

#include <cmath>
#include <utility>

namespace rasterdiff::rasterizer {
namespace {

using enum DeliberateError;
using Coverage = std::unique_ptr<LineCoverage>;

/// What two ways of drawing a line both cover.
class Common final : public LineCoverage {
 public:
  Common(Coverage a, Coverage b) : a_(std::move(a)), b_(std::move(b)) {}
  bool covers(int64_t px, int64_t py, bool& tie) const override {
    bool ignored = false;
    return a_->covers(px, py, tie) && b_->covers(px, py, ignored);
  }
  double reach() const override { return a_->reach(); }

 private:
  Coverage a_, b_;
};

/// A line drawn with x and y exchanged, and exchanged back.
class Transposed final : public LineCoverage {
 public:
  explicit Transposed(Coverage line) : line_(std::move(line)) {}
  bool covers(int64_t px, int64_t py, bool& tie) const override { return line_->covers(py, px, tie); }
  double reach() const override { return line_->reach(); }

 private:
  Coverage line_;
};

LineEnds swapped(LineEnds ends) {
  std::swap(ends.a, ends.b);
  return ends;
}

bool isXMajor(const LineEnds& ends) {
  return std::abs(ends.b.snapped.x - ends.a.snapped.x) >= std::abs(ends.b.snapped.y - ends.a.snapped.y);
}

/// Both ends moved across the major axis.
LineEnds movedAside(LineEnds ends, double pixels) {
  const auto shift = static_cast<int32_t>(std::lround(pixels * kSubpixelOne));
  const bool xMajor = isXMajor(ends);
  for (RasterVertex* end : {&ends.a, &ends.b}) (xMajor ? end->snapped.y : end->snapped.x) += shift;
  return ends;
}

std::optional<Coverage> mistakenBresenham(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const auto right = [&](const LineEnds& of) { return bresenhamCoverage(of, style, rules); };
  switch (rules.error) {
    case BresenhamFirstForLast:
      if (style.stipple.enabled) return std::nullopt;  // which would run from the other end too
      return right(swapped(ends));
    case BresenhamAside: return right(movedAside(ends, 2));
    case BresenhamWidthBehind: return right(movedAside(ends, std::floor(style.width + 0.5) - 1));
    case BresenhamWidthTruncated: {
      LineStyle narrower = style;
      narrower.width = std::floor(style.width);
      return bresenhamCoverage(ends, narrower, rules);
    }
    case BresenhamSlopeOneByY: {
      const SubpixelPosition a = ends.a.snapped, b = ends.b.snapped;
      if (std::abs(b.x - a.x) != std::abs(b.y - a.y)) return std::nullopt;
      LineEnds turned = ends;
      for (RasterVertex* end : {&turned.a, &turned.b}) std::swap(end->snapped.x, end->snapped.y);
      Coverage line = right(turned);
      return line ? std::make_unique<Transposed>(std::move(line)) : nullptr;
    }
    case BresenhamSamples: {
      if (style.samples == 1) return std::nullopt;
      Coverage pixels = right(ends), rectangle = rectangleCoverage(ends, style, rules);
      return pixels && rectangle ? std::make_unique<Common>(std::move(pixels), std::move(rectangle)) : nullptr;
    }
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<Coverage> mistakenLine(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  switch (lineKind(style, rules.limits)) {
    case LineKind::Bresenham: return mistakenBresenham(ends, style, rules);
    case LineKind::Rectangle:
      if (rules.error == LineEndsLevel) return parallelogramCoverage(ends, style, rules);
      if (rules.error == StippleFromEnd && style.stipple.enabled) return rectangleCoverage(swapped(ends), style, rules);
      return std::nullopt;
    case LineKind::Parallelogram:
      if (rules.error == ParallelogramSquare) return rectangleCoverage(ends, style, rules);
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace rasterdiff::rasterizer
