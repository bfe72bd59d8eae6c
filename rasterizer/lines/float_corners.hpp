// The outline of a line as a float32 driver places it: four corners, each snapped to 1/256 pixel by itself. Which
// samples the outline covers is float_corner_coverage.cpp's business. [choice:line-arithmetic]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rasterizer/lines/line_style.hpp"

namespace rasterdiff::rasterizer {

/// Positively oriented where it encloses anything (a shortened Bresenham line may turn inside out: it covers nothing).
using LineOutline = std::array<SubpixelPosition, 4>;

/// pixels - origin (0 or half a pixel), subtracted in float32, to the nearest 1/256 pixel, halves away from zero; the
/// origin is added again after it.
[[nodiscard]] int32_t snapFrom(float origin, float pixels);

/// `origin` as in snapFrom.
/// None for a line of zero length.
[[nodiscard]] std::optional<LineOutline> rectangularOutline(FloatPosition a, FloatPosition b, float width,
                                                            float origin);
[[nodiscard]] std::optional<LineOutline> bresenhamOutline(FloatPosition a, FloatPosition b, float width, float origin);

struct FloatSegment {
  FloatPosition a, b;
};

/// The parts of a stippled line that are drawn: cut at whole pixels of its length (rectangular) or of its longer
/// extent.
[[nodiscard]] std::vector<FloatSegment> dashes(FloatPosition a, FloatPosition b, const LineStipple& stipple,
                                               bool rectangular);

/// How far such a line moves the stipple counter.
[[nodiscard]] uint32_t dashSteps(FloatPosition a, FloatPosition b, bool rectangular);

}  // namespace rasterdiff::rasterizer
