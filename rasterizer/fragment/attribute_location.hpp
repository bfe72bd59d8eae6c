// Where in a fragment an input is evaluated: the nominal place of each interpolation, and the region of all legal ones.
// [vk:shaders-interpolation-decorations] [choice:attribute-position]
#pragma once

#include <array>

#include "rasterizer/fragment/place.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {

/// The offset of interpolateAtOffset and the rectangle it may be rounded into, pixels from the centre.
/// [vk:limits-subPixelInterpolationOffsetBits] [choice:offset-rounding] nominally not rounded.
struct EvaluationOffset {
  Spot nominal;
  std::array<Spot, 4> corners{};
  bool free = false;  ///< the corners differ from the nominal offset, and rules are open
};
[[nodiscard]] EvaluationOffset evaluationOffset(float x, float y, const Rules& rules);

/// Keeps the corners of one region alive.
struct RegionStorage {
  std::array<Spot, 4> box{};
  std::vector<Spot> polygon, scratch;
};

class AttributeLocation {
 public:
  AttributeLocation(std::vector<SubpixelPosition> pattern, const Rules& rules);

  [[nodiscard]] std::span<const SubpixelPosition> pattern() const { return pattern_; }
  [[nodiscard]] uint32_t samples() const { return static_cast<uint32_t>(pattern_.size()); }
  [[nodiscard]] bool areaIsFree() const { return areaIsFree_; }

  /// An undecorated input, around any point: there; anywhere in the pixel around it where the area is free.
  [[nodiscard]] EvaluationRegion around(Spot centre, RegionStorage& storage) const;
  /// At a sample and nowhere else.
  [[nodiscard]] EvaluationRegion atSample(const FragmentPlace& place) const;
  /// Where the rules' choice says. [choice:centroid] Under open rules anywhere in the pixel that `primitive`
  /// covers (a figure: anywhere in the pixel).
  [[nodiscard]] EvaluationRegion centroid(const FragmentPlace& place, const Primitive& primitive, RegionStorage& storage) const;
  /// Where a legal renderer (Rules::variation) evaluates an undecorated input.
  [[nodiscard]] Spot variedCentre(const FragmentPlace& place) const;
  [[nodiscard]] EvaluationRegion at(const FragmentPlace& place, const EvaluationOffset& offset, RegionStorage& storage) const;

 private:
  [[nodiscard]] Spot variedCentroid(const FragmentPlace& place) const;
  [[nodiscard]] uint32_t firstCovered(const FragmentPlace& place) const;
  [[nodiscard]] Spot meanOfCovered(const FragmentPlace& place) const;
  [[nodiscard]] Spot nominalCentroid(const FragmentPlace& place) const;

  const std::vector<SubpixelPosition> pattern_;
  const CentroidPosition centroid_;
  const bool areaIsFree_;
  const DeliberateError error_;
  const std::optional<Variation> variation_;
};

}  // namespace rasterdiff::rasterizer
