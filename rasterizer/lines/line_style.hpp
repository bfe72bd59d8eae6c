// What a line shape is made from: its two ends on the screen, and the pipeline state that says how lines look.
#pragma once

#include <array>
#include <optional>

#include "rasterizer/lines/stipple_counter.hpp"
#include "rasterizer/target_area.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// A float32 framebuffer position, as [choice:viewport-arithmetic] computes it, before any snapping.
struct FloatPosition {
  float x = 0, y = 0;
};

/// The ends in the order of drawing, clipped where they lay outside the clip volume (`made`).
struct LineEnds {
  RasterVertex a, b;
  std::array<ClipPosition, 2> clip{};  ///< as they came; matters to LineArithmetic::ClipCorners only
  FloatPosition floatA, floatB;  ///< matters to LineArithmetic::Float32Corners only
  /// The ends of a cut or removed line as they were, where both have w > 0: a device may leave a line uncut.
  /// [vk:vertexpostproc-clipping]
  std::optional<std::array<RasterVertex, 2>> uncut;
  bool removed = false;  ///< clipping left nothing; a and b do not count
};

/// Float position of a vertex that `stage` maps.
[[nodiscard]] FloatPosition floatPosition(const VertexStage& stage, const ClipVertex& vertex);

struct LineStipple {
  bool enabled = false;
  uint32_t factor = 1;  ///< 1..256
  uint16_t pattern = 0xFFFF;
  StippleCounter start;  ///< of this segment: zero for the first of a strip and for every line of a list

  /// [vk:primsrast-lines-stipple] bit ⌊s / factor⌋ mod 16, bit 0 first.
  [[nodiscard]] bool draws(uint64_t s) const { return ((pattern >> (s / factor % 16)) & 1) != 0; }
};

struct LineStyle {
  /// DEFAULT is RECTANGULAR on a device with strictLines, else a parallelogram. RECTANGULAR_SMOOTH has the geometry of
  /// RECTANGULAR, and pixels near it are free (smooth_line.hpp).
  LineRasterizationMode mode = LineRasterizationMode::DEFAULT;
  float width = 1;         ///< pixels, as the pipeline state has it
  uint32_t samples = 1;    ///< of the target
  LineStipple stipple;     ///< not for parallelograms, which Vulkan forbids to stipple
  bool ofPolygon = false;  ///< an edge of a triangle in polygon mode LINE
  PixelArea area;          ///< the drawing region; matters to LineArithmetic::Float32Corners only
  bool leaky = false;      ///< of the drawing region
};

enum class LineKind : uint8_t { Rectangle, Parallelogram, Bresenham };

[[nodiscard]] inline LineKind lineKind(const LineStyle& style, const Limits& limits) {
  if (style.mode == LineRasterizationMode::BRESENHAM) return LineKind::Bresenham;
  const bool strict = style.mode != LineRasterizationMode::DEFAULT || limits.strictLines;
  return strict ? LineKind::Rectangle : LineKind::Parallelogram;
}

}  // namespace rasterdiff::rasterizer
