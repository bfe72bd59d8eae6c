// Smooth lines: how much of a pixel a line's rectangle covers, and which pixels around it a device may call covered.
// The specification leaves both to the device on purpose; what is demanded here is a reading of "nearby" and
// "approximates" that no picture of a line gets past. [vk:primsrast-lines-smooth]
#pragma once

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

[[nodiscard]] bool drawsSmoothLines(const State& state);

/// Twice the distance, 1/256 pixel, from the rectangle to the centre of a pixel that is not covered for certain: the
/// nearest point of its square is a pixel away.  // 2 · 256 · (1 + √½), rounded up
inline constexpr int64_t kSmoothReach2 = 875;
/// The same of a pixel that is covered for certain, within the rectangle: its square lies inside.  // 2 · 256 · √½
inline constexpr int64_t kSmoothInside2 = 363;
/// By how much the rectangle whose area alpha tells may be larger or smaller on every side, pixels.
inline constexpr double kSmoothSlack = 0.5;

/// Area of pixel (x, y), 0..1, inside of the rectangle of the line from a to b, `width` pixels wide under `limits`, with
/// the interval of legal answers: those of rectangles up to kSmoothSlack larger or smaller on each side, and as far off
/// as the ends may be.
[[nodiscard]] Interval smoothCoverage(const RasterVertex& a, const RasterVertex& b, float width, const Limits& limits,
                                      int32_t x, int32_t y);

}  // namespace rasterdiff::rasterizer
