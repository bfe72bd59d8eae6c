// Rule coverage: how many times each rule decided an outcome while a scene was rendered.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

/// What the rules of docs/rules.md (R14 ...) decide: each counter goes up where another answer to its rule would have
/// given another picture. Some rules have several.
enum class Rule : uint8_t {
  ViewVolume,       ///< R3: a primitive was rejected or cut by a plane of the view volume
  ProvokingVertex,  ///< R11: a flat varying took its value from the provoking vertex, which differed from another's
  Facing,           ///< R12: the sign of the area chose front or back where that mattered
  Culling,          ///< R13: a primitive was discarded for its facing
  SampleCoverage,   ///< R14: a sample was found inside
  TieBreak,         ///< R15: a sample lay exactly on an edge
  SamplePattern,    ///< R17: some, not all, samples of a pixel were covered
  Perspective,      ///< R21: a varying was interpolated with unequal w
  DepthTest,        ///< R38: a depth test failed
  Scissor,          ///< R39: a covered sample was outside the scissor
  Order,            ///< R50: a later primitive replaced an earlier one
  DepthClip,        ///< R4: a primitive beyond the near or far plane was kept because depth clipping is off
  UserDistance,     ///< R5: a clip or cull distance cut or discarded a primitive
  PointClip,        ///< R7: a point was discarded, or kept, for its vertex being outside the view volume
  LineClip,         ///< R8: a line with an end outside the view volume
  PointSquare,      ///< R25: a sample was inside a point's square
  LineRectangle,    ///< R27: a sample was inside a line's rectangle
  LineBresenham,    ///< R29: a sample was inside a pixel of a Bresenham line
  LineStipple,      ///< R32: the stipple pattern kept or dropped a sample of a line
  PolygonMode,      ///< R34: a triangle was drawn as lines or points
  CoverageMask,         ///< R16: a mask plane took some, not all, of a fragment's bits
  SampleShading,        ///< R19: a fragment was shaded once for a sample
  AttributeLocation,    ///< R20: an input was evaluated at a sample, or away from the centre
  FragCoord,            ///< R23: a fragment's coordinates were observed
  SampleMaskIn,         ///< R24: the mask of an invocation's samples was observed
  PointCoord,           ///< R25: a coordinate within a point was observed
  DepthBiasSlope,       ///< R35: a triangle's slope or the clamp took part in its depth bias
  DepthBiasUnit,        ///< R36: the smallest resolvable difference took part in a depth bias
  DepthBiasMode,        ///< R37: a triangle drawn as lines or points, or a line or point, met depth bias
  DepthClamp,           ///< R38: a depth was clamped
  DepthConversion,      ///< R38: a depth was rounded to fixed point
  SampleMask,           ///< R40: the sample mask removed a covered sample
  AlphaToCoverage,      ///< R41: alpha removed a covered sample
  Resolve,              ///< R42: samples of a pixel that differ were averaged
  FrontFacing,          ///< R44: a fragment's facing was observed
  InterpolationOffset,  ///< R48: an input was evaluated at an offset from the centre
  Division,             ///< R1: a vertex was divided by a w other than 1
  ViewportMap,          ///< R2: a vertex went through a viewport other than the whole target with depths 0 to 1
  Partition,            ///< R6: a sample lay exactly on the outline of what a clip distance left
  ClipAttribute,        ///< R9: a sample's values came from a vertex that clipping made
  CutPolygon,           ///< R10: a sample's values came from a polygon of more than three corners
  LinearDepth,          ///< R22: a sample's depth was interpolated
  DefaultPointSize,     ///< R26: a sample was inside a point without a size
  DefaultLine,          ///< R28: a sample was inside a line of mode DEFAULT, whose outline strictLines decides
  WideBresenham,        ///< R30: a sample was inside a Bresenham line wider than a pixel
  BresenhamSamples,     ///< R31: one of several samples of a Bresenham line's pixel was covered
  HelperInvocation,     ///< R43: an uncovered pixel left or right of a covered one was shaded with it, for nothing
  Invariance,           ///< R49: a fragment met exactly the depth that an earlier one had stored
  CustomLocations,      ///< R18: some, not all, samples of a pixel with locations of its own were covered
  SmoothLine,           ///< R33: a sample was inside a smooth line
  SizeGranularity,      ///< R51: a sample was inside a point or line of fractional, rounded or clamped size
  ShaderSampleMask, ///< R40: the mask that the shader wrote removed a covered sample
  Count_,
};

struct RuleInfo {
  Rule rule;
  std::string_view id;      ///< "R15"
  std::string_view name;    ///< "tie-break"
  std::string_view anchor;  ///< "vk:primsrast-polygons-basic"
};

[[nodiscard]] std::span<const RuleInfo> countedRules();

struct RuleCounts {
  std::array<uint64_t, static_cast<size_t>(Rule::Count_)> decided{};
  uint64_t& operator[](Rule rule) { return decided[static_cast<size_t>(rule)]; }
  uint64_t operator[](Rule rule) const { return decided[static_cast<size_t>(rule)]; }
  RuleCounts& operator+=(const RuleCounts& other) {
    for (size_t i = 0; i < decided.size(); ++i) decided[i] += other.decided[i];
    return *this;
  }
};

}  // namespace rasterdiff::rasterizer
