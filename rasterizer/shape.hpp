// Coverage of a primitive that is not a triangle: a line's rectangle, parallelogram or pixel set, a point's square.
#pragma once

#include "rasterizer/freedom_band.hpp"
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

  /// Legal coverage under open rules: In, Out, or Either with the freedom's name.
  [[nodiscard]] virtual BandVerdict classify(int64_t px, int64_t py) const = 0;

  /// The numbers behind `covers`.
  [[nodiscard]] virtual ShapeFacts facts(int64_t px, int64_t py) const = 0;
};

}  // namespace rasterdiff::rasterizer
