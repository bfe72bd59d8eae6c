// Rules = the device's limits + one answer to each choice that the specification leaves open. A profile closes every
// choice; `specification` keeps the answers as a nominal outcome and has the reference compute what else is legal.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/legal/variation.hpp"
#include "scene/limits.hpp"
#include "scene/result.hpp"

namespace rasterdiff::rasterizer {

/// [choice:viewport-arithmetic] how clip / w and the viewport transform are evaluated.
enum class ViewportArithmetic : uint8_t {
  Exact,               ///< as real numbers
  Float32,             ///< float32: x · (1 / w), · scale, + offset, each rounded
  Float32Fma,          ///< float32: fma(x · (1 / w), scale, offset)
  Float32Division,     ///< float32: x / w, · scale, + offset, each rounded
  Float32DivisionFma,  ///< float32: fma(x / w, scale, offset)
};

/// [choice:snap-rounding] how a coordinate reaches the subpixel grid.
enum class SnapRounding : uint8_t {
  NearestEven,
  NearestUp,
  Floor,
  TowardZero,
  NearestDown,
  NearestAway,        ///< halves away from zero
  NearestTowardZero,  ///< halves toward zero
  Ceiling,
};

/// [choice:snap-origin] what is snapped; half a pixel is put back afterwards.
enum class SnapOrigin : uint8_t {
  Corner,             ///< the framebuffer coordinate
  CentreAtOneSample,  ///< at one sample the coordinate less half a pixel, subtracted in float32 before scaling
  Centre,             ///< the same at any number of samples
  CentreInViewport,   ///< half a pixel is subtracted from the viewport's offset, in float32
};

/// [choice:tie-owner] which polygon owns a sample on a shared edge: on horizontal edges the one below (its top edge) or
/// above, on vertical ones the one to the right (its left edge) or left. [vk:primsrast-polygons-basic]
enum class TieOwner : uint8_t { TopLeft, TopRight, BottomLeft, BottomRight };

/// [choice:slanted-ties] who owns a sample on a slanted shared edge, said by the tie owner of level ones.
enum class SlantedTies : uint8_t {
  LikeVertical,       ///< the polygon on the side (left or right) that owns vertical edges
  AgainstVertical,    ///< the other
  LikeHorizontal,     ///< the polygon on the side (above or below) that owns horizontal edges
  AgainstHorizontal,  ///< the other
};

/// [choice:tie-winding] does the owner depend on the direction in which a triangle is wound? Only a device that breaks
/// [vk:primsrast-polygons-basic] has it depend.
enum class TieWinding : uint8_t {
  Same,
  OppositeIfCounterClockwise,  ///< triangles that are counter-clockwise on the screen own the opposite edges
};

/// [choice:clip-arithmetic] where new vertices of clipped polygons lie. [vk:vertexpostproc-clipping]
enum class ClipArithmetic : uint8_t {
  Exact,           ///< in double precision, rounded once
  Float32Linear,    ///< float32 lerp from the nearer end, plane by plane: +x -x +y -y near far; mapped without fusing
  Float32Weighted,  ///< float32 (d₁ p₀ - d₀ p₁) · (1 / (d₁ - d₀)), plane by plane: near far -x +x +y -y
};

/// [choice:point-arithmetic] how the square of a point is placed. [vk:primsrast-points]
enum class PointArithmetic : uint8_t {
  Exact,          ///< around the unrounded vertex
  SnappedCentre,  ///< around the float32 vertex snapped (halves away from zero), its side in whole subpixels and at least one pixel
  SnappedCorners, ///< around the snapped vertex, its half side in whole subpixels; ties by the tie owner, as two triangles have them
  ClipCorners,    ///< corners made in clip space in float32, cut at the view volume's sides, each snapped like a vertex
  SnappedCentreEven,  ///< as SnappedCentre, but halves go to the even subpixel, those of the side too
};

/// [choice:point-clip] which points outside of the view volume are drawn. [vk:vertexpostproc-clipping]
enum class PointClip : uint8_t {
  Volume,        ///< as the device advertises
  SidesIgnored,  ///< sides do not count for points; with one viewport, corners of polygons are cut at twice the volume
};

/// [choice:cut-outline] which edges and corners of a cut polygon polygon modes LINE and POINT draw.
/// [vk:primsrast-polygonmode]
enum class CutOutline : uint8_t {
  Original,  ///< those of the triangle as it was
  Flagged,   ///< also edges along clip distances, and the corner where the outline comes back inside; the closing edge early
  Uncut,     ///< each edge and corner of the triangle as a line or point of its own: nothing else is cut or dropped
};

/// [choice:cut-fill] how the polygon that clipping leaves is filled where snapping folds it.
/// [vk:primsrast-polygons-basic]
enum class CutFill : uint8_t {
  Polygon,  ///< as one polygon: every sample that it winds around once, all of it facing one way
  Fan,      ///< each triangle of its fan for itself: overlaps are drawn twice, each triangle has its own facing
  Spans,    ///< each row from its last left to its last right edge, in the order of the edges
};

/// [choice:clip-distances] what user clip distances take away. [vk:vertexpostproc-clipping]
enum class ClipDistances : uint8_t {
  Cut,        ///< the part of the primitive where one is negative
  Fragments,  ///< whole fragments where one, interpolated in float32 at the pixel's centre, is negative: breaks the specification at several samples
};

/// [choice:cull-position] which positions a triangle's facing is culled by. [vk:primsrast-polygons-basic]
enum class CullPosition : uint8_t {
  Snapped,
  AlsoFloat,  ///< by those in float32 alone for outlines; by both where some vertex of the draw had to be clipped
  /// The snapped ones of the triangle before clipping, turned for each negative w, their area in float32 (corners: of clip
  /// coordinates). Zero is front-facing (corners: back-facing). What is wound the other way after clipping is not drawn.
  UncutFloat32,
};

/// [choice:drawing-region] which samples a draw may write at all. [vk:fragops-scissor]
enum class DrawingRegionRule : uint8_t {
  Scissor,           ///< those inside of the scissor
  RoundedViewport,   ///< only in whole pixels of the first viewport; leaky borders at several samples
};

/// [choice:line-arithmetic] how the outline of a line is placed. [vk:primsrast-lines-basic]
enum class LineArithmetic : uint8_t {
  Exact,           ///< around the snapped ends, without rounding
  Float32Corners,  ///< four corners in float32, each snapped (halves away from zero), for Bresenham lines too
  /// Four corners made in clip space in float32 around the uncut ends, cut as a polygon is, each snapped like a vertex,
  /// filled by Spans; Bresenham lines are parallelograms with ends along an axis.
  ClipCorners,
};

/// [choice:diamond-exit] who owns the border of a pixel's diamond. [vk:primsrast-lines-bresenham]
enum class DiamondExit : uint8_t {
  Vulkan,      ///< ends moved by -(ε, ε²)
  Direct3D11,  ///< lower-left and lower-right edges and the bottom corner; the right corner of y-major lines
};

/// [choice:depth-bias-unit] the smallest resolvable difference of a fixed-point depth format with n bits.
/// [vk:primsrast-depthbias-computation]
enum class DepthBiasUnit : uint8_t {
  OneStep,            ///< 2^-n
  TwoSteps,           ///< 2 / (2^n - 1)
  OneStepOfRange,     ///< 1 / (2^n - 1)
  OneStepAndPercent,  ///< 1.01 / (2^n - 1)
};

/// [choice:depth-bias-exponent] what the unit of a float depth format comes from. [vk:primsrast-depthbias-computation]
enum class DepthBiasExponent : uint8_t {
  LargestDepth,      ///< the exponent of the primitive's largest depth
  FirstDifferences,  ///< of the first vertex's depth (largest w, then smallest y) and of the others' differences from it: breaks the specification
};

/// [choice:depth-bias-slope] m. [vk:primsrast-depthbias-computation]
enum class DepthBiasSlope : uint8_t {
  Larger,  ///< max(abs dz/dx, abs dz/dy)
  Length,  ///< the gradient's length
};

/// [choice:centroid] where a centroid input of a partly covered fragment is evaluated.
/// [vk:shaders-interpolation-decorations]
enum class CentroidPosition : uint8_t {
  CentreOrFirst,  ///< all samples covered: the centre; else the first covered sample
  First,          ///< the first covered sample
  Mean,           ///< the mean of the covered samples
};

/// [choice:plane-positions] through which positions the planes of values are laid. [vk:primsrast-polygons]
enum class PlanePositions : uint8_t {
  Unsnapped,
  Snapped,
  SnappedUncut,  ///< of cut polygons: the snapped positions of the triangle before clipping, also behind the eye
};

/// [choice:resolve-arithmetic] how an average is rounded. [vk:VkResolveModeFlagBits]
enum class ResolveArithmetic : uint8_t {
  Any,          ///< judged by an interval that holds every order of float32 operations
  RoundedOnce,  ///< the exact mean
  InOrder,      ///< float32: samples added one by one, · 1 / n
  Pairwise,     ///< float32: neighbours added, their sums added, · 1 / n
};

/// Sample locations from the pixel's top-left corner, in 1/256 pixel, for 1, 2, 4, 8 and 16 samples one after the other.
struct SampleTables {
  struct Offset {
    uint8_t x = 128, y = 128;  // Q0.8
    friend bool operator==(const Offset&, const Offset&) = default;
  };
  std::array<Offset, 31> offsets{};
  /// `samples` must be 1, 2, 4, 8 or 16. // 1 + 2 + 4 + ... + samples / 2 = samples - 1 come before
  [[nodiscard]] std::span<const Offset> of(uint32_t samples) const { return std::span(offsets).subspan(samples - 1, samples); }
  [[nodiscard]] std::span<Offset> of(uint32_t samples) { return std::span(offsets).subspan(samples - 1, samples); }
  friend bool operator==(const SampleTables&, const SampleTables&) = default;
};

// Choices whose nominal answer is the same in every profile; open rules compute the others as intervals:
// [choice:attribute-position]  undecorated inputs of multisampled fragments: at the centre
// [choice:offset-rounding]     interpolateAtOffset: the offset is not rounded
// [choice:line-interpolation]  along a line: by projection on it
// [choice:line-bias]           depth bias of lines and points: none
// [choice:alpha-to-coverage]   which samples a fractional alpha covers: any

struct Choices {
  uint32_t subPixelBits = 0;  ///< [choice:subpixel-bits] bits of the grid in use; 0: as many as the device advertises
  ViewportArithmetic viewportArithmetic = ViewportArithmetic::Exact;
  SnapRounding snapRounding = SnapRounding::NearestEven;
  SnapOrigin snapOrigin = SnapOrigin::Corner;
  TieOwner tieOwner = TieOwner::TopLeft;
  SlantedTies slantedTies = SlantedTies::LikeVertical;
  TieWinding tieWinding = TieWinding::Same;
  ClipArithmetic clipArithmetic = ClipArithmetic::Exact;
  PointArithmetic pointArithmetic = PointArithmetic::Exact;
  PointClip pointClip = PointClip::Volume;
  CutOutline cutOutline = CutOutline::Original;
  CullPosition cullPosition = CullPosition::Snapped;
  CutFill cutFill = CutFill::Polygon;
  ClipDistances clipDistances = ClipDistances::Cut;
  DrawingRegionRule drawingRegion = DrawingRegionRule::Scissor;
  LineArithmetic lineArithmetic = LineArithmetic::Exact;
  DiamondExit diamondExit = DiamondExit::Vulkan;
  DepthBiasUnit depthBiasUnit = DepthBiasUnit::OneStep;
  DepthBiasExponent depthBiasExponent = DepthBiasExponent::LargestDepth;
  DepthBiasSlope depthBiasSlope = DepthBiasSlope::Larger;
  CentroidPosition centroid = CentroidPosition::CentreOrFirst;
  PlanePositions planePositions = PlanePositions::Unsnapped;
  ResolveArithmetic resolveArithmetic = ResolveArithmetic::Any;
  std::optional<SampleTables> sampleLocations{};  ///< [choice:sample-locations] none: the standard ones
  /// The profile closes coverage only: where in the fragment a value is evaluated stays open, as in the specification.
  bool valuesOpen = false;
  friend bool operator==(const Choices&, const Choices&) = default;
};

struct Rules {
  std::string name;
  Limits limits;
  Choices choices;
  bool open = false;  ///< specification rules: every choice is a freedom, `choices` gives the nominal outcome
  uint32_t openChoices = 0;  ///< single choices that the profile leaves open: bits by Choice (choice_table.hpp)
  DeliberateError error = DeliberateError::None;
  std::optional<Variation> variation{};  ///< a legal renderer unlike any profile: looks for false alarms

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
