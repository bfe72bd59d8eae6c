// One definite answer to which samples a line covers: what a profile says. Which other answers the specification allows
// is line_band.hpp's business.
#pragma once

#include <memory>

#include "rasterizer/lines/line_reach.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/shape_facts.hpp"

namespace rasterdiff::rasterizer {

class LineCoverage {
 public:
  virtual ~LineCoverage() = default;
  /// Sample position in 1/256 pixel. `tie`: it lies on the boundary of what is drawn.
  [[nodiscard]] virtual bool covers(int64_t px, int64_t py, bool& tie) const = 0;
  /// As Shape::coverRow.
  [[nodiscard]] virtual std::optional<RowCoverage> coverRow(int32_t, SubpixelPosition, RowSpan) const { return std::nullopt; }
  /// The numbers behind `covers`; none for a deliberate error.
  [[nodiscard]] virtual ShapeFacts facts(int64_t, int64_t) const { return {}; }
  /// No covered sample is farther from the segment between the nominal ends, 1/256 pixel.
  [[nodiscard]] virtual double reach() const = 0;
};

/// Around the snapped ends, decided exactly. Null where nothing is drawn.
[[nodiscard]] std::unique_ptr<LineCoverage> rectangleCoverage(const LineEnds& ends, const LineStyle& style,
                                                              const Rules& rules);
[[nodiscard]] std::unique_ptr<LineCoverage> parallelogramCoverage(const LineEnds& ends, const LineStyle& style,
                                                                  const Rules& rules);
[[nodiscard]] std::unique_ptr<LineCoverage> bresenhamCoverage(const LineEnds& ends, const LineStyle& style,
                                                              const Rules& rules);
/// [choice:line-arithmetic] Float32Corners. Null where nothing is drawn.
[[nodiscard]] std::unique_ptr<LineCoverage> floatCornerCoverage(const LineEnds& ends, const LineStyle& style,
                                                                const Rules& rules);

/// What `rules` choose. Null where nothing is drawn.
[[nodiscard]] std::unique_ptr<LineCoverage> lineCoverage(const LineEnds& ends, const LineStyle& style,
                                                         const Rules& rules);

/// Who owns a sample on the edge of a line's outline with this direction, positively oriented.
/// [choice:tie-owner] [vk:primsrast-polygons-basic]
[[nodiscard]] bool ownsLineTies(const Rules& rules, int64_t dx, int64_t dy);

}  // namespace rasterdiff::rasterizer
