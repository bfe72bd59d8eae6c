// The values of observed fragment shader built-ins, with what is legal for each. Depth and 1 / w come from the planes of
// the primitive, which the caller evaluates in the region that this file names. [vk:interfaces-builtin-variables]
#pragma once

#include "rasterizer/fragment/attribute_location.hpp"
#include "rasterizer/fragment/coverage_freedom.hpp"
#include "rasterizer/fragment/sample_shading.hpp"
#include "rasterizer/fragment/value_planes.hpp"

namespace rasterdiff::rasterizer {

class BuiltInValues {
 public:
  BuiltInValues(const Scene& scene, const Rules& rules, RuleCounts* counts);

  [[nodiscard]] bool any() const { return components_ > 0; }
  [[nodiscard]] size_t componentCount() const { return components_; }
  [[nodiscard]] bool observe(BuiltIn builtIn) const;
  /// Values differ between the samples of a fragment.
  [[nodiscard]] bool perSample() const { return any() && shading_.perSample; }
  [[nodiscard]] bool needsMask() const { return observe(BuiltIn::SampleMask); }

  void setUp(const Primitive& primitive, const SetupTriangle& piece);
  void setUp(const Primitive& primitive, const Figure& figure);

  /// Where FragCoord.zw are evaluated.
  [[nodiscard]] EvaluationRegion fragCoordRegion(const FragmentPlace& place, const AttributeLocation& location,
                                                 RegionStorage& storage) const;
  /// `depth` and `reciprocalW` in that region (read only if FragCoord is observed).
  void evaluate(const FragmentPlace& place, const AttributeLocation& location, const Interval& depth,
                const Interval& reciprocalW, Interpolated* out);

 private:
  void fragCoord(const FragmentPlace& place, const AttributeLocation& location, const Interval& depth,
                 const Interval& reciprocalW, Interpolated* out) const;
  void pointCoord(const FragmentPlace& place, const AttributeLocation& location, Interpolated* out) const;
  [[nodiscard]] Interpolated sampleMask(const FragmentPlace& place, const AttributeLocation& location);
  [[nodiscard]] Spot nominalSpot(const FragmentPlace& place, const AttributeLocation& location) const;
  void count(Rule rule) const;

  const std::vector<BuiltIn> observed_;
  const Rules rules_;
  const SampleShading shading_;
  const uint32_t sampleMask_, height_;
  RuleCounts* const counts_;
  size_t components_ = 0;
  CoverageFreedom coverage_;
  Interpolated facing_;
  bool isPoint_ = false;
  /// Across a point along an axis: at its own size, the smallest and the largest that it may have.
  struct AcrossPoint {
    LinearFunction own, least, most;
    [[nodiscard]] Interval over(const EvaluationRegion& region) const;
  };
  AcrossPoint pointS_, pointT_;
};

}  // namespace rasterdiff::rasterizer
