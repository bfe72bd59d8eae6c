// Framebuffer coordinates to the subpixel grid: the rounding of a profile, and the box of all legal roundings.
// [vk:limits-subPixelPrecisionBits] [choice:snap-rounding] [choice:snap-origin]
#pragma once

#include "rasterizer/viewport.hpp"

namespace rasterdiff::rasterizer {

/// Coordinates are clamped here before they become integers.  // ±2^20 pixels = ±2^28 in Q23.8
inline constexpr double kGuardBand = 1 << 20;

/// Grid bits in use: the profile's, else the device's subPixelPrecisionBits; at most kSubpixelBits. Open rules: the device's.
/// [choice:subpixel-bits]
[[nodiscard]] int gridBits(const Rules& rules);

/// [choice:snap-origin] where half a pixel is taken off, to be put back after rounding.
enum class SnapShift : uint8_t { None, AfterViewport, InViewport };
[[nodiscard]] SnapShift snapShift(const Rules& rules, uint32_t samples);

/// Doubles are trusted to decide when they are at least this far (relative to the grid value + 1) from a decision point.
inline constexpr double kSnapTrust = 0x1p-40;

/// Rounds `pixels` (a double that is close enough to the truth) to the grid; result in 1/256 pixel.
[[nodiscard]] int32_t snap(double pixels, int bits, SnapRounding rounding);

/// Rounds x / w · scale + offset exactly: no float error can turn a tie or cross a half.
[[nodiscard]] int32_t snapExactly(float coordinate, float w, const ViewportAxis& axis, int bits, SnapRounding rounding);

/// The smallest integer n with n >= 256 (x / w · scale + offset) + shift, exactly; `shift` is a multiple of 2^-10 with
/// |shift| < 2^20.  // result: Q23.8
[[nodiscard]] int32_t ceilingExactly(float coordinate, float w, const ViewportAxis& axis, double shift);

/// Snaps one coordinate of an unclipped vertex under closed rules. `samples` matters to [choice:snap-origin].
[[nodiscard]] int32_t snapUnder(const Rules& rules, uint32_t samples, float coordinate, float w,
                                const ViewportAxis& axis);

/// Snaps a float32 framebuffer coordinate as a float32 driver does (for an origin within the viewport: one that is less
/// half a pixel already).
[[nodiscard]] int32_t snapFloat(const Rules& rules, uint32_t samples, float pixels);

/// One coordinate through float32 viewport arithmetic and snapping.
[[nodiscard]] int32_t mapAndSnapFloat(const Rules& rules, uint32_t samples, float coordinate, float w,
                                      const ViewportAxis& axis, ViewportArithmetic arithmetic);

/// Snaps a framebuffer coordinate that was computed in doubles (of a vertex that clipping made).
[[nodiscard]] int32_t snapPosition(const Rules& rules, uint32_t samples, double pixels);

/// A coordinate on the grid wherever it lies, also beyond the guard band and behind the eye (w < 0, but not 0).
struct GridPlace {
  double steps = 0;   ///< whole; from what the rounding takes for the origin
  double pixels = 0;  ///< from the target's
};
[[nodiscard]] GridPlace snapAnywhere(const Rules& rules, uint32_t samples, float coordinate, float w, const ViewportAxis& axis);

/// The neighbouring grid points between which a vertex may legally go, for a coordinate known within ±`uncertainty`
/// pixels (0: exactly, and then a point on the grid stays).
struct SnapRange {
  int32_t lowest = 0, highest = 0;  ///< 1/256 pixel
};
[[nodiscard]] SnapRange legalSnaps(float coordinate, float w, const ViewportAxis& axis, int bits, double uncertainty);
[[nodiscard]] SnapRange legalSnaps(double pixels, int bits, double uncertainty);

}  // namespace rasterdiff::rasterizer
