// Mutants: each is the reference with exactly one mistake, used as the driver under test to measure the measure.
// A mistake sits in the stage it names and costs nothing when absent (stages look once a primitive, never a sample).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

enum class DeliberateError : uint8_t {
  None,
  TieOwnerBottomRight,      ///< edge samples go to the bottom-right polygon
  TiesCoveredByBoth,        ///< every edge inclusive: shared edges drawn twice
  TiesCoveredByNone,        ///< every edge exclusive: seams
  TruncatingSnap,           ///< vertex coordinates rounded toward zero
  CoarseSnap,               ///< 4 subpixel bits where more are advertised
  SampleMoved,              ///< sample 0 lies 1/16 pixel to the right
  SwappedWinding,           ///< facing inverted
  MissingPerspective,       ///< smooth varyings interpolated linearly on the screen
  PerspectiveOnLinear,      ///< noperspective varyings interpolated with perspective
  WrongProvokingVertex,     ///< flat varyings from the other end of the primitive
  DepthOffByOneStep,        ///< depth one float32 step too far
  HalfPixelShift,           ///< vertices moved by half a pixel in x
  WrongNearPlane,           ///< near plane at z = -w where it is z = 0
  NoFarClip,                ///< far plane ignored
  ViewportFlipped,          ///< negative viewport height ignored
  ScissorOffByOne,          ///< scissor one pixel too wide
  DepthTestInverted,        ///< LESS and GREATER exchanged
  DepthWriteIgnored,        ///< depth write mask ignored
  ClipAttributeUnadjusted,  ///< varyings of clipped vertices copied from the nearer end
  StripParityIgnored,       ///< odd triangles of a strip keep their winding reversed
  FirstWins,                ///< overlapping primitives: the first stays
  IndexOffByOne,            ///< the last index of an indexed draw repeated
  RestartIgnored,           ///< primitive restart: the strips are joined
  PolygonModeIgnored,       ///< LINE and POINT filled
  ClipDistanceIgnored,      ///< user clip distances without effect
  ClipDistanceExclusive,    ///< a clip distance of exactly 0 is outside
  CullDistanceIgnored,      ///< cull distances without effect
  CullDistanceAny,          ///< one negative cull distance is enough to discard
  DepthClipIgnored,         ///< near and far plane never clip
  DepthClipForced,          ///< near and far plane clip although they are off
  ViewportIndexIgnored,     ///< every draw goes through viewport 0
  PointRounded,             ///< points centred on the pixel their vertex lies in
  PointSizeIgnored,         ///< every point one pixel wide
  PointClippedByExtent,     ///< a point whose square leaves the view volume is discarded
  LineWidthIgnored,         ///< every line one pixel wide
  LineEndIncluded,          ///< lines one pixel too long
  LineModeExchanged,        ///< rectangular lines drawn as Bresenham lines and the other way round
  StippleIgnored,           ///< stippled lines drawn solid
  StippleNotReset,          ///< the stipple counter runs on between independent segments
  DepthBiasUnclamped,     ///< depthBiasClamp ignored
  DepthBiasTripled,       ///< depthBiasConstantFactor three times as large
  DepthBiasSlopeIgnored,  ///< depthBiasSlopeFactor without effect
  DepthBiasOnFillOnly,    ///< no depth bias in polygon modes LINE and POINT
  DepthTruncated,         ///< fixed-point depth two steps below the nearest
  DepthClampIgnored,      ///< depth is not clamped to the viewport's range
  DepthClampBeforeBias,   ///< depth clamped first, biased then
  SampleMaskIgnored,      ///< pSampleMask without effect
  SampleMaskShifted,      ///< bit s of pSampleMask taken for sample s + 1
  CoverageMaskReversed,   ///< the bits of a fragment's coverage mask in reverse order
  SampleMaskInFull,       ///< SampleMask always has all bits
  SampleIdZero,           ///< one invocation shades all samples as sample 0
  CentroidIgnored,        ///< centroid inputs evaluated at the centre, covered or not
  SampleAtCentre,         ///< sample inputs evaluated at the centre
  OffsetFlipped,          ///< the offset of interpolateAtOffset subtracted
  FragCoordInteger,       ///< FragCoord without the half pixel to the centre
  FragCoordW,             ///< FragCoord.w is w, not 1 / w
  FrontFacingInverted,    ///< FrontFacing exchanged, for lines and points too
  PointCoordUp,           ///< the second point coordinate runs upward
  LineAttributesByX,      ///< values along a line follow x alone
  FlatFromWrongLineEnd,   ///< flat values of lines from the end that does not provoke
  AlphaInverted,          ///< alpha to coverage with 1 - alpha
  ResolveSampleZero,      ///< resolve takes sample 0 for the average
};

struct DeliberateErrorInfo {
  DeliberateError error;
  std::string_view name;  ///< as on the command line: `mutant:truncating-snap`
  std::string_view rule;  ///< id of RULES (R14 ...) that it breaks
  std::string_view what;
};

[[nodiscard]] std::span<const DeliberateErrorInfo> deliberateErrors();
[[nodiscard]] std::optional<DeliberateError> deliberateErrorByName(std::string_view name);

}  // namespace rasterdiff::rasterizer
