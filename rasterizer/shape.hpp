// Coverage of a primitive that is not a triangle: a line's rectangle, parallelogram or pixel set, a point's square.
#pragma once

#include <optional>

#include "rasterizer/freedom_band.hpp"
#include "rasterizer/row_span.hpp"
#include "rasterizer/shape_facts.hpp"

namespace rasterdiff::rasterizer {

/// Positions are sample positions in 1/256 pixel. Implementations decide in integers.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Rows that can hold a covered or free sample, inclusive (pixels); empty: first > last.
  struct Rows {
    int32_t first = 0, last = -1;
  };
  [[nodiscard]] virtual Rows rows() const = 0;

  /// Pixels of row y that can hold a covered or free sample; conservative. Keeps long thin shapes cheap.
  [[nodiscard]] virtual RowSpan columns(int32_t y) const = 0;

  /// Nominal coverage under the rules that the shape was made with. `tie` is set where the sample lies exactly on the
  /// shape's boundary.
  [[nodiscard]] virtual bool covers(int64_t px, int64_t py, bool& tie) const = 0;

  /// The same of the samples at `offset` in the pixels `columns` of row y, at once. None where they may be more than one span, or not
  /// the same for all samples of the shape.
  [[nodiscard]] virtual std::optional<RowCoverage> coverRow(int32_t, SubpixelPosition, RowSpan) const { return std::nullopt; }

  /// Legal coverage under open rules: In, Out, or Either with the freedom's name.
  [[nodiscard]] virtual BandVerdict classify(int64_t px, int64_t py) const = 0;

  /// Is that the same for all samples of a pixel?
  [[nodiscard]] virtual bool classifiesPixels() const { return false; }

  /// The numbers behind `covers`.
  [[nodiscard]] virtual ShapeFacts facts(int64_t px, int64_t py) const = 0;
};

}  // namespace rasterdiff::rasterizer
