// Rules = the device's limits + one answer to each choice that the specification leaves open. A profile closes every
// choice; `specification` keeps the answers as a nominal outcome and has the reference compute what else is legal.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "rasterizer/deliberate_error.hpp"
#include "scene/limits.hpp"
#include "scene/result.hpp"

namespace rasterdiff::rasterizer {

/// [choice:viewport-arithmetic] how clip / w and the viewport transform are evaluated.
enum class ViewportArithmetic : uint8_t {
  Exact,       ///< as real numbers
  Float32,     ///< float32: x · (1 / w), · scale, + offset, each rounded
  Float32Fma,  ///< float32: fma(x · (1 / w), scale, offset)
};

/// [choice:snap-rounding] how a coordinate reaches the subpixel grid.
enum class SnapRounding : uint8_t { NearestEven, NearestUp, Floor, TowardZero };

/// [choice:snap-origin] what is snapped.
enum class SnapOrigin : uint8_t {
  Corner,             ///< the framebuffer coordinate
  CentreAtOneSample,  ///< at one sample the coordinate less half a pixel, subtracted in float32 before scaling
};

/// [choice:tie-owner] which polygon owns a sample on a shared edge. [vk:primsrast-polygons-basic]
enum class TieOwner : uint8_t { TopLeft, TopRight, BottomLeft, BottomRight };

/// [choice:clip-arithmetic] where new vertices of clipped polygons lie. [vk:vertexpostproc-clipping]
enum class ClipArithmetic : uint8_t {
  Exact,           ///< in double precision, rounded once
  Float32Linear,   ///< float32 lerp from the nearer end, plane by plane: +x -x +y -y near far
};

/// [choice:point-arithmetic] how the square of a point is placed. [vk:primsrast-points]
enum class PointArithmetic : uint8_t {
  Exact,          ///< around the unrounded vertex
  SnappedCentre,  ///< around the snapped vertex, its side in whole subpixels and at least one pixel
};

/// [choice:line-arithmetic] how the outline of a line is placed. [vk:primsrast-lines-basic]
enum class LineArithmetic : uint8_t {
  Exact,           ///< around the snapped ends, without rounding
  Float32Corners,  ///< four corners in float32, each snapped (halves away from zero), for Bresenham lines too
};

/// [choice:diamond-exit] who owns the border of a pixel's diamond. [vk:primsrast-lines-bresenham]
enum class DiamondExit : uint8_t {
  Vulkan,      ///< ends moved by -(ε, ε²)
  Direct3D11,  ///< lower-left and lower-right edges and the bottom corner; the right corner of y-major lines
};

/// [choice:depth-bias-unit] the smallest resolvable difference of a fixed-point depth format with n bits.
/// [vk:primsrast-depthbias-computation]
enum class DepthBiasUnit : uint8_t {
  OneStep,   ///< 2^-n
  TwoSteps,  ///< 2 / (2^n - 1)
};

// Choices whose nominal answer is the same in every profile; open rules compute the others as intervals:
// [choice:attribute-position]  undecorated inputs of multisampled fragments: at the centre
// [choice:offset-rounding]     interpolateAtOffset: the offset is not rounded
// [choice:line-interpolation]  along a line: by projection on it
// [choice:line-bias]           depth bias of lines and points: none
// [choice:alpha-to-coverage]   which samples a fractional alpha covers: any

struct Choices {
  ViewportArithmetic viewportArithmetic = ViewportArithmetic::Exact;
  SnapRounding snapRounding = SnapRounding::NearestEven;
  SnapOrigin snapOrigin = SnapOrigin::Corner;
  TieOwner tieOwner = TieOwner::TopLeft;
  ClipArithmetic clipArithmetic = ClipArithmetic::Exact;
  PointArithmetic pointArithmetic = PointArithmetic::Exact;
  LineArithmetic lineArithmetic = LineArithmetic::Exact;
  DiamondExit diamondExit = DiamondExit::Vulkan;
  DepthBiasUnit depthBiasUnit = DepthBiasUnit::OneStep;
  /// The profile closes coverage only: where in the fragment a value is evaluated stays open, as in the specification.
  bool valuesOpen = false;
  friend bool operator==(const Choices&, const Choices&) = default;
};

struct Rules {
  std::string name;
  Limits limits;
  Choices choices;
  bool open = false;  ///< specification rules: every choice is a freedom, `choices` gives the nominal outcome
  DeliberateError error = DeliberateError::None;

  /// Are values judged against everything that the specification allows?
  [[nodiscard]] bool openValues() const { return open || choices.valuesOpen; }

  /// What the Vulkan specification demands of a device with these limits; all choices open.
  [[nodiscard]] static Rules specification(const Limits& limits);
  /// A profile by name (`profiles()`), with the device's limits.
  [[nodiscard]] static Result<Rules> profile(std::string_view name, const Limits& limits);
  /// The profile known to hold for a driver (matched on its driver name and this CPU), else the specification.
  [[nodiscard]] static Rules forDriver(std::string_view driverName, const Limits& limits);
};

/// Names of the built-in profiles: "reference" (exact, nearest even, top-left), "lavapipe".
[[nodiscard]] std::span<const std::string_view> profiles();

}  // namespace rasterdiff::rasterizer
