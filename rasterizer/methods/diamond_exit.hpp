// Thin lines by the diamond-exit rule, exactly, in integers: which pixels a segment produces and in which order. Width,
// stipple and attributes along the line are left to the caller. [vk:primsrast-lines-bresenham]
#pragma once

#include <vector>

#include "rasterizer/methods/pixel_mask.hpp"
#include "rasterizer/target_area.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// Whose borders the diamond |x - xc| + |y - yc| < ½ around a pixel centre has.
enum class DiamondRule : uint8_t {
  /// Open diamonds; both ends are moved by -(ε, ε²). [vk:primsrast-lines-bresenham]
  Vulkan,
  /// The lower-left and lower-right edges and the bottom corner belong to the diamond, for y-major lines the right
  /// corner too (Direct3D 11.3 functional specification, aliased lines; slope ±1 is x-major).
  Direct3D11,
};

/// The pixels of a segment from a to b: those whose diamond it meets and leaves. One a column (x-major) or row
/// (y-major), half-open: of segments that share ends every pixel at a shared end is produced once.
/// Ends in 1/256 pixel, |coordinate| ≤ 2^29. // all products ≤ 2^61
class DiamondLine {
 public:
  DiamondLine(SubpixelPosition a, SubpixelPosition b, DiamondRule rule);

  /// |dx| ≥ |dy|.
  [[nodiscard]] bool xMajor() const { return xMajor_; }
  [[nodiscard]] int64_t count() const { return count_; }
  /// The i-th pixel on the way from a to b, 0 ≤ i < count().
  [[nodiscard]] PixelIndex pixel(int64_t i) const { return at(first_ + i * direction_); }
  /// The major coordinate grows along the line.
  [[nodiscard]] bool forward() const { return direction_ > 0; }
  /// Where the line crosses the middle of its i-th column (any i): numerator / denominator pixels, exactly.
  struct Crossing {
    int64_t numerator = 0, denominator = 1;
  };
  [[nodiscard]] Crossing crossing(int64_t i) const { return crossingAt(first_ + i * direction_); }
  /// Keeps of [0, count()) the range whose column (x-major) or row (y-major) lies in `area`.
  struct Range {
    int64_t begin = 0, end = 0;
  };
  [[nodiscard]] Range within(const PixelArea& area) const;

 private:
  [[nodiscard]] Crossing crossingAt(int64_t major) const;
  [[nodiscard]] int64_t minor(int64_t major) const;
  [[nodiscard]] PixelIndex at(int64_t major) const;
  [[nodiscard]] bool contains(int64_t dx, int64_t dy) const;
  [[nodiscard]] bool hasLeft(SubpixelPosition end, int64_t major) const;

  DiamondRule rule_;
  SubpixelPosition a_;
  bool xMajor_ = true;
  int64_t direction_ = 1;       ///< of the major coordinate along the line
  int64_t run_ = 0, rise_ = 0;  ///< major extent (> 0), minor extent over it, 1/256 pixel
  int64_t first_ = 0, count_ = 0;
};

/// The same as a list, in order, cut to `area`.
[[nodiscard]] std::vector<PixelIndex> diamondExitPixels(SubpixelPosition a, SubpixelPosition b, DiamondRule rule,
                                                        const PixelArea& area);

}  // namespace rasterdiff::rasterizer
