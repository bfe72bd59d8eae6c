// What a scene asks for, as a set of small facts: the axes along which the search looks for new pairs, and the name of
// a finding once everything that is not needed has been dropped.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace rasterdiff::harness::hunt {

enum class Trait : uint8_t {
  Points, Lines, Triangles, Strip, Fan, Indexed, Restart, SeveralDraws, SeveralPrimitives, NoArea, BetweenNoArea, AloneOfThree,
  Multisampled, PolygonLine, PolygonPoint, Culled, Clockwise, LastProvoking,
  Scissor, ViewportElsewhere, ViewportFlipped, DepthRange, SeveralViewports,
  LeavesSides, LeavesDepth, NoPositiveW, Perspective, NegativeOneToOne,
  Depth, DepthUnorm, DepthTest, DepthBias, DepthClamp, DepthClipStated,
  WideLine, Bresenham, Rectangular, SmoothLine, SecondAlpha, Stipple, LargePoint, SmallPoint,
  ClipDistance, CullDistance, CullBehindClip, SampleMask, SampleMaskAtOneSample, ShaderMask, ShaderMaskShifted, SampleShading, AlphaToCoverage, Resolve, SampleLocations,
  Smooth, NoPerspective, Flat, Centroid, Sample, Offset,
  FragCoord, FrontFacing, PointCoord, SampleMaskIn, SampleId, SamplePosition,
  NonFinite, Count_
};

using Traits = std::bitset<static_cast<size_t>(Trait::Count_)>;

[[nodiscard]] std::string_view nameOf(Trait trait);  ///< "clip-distance"

[[nodiscard]] Traits traitsOf(const Scene& scene);

/// "triangles clip-distance": the names, separated by `separator`.
[[nodiscard]] std::string namesOf(const Traits& traits, char separator = ' ');

/// The traits of a list of names, separated by a space; words that name no trait are passed over.
[[nodiscard]] Traits traitsNamed(std::string_view names);

[[nodiscard]] inline bool includes(const Traits& all, const Traits& some) { return (all & some) == some; }

}  // namespace rasterdiff::harness::hunt
