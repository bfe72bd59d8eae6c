// Which samples a draw may write at all: the target cut by the scissor and, under one profile, by whole pixels of the
// first viewport. [vk:fragops-scissor] [choice:drawing-region]
#pragma once

#include "rasterizer/row_span.hpp"
#include "rasterizer/rules.hpp"
#include "rasterizer/subpixel_box.hpp"
#include "rasterizer/target_area.hpp"

namespace rasterdiff::rasterizer {

/// Pixels that a primitive reaches, inclusive.
struct PixelBox {
  int32_t left = 0, top = 0, right = -1, bottom = -1;
};

/// The samples that one primitive may write: an area, and perhaps the far halves of the pixels before it.
struct SampleArea {
  PixelArea area;
  bool leaksLeft = false, leaksTop = false;

  /// Pixels of a row for the samples with this offset from their pixel's corner, 1/256 pixel.
  [[nodiscard]] RowSpan columns(int32_t y, const SubpixelPosition& offset) const {
    if (y < area.top - (leaks(leaksTop, offset.y) ? 1 : 0) || y >= area.bottom) return {};
    return {area.left - (leaks(leaksLeft, offset.x) ? 1 : 0), area.right};
  }
  [[nodiscard]] bool contains(int32_t x, int32_t y, const SubpixelPosition& offset) const {
    const RowSpan span = columns(y, offset);
    return x >= span.begin && x < span.end;
  }

 private:
  [[nodiscard]] static bool leaks(bool side, int32_t offset) { return side && offset >= kSubpixelOne / 2; }
};

struct DrawingRegion {
  PixelArea area;
  /// At several samples a border only cuts polygons whose box reaches beyond it, and borders on the left and at the top
  /// let the far half of the pixel before pass, unless they are borders of tiles too.
  bool leaky = false;

  /// For a polygon with this box. Samples outside of the target are the caller's business.
  [[nodiscard]] SampleArea of(const PixelBox& box) const;
  [[nodiscard]] SampleArea of(const SubpixelBox& box) const;
  /// For a piece of a primitive; pieces that are folded together have one area.
  [[nodiscard]] SampleArea of(const Primitive& primitive, const SetupTriangle& piece) const;
  /// May the figure write the samples of this pixel?
  [[nodiscard]] bool allows(const Figure& figure, int32_t x, int32_t y) const { return figure.cutsItself || area.contains(x, y); }
};

/// For draws through viewport `index`, which has its own scissor.
[[nodiscard]] DrawingRegion drawingRegion(const Scene& scene, uint32_t index, const Rules& rules);

}  // namespace rasterdiff::rasterizer
