// Three-valued coverage of a line with legal places for its two ends: what every conforming device covers, what none
// covers, and what is free, with the freedom's name. In and Out are exact or missed (Either), never wrong.
#pragma once

#include <memory>

#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

class LineBand {
 public:
  virtual ~LineBand() = default;
  [[nodiscard]] virtual BandVerdict classify(int64_t px, int64_t py) const = 0;
  /// As Shape::classifiesPixels.
  [[nodiscard]] virtual bool classifiesPixels() const { return false; }
  /// Samples farther from the segment between the nominal ends are Out, 1/256 pixel.
  [[nodiscard]] virtual double reach() const = 0;
};

/// Null where the line certainly draws nothing.
[[nodiscard]] std::unique_ptr<LineBand> rectangleBand(const RasterVertex& a, const RasterVertex& b,
                                                      const LineStyle& style, const Rules& rules);
[[nodiscard]] std::unique_ptr<LineBand> parallelogramBand(const RasterVertex& a, const RasterVertex& b,
                                                          const LineStyle& style, const Rules& rules);
[[nodiscard]] std::unique_ptr<LineBand> bresenhamBand(const RasterVertex& a, const RasterVertex& b,
                                                      const LineStyle& style, const Rules& rules);

/// The one for the style's mode; without strictLines, what a parallelogram or a Bresenham line may cover.
[[nodiscard]] std::unique_ptr<LineBand> lineBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style,
                                                 const Rules& rules);

/// Two legal outcomes: where they agree there is one, elsewhere `freedom` decides.
[[nodiscard]] BandVerdict eitherOf(const BandVerdict& a, const BandVerdict& b, Freedom freedom);

}  // namespace rasterdiff::rasterizer
