// Mutants: each is the reference with exactly one mistake, used as the driver under test to measure the measure.
// A mistake sits in the stage that it breaks and costs nothing when absent (stages look once a primitive, never a
// sample), or is one in what the renderer reads (mistaken_scene.hpp). What each does: deliberateErrors().
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

enum class DeliberateError : uint8_t {
  None,
  /* R1 */ ReciprocalCoarse, DepthUndivided,
  /* R2 */ HalfPixelShift, ViewportFlipped, ViewportIndexIgnored, ViewportFractionDropped, ViewportHalfDropped,
     DepthRangeSorted, DepthRangeIgnored,
  /* R3 */ WrongNearPlane, NoFarClip, SideClipIgnored, CutFanShort,
  /* R4 */ DepthClipIgnored, DepthClipForced, DepthClipStateIgnored,
  /* R5 */ ClipDistanceIgnored, ClipDistanceExclusive, CullDistanceIgnored, CullDistanceAny, ClipDistanceFirstOnly,
     CullDistanceZero,
  /* R6 */ ClipDistanceGap,
  /* R7 */ PointClippedByExtent, PointClipIgnored,
  /* R8 */ LineClipDrops,
  /* R9 */ ClipAttributeUnadjusted, LineClipValues, NoperspectiveCutByW, FlatAfterCut,
  /* R10 */ CutValuesRotated,
  /* R11 */ WrongProvokingVertex, StripParityIgnored, IndexOffByOne, RestartIgnored, FlatFromWrongLineEnd,
     FanHubProvokes,
  /* R12 */ SwappedWinding, ZeroAreaFront, FacingUnflipped, FacingBehindEye,
  /* R13 */ CullBothAsBack, OutlineNotCulled,
  /* R14 */ TruncatingSnap, CoarseSnap, CeilingSnap, FloorSnapY, SevenBitSnap, SnapOneStepAside, EdgeTenBits,
  /* R15 */ TieOwnerBottomRight, TiesCoveredByBoth, TiesCoveredByNone, TiesHorizontalBoth, TiesVerticalNone,
     TiesSlantedBoth,
  /* R16 */ CoverageMaskReversed, CoverageMaskShifted,
  /* R17 */ SampleMoved, TwoSamplesMirrored, FourSamplesMirrored, EightSamplesExchanged, SixteenSamplesInside,
  /* R18 */ SampleLocationsIgnored, SampleLocationsTransposed, SampleLocationsOfFirstPixel, SampleLocationsUnclamped,
  /* R19 */ SampleIdZero, SampleShadingIgnored,
  /* R20 */ CentroidIgnored, SampleAtCentre, CentroidUncovered, CentreAtCorner,
  /* R21 */ MissingPerspective, PerspectiveOnLinear, VaryingHalfPrecision,
  /* R22 */ DepthOffByOneStep, DepthPerspective, DepthAtCentre,
  /* R23 */ FragCoordInteger, FragCoordW, FragCoordYUp, FragCoordNotAtSample,
  /* R24 */ SampleMaskInFull, SampleMaskInOwnBit,
  /* R25 */ PointRounded, PointSizeIgnored, PointCoordUp, PointSizeDoubled,
  /* R26 */ DefaultPointSizeTwo,
  /* R27 */ LineWidthIgnored, LineModeExchanged, LineAttributesByX, LineEndsLevel, LineWidthOfXMajorOnly,
  /* R28 */ ParallelogramSquare,
  /* R29 */ LineEndIncluded, BresenhamFirstForLast, BresenhamSlopeOneByY, BresenhamAside,
  /* R30 */ BresenhamWidthTruncated, BresenhamWidthBehind,
  /* R31 */ BresenhamSamples,
  /* R32 */ StippleIgnored, StippleNotReset, StippleMsbFirst, StippleFactorIgnored, StippleFromEnd,
     StippleStripRestarts,
  /* R33 */ SmoothLinesDropped, SmoothLinesWide, SmoothAlphaIgnored,
  /* R34 */ PolygonModeIgnored, PointModeEdges, LineModeOpen,
  /* R35 */ DepthBiasUnclamped, DepthBiasSlopeIgnored, DepthBiasSlopeSum, DepthBiasSlopeX, DepthBiasClampSign,
  /* R36 */ DepthBiasTripled, DepthBiasUnitFixed, DepthBiasUnitOf24,
  /* R37 */ DepthBiasOnFillOnly,
  /* R38 */ DepthTestInverted, DepthWriteIgnored, DepthTruncated, DepthClampIgnored, DepthClampBeforeBias,
     CompareEqualExchanged, DepthWriteAfterFailure, DepthWriteWithoutTest, DepthTimesPowerOfTwo,
  /* R39 */ ScissorOffByOne, ScissorLeft, ScissorShort, ScissorOfViewportZero,
  /* R40 */ SampleMaskIgnored, SampleMaskShifted, SampleMaskAfterDepth, ShaderMaskIgnored, ShaderMaskShifted,
     ShaderMaskOfPixel, ShaderMaskAfterDepth, ShaderMaskOfOthers, ShaderMaskBitZero, ShaderMaskOverrides,
     ShaderMaskOfFirstDraw, ShaderMaskIgnoredAtOne, ShaderMaskOfUnmasked,
  /* R41 */ AlphaInverted, AlphaToCoverageIgnored, AlphaFromRed,
  /* R42 */ ResolveSampleZero, ResolveDropsLast, ResolveEightBits,
  /* R43 */ HelpersCounted,
  /* R44 */ FrontFacingInverted, LinesBackFacing,
  /* R48 */ OffsetFlipped, OffsetIgnored, OffsetCoarse,
  /* R49 */ MovedByDepthTest, MovedByScissor,
  /* R50 */ FirstWins, DrawBackward,
  /* R51 */ LineWidthWhole, PointSizeWhole,
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
