#include "rasterizer/deliberate_error.hpp"

#include <array>

namespace rasterdiff::rasterizer {
namespace {

using enum DeliberateError;

constexpr std::array kErrors{
    DeliberateErrorInfo{TieOwnerBottomRight, "tie-owner-bottom-right", "R15", "edge samples go to the bottom-right polygon"},
    DeliberateErrorInfo{TiesCoveredByBoth, "ties-covered-by-both", "R15", "every edge owns its samples: shared edges are drawn twice"},
    DeliberateErrorInfo{TiesCoveredByNone, "ties-covered-by-none", "R15", "no edge owns its samples: shared edges have seams"},
    DeliberateErrorInfo{TruncatingSnap, "truncating-snap", "R14", "vertex coordinates are rounded toward zero"},
    DeliberateErrorInfo{CoarseSnap, "coarse-snap", "R14", "4 subpixel bits where the device advertises more"},
    DeliberateErrorInfo{SampleMoved, "sample-moved", "R17", "sample 0 lies 1/16 pixel too far right"},
    DeliberateErrorInfo{SwappedWinding, "swapped-winding", "R12", "front and back facing exchanged"},
    DeliberateErrorInfo{MissingPerspective, "missing-perspective", "R21", "smooth varyings interpolated linearly on the screen"},
    DeliberateErrorInfo{PerspectiveOnLinear, "perspective-on-linear", "R21", "noperspective varyings interpolated with perspective"},
    DeliberateErrorInfo{WrongProvokingVertex, "wrong-provoking-vertex", "R11", "flat varyings taken from the other end of the primitive"},
    DeliberateErrorInfo{DepthOffByOneStep, "depth-off-by-one-step", "R22", "stored depth moved out of the legal interval by one float32 step"},
    DeliberateErrorInfo{HalfPixelShift, "half-pixel-shift", "R2", "vertices moved by half a pixel in x"},
    DeliberateErrorInfo{WrongNearPlane, "wrong-near-plane", "R3", "near plane at z = -w where it is z = 0, or the other way round"},
    DeliberateErrorInfo{NoFarClip, "no-far-clip", "R3", "far plane ignored"},
    DeliberateErrorInfo{ViewportFlipped, "viewport-flipped", "R2", "sign of the viewport's height ignored"},
    DeliberateErrorInfo{ScissorOffByOne, "scissor-off-by-one", "R39", "scissor one pixel too wide"},
    DeliberateErrorInfo{DepthTestInverted, "depth-test-inverted", "R38", "LESS and GREATER exchanged"},
    DeliberateErrorInfo{DepthWriteIgnored, "depth-write-ignored", "R38", "depth is never written"},
    DeliberateErrorInfo{ClipAttributeUnadjusted, "clip-attribute-unadjusted", "R9", "varyings of clipped vertices copied from the inner end"},
    DeliberateErrorInfo{StripParityIgnored, "strip-parity-ignored", "R11", "odd triangles of a strip keep their winding reversed"},
    DeliberateErrorInfo{FirstWins, "first-wins", "R50", "of overlapping primitives the first one stays"},
    DeliberateErrorInfo{IndexOffByOne, "index-off-by-one", "R11", "the last index of an indexed draw is the one before it"},
    DeliberateErrorInfo{RestartIgnored, "restart-ignored", "R11", "primitive restart ignored: the strips are joined"},
    DeliberateErrorInfo{PolygonModeIgnored, "polygon-mode-ignored", "R34", "polygon modes LINE and POINT are filled"},
    DeliberateErrorInfo{ClipDistanceIgnored, "clip-distance-ignored", "R5", "user clip distances have no effect"},
    DeliberateErrorInfo{ClipDistanceExclusive, "clip-distance-exclusive", "R5", "a clip distance of exactly 0 counts as outside"},
    DeliberateErrorInfo{CullDistanceIgnored, "cull-distance-ignored", "R5", "cull distances have no effect"},
    DeliberateErrorInfo{CullDistanceAny, "cull-distance-any", "R5", "one negative cull distance discards the primitive"},
    DeliberateErrorInfo{DepthClipIgnored, "depth-clip-ignored", "R4", "near and far plane never clip"},
    DeliberateErrorInfo{DepthClipForced, "depth-clip-forced", "R4", "near and far plane clip although they are switched off"},
    DeliberateErrorInfo{ViewportIndexIgnored, "viewport-index-ignored", "R2", "every draw goes through viewport 0"},
    DeliberateErrorInfo{PointRounded, "point-rounded", "R25", "points are centred on the pixel of their vertex"},
    DeliberateErrorInfo{PointSizeIgnored, "point-size-ignored", "R25", "every point is one pixel wide"},
    DeliberateErrorInfo{PointClippedByExtent, "point-clipped-by-extent", "R7", "a point whose square leaves the view volume is discarded"},
    DeliberateErrorInfo{LineWidthIgnored, "line-width-ignored", "R27", "every line is one pixel wide"},
    DeliberateErrorInfo{LineEndIncluded, "line-end-included", "R29", "lines are one pixel too long"},
    DeliberateErrorInfo{LineModeExchanged, "line-mode-exchanged", "R27", "rectangular lines are drawn as Bresenham lines and the other way round"},
    DeliberateErrorInfo{StippleIgnored, "stipple-ignored", "R32", "stippled lines are solid"},
    DeliberateErrorInfo{StippleNotReset, "stipple-not-reset", "R32", "the stipple counter runs on between independent segments"},
    DeliberateErrorInfo{DepthBiasUnclamped, "depth-bias-unclamped", "R35", "depthBiasClamp ignored"},
    DeliberateErrorInfo{DepthBiasTripled, "depth-bias-tripled", "R36", "depthBiasConstantFactor three times as large"},
    DeliberateErrorInfo{DepthBiasSlopeIgnored, "depth-bias-slope-ignored", "R35", "depthBiasSlopeFactor without effect"},
    DeliberateErrorInfo{DepthBiasOnFillOnly, "depth-bias-on-fill-only", "R37", "no depth bias in polygon modes LINE and POINT"},
    DeliberateErrorInfo{DepthTruncated, "depth-truncated", "R38", "fixed-point depth two steps below the nearest"},
    DeliberateErrorInfo{DepthClampIgnored, "depth-clamp-ignored", "R38", "depth is not clamped to the viewport's range"},
    DeliberateErrorInfo{DepthClampBeforeBias, "depth-clamp-before-bias", "R38", "depth clamped first, biased then"},
    DeliberateErrorInfo{SampleMaskIgnored, "sample-mask-ignored", "R40", "pSampleMask without effect"},
    DeliberateErrorInfo{SampleMaskShifted, "sample-mask-shifted", "R40", "bit s of pSampleMask taken for sample s + 1"},
    DeliberateErrorInfo{CoverageMaskReversed, "coverage-mask-reversed", "R16", "the bits of a fragment's coverage mask in reverse order"},
    DeliberateErrorInfo{SampleMaskInFull, "sample-mask-in-full", "R24", "SampleMask always has all bits"},
    DeliberateErrorInfo{SampleIdZero, "sample-id-zero", "R19", "one invocation shades all samples as sample 0"},
    DeliberateErrorInfo{CentroidIgnored, "centroid-ignored", "R20", "centroid inputs evaluated at the centre, covered or not"},
    DeliberateErrorInfo{SampleAtCentre, "sample-at-centre", "R20", "sample inputs evaluated at the centre"},
    DeliberateErrorInfo{OffsetFlipped, "offset-flipped", "R48", "the offset of interpolateAtOffset subtracted"},
    DeliberateErrorInfo{FragCoordInteger, "frag-coord-integer", "R23", "FragCoord without the half pixel to the centre"},
    DeliberateErrorInfo{FragCoordW, "frag-coord-w", "R23", "FragCoord.w is w, not 1 / w"},
    DeliberateErrorInfo{FrontFacingInverted, "front-facing-inverted", "R44", "FrontFacing exchanged, for lines and points too"},
    DeliberateErrorInfo{PointCoordUp, "point-coord-up", "R25", "the second point coordinate runs upward"},
    DeliberateErrorInfo{LineAttributesByX, "line-attributes-by-x", "R27", "values along a line follow x alone"},
    DeliberateErrorInfo{FlatFromWrongLineEnd, "flat-from-wrong-line-end", "R11", "flat values of lines from the end that does not provoke"},
    DeliberateErrorInfo{AlphaInverted, "alpha-inverted", "R41", "alpha to coverage with 1 - alpha"},
    DeliberateErrorInfo{ResolveSampleZero, "resolve-sample-zero", "R42", "resolve takes sample 0 for the average"},
};

}  // namespace

std::span<const DeliberateErrorInfo> deliberateErrors() { return kErrors; }

std::optional<DeliberateError> deliberateErrorByName(std::string_view name) {
  for (const DeliberateErrorInfo& entry : kErrors) {
    if (entry.name == name) return entry.error;
  }
  return std::nullopt;
}

}  // namespace rasterdiff::rasterizer
