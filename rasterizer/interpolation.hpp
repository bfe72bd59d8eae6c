// Depth, varyings and built-ins of a fragment: nominal values in doubles, and the interval of legal float32 results.
//
// The specification states no precision. The interval around the exact value is
//   - where the vertices may be: their deviation times the gradient, with the gradient's own change;
//   - float32 evaluation of a plane equation anchored at the framebuffer's origin, by counting roundings;
//   - where in the fragment an input may be evaluated, and by which formula (fragment/, depth/).
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "rasterizer/depth/depth_stage.hpp"
#include "rasterizer/fragment/built_in_values.hpp"
#include "rasterizer/fragment/fragment_inputs.hpp"
#include "rasterizer/kernels/value_target.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::rasterizer {

/// The planes of one triangle, line or point. Set up once for each, and only for what the scene needs.
class PieceValues {
 public:
  /// `counts`, if given, must outlive this object.
  PieceValues(const Scene& scene, const SceneNeeds& needs, const Rules& rules, RuleCounts* counts = nullptr);

  /// The primitive has to live until the last evaluation.
  void setUp(const Primitive& primitive, const SetupTriangle& piece);
  /// Values along a line, or of a point.
  void setUp(const Primitive& primitive, const Figure& figure);

  /// Depth at a sample's place in pixels, as the depth test sees it: biased, clamped, in the attachment's format.
  [[nodiscard]] Interpolated depth(double x, double y) const;
  /// All components of all varyings, then of all built-ins, of one sample of a fragment; `out` has componentCount()
  /// elements.
  void fragment(const FragmentPlace& place, Interpolated* out);
  /// All components of all varyings evaluated at one point, whatever their interpolation says of places.
  void varyings(double x, double y, Interpolated* out) const;

  /// Depth is rounded and no more, and inputs are evaluated at the centre of the pixel without counting anything: then
  /// they may be evaluated when all is drawn, from planes that were kept.
  [[nodiscard]] bool mayWait() const { return mayWait_; }
  /// Where they may wait: how each component is interpolated, and whether it may legally be evaluated anywhere in the pixel.
  [[nodiscard]] std::vector<ValueKind> lateKinds() const;
  [[nodiscard]] bool lateAnywhere() const { return location_.areaIsFree(); }
  [[nodiscard]] const LinearFunction& depthPlane() const { return planes_.depth; }
  /// Appends the planes and flat inputs of the current triangle; restore() makes those of the nth that was saved current,
  /// for depth() and fragment().
  void save(std::vector<LinearFunction>& planes, std::vector<float>& constants) const;
  void restore(size_t n, std::span<const LinearFunction> planes, std::span<const float> constants);

  [[nodiscard]] size_t componentCount() const { return inputs_.size() + builtIns_.componentCount(); }
  /// Values differ between the samples of a fragment: otherwise one evaluation serves them all.
  [[nodiscard]] bool perSample() const { return perSample_; }
  /// fragment() reads FragmentPlace::covered.
  [[nodiscard]] bool needsMask() const { return needsMask_; }
  /// Mask of the samples that the current triangle or figure nominally covers at a pixel, without scissor and masks.
  [[nodiscard]] uint32_t coveredSamples(int32_t x, int32_t y) const;

 private:
  using Kind = FragmentInputs::Kind;
  using Location = FragmentInputs::Location;
  using Component = FragmentInputs::Component;

  [[nodiscard]] bool setUpCurrent(const Primitive& primitive, const SetupTriangle* piece, const Figure* figure);
  /// Fills `planes` with what `make(values at the corners or ends, inputError, outside)` makes of each value.
  template <size_t kVertices, class Planes, class Make>
  void fillPlanes(const std::array<const RasterVertex*, kVertices>& vertices, Planes& planes, const Make& make);
  using Corners = std::array<const RasterVertex*, 3>;
  [[nodiscard]] TrianglePlane planeOf(const Corners& vertices) const;
  /// Fills uncut_.
  void findUncut(const Primitive& primitive);
  /// Returns the gradient of depth, if a bias needs it.
  Gradient setUpPlanes(const Corners& vertices, const TrianglePlane& plane, ValuePlanes& planes);
  /// What a legal renderer (Rules::variation) does instead.
  void varyTriangle(const Corners& piece);
  void varyLine(const Figure& figure, bool majorAxis);
  [[nodiscard]] Interval varied(size_t component, Spot spot) const;
  template <size_t kCorners>
  void fragmentAtCentre(const FragmentPlace& place, Interpolated* out) const;
  void variedFragment(const FragmentPlace& place, Interpolated* out);
  void setUpPoint(const RasterVertex& vertex);
  void setUpLine(const Figure& figure);
  void setFigureBias(const Figure& figure);
  [[nodiscard]] Interval inputOver(size_t component, const EvaluationRegion& region) const;
  /// fragment() but for the alpha of smooth lines.
  void evaluate(const FragmentPlace& place, Interpolated* out);
  /// Alpha tells how much of the pixel a smooth line covers. [vk:fragops-covg]
  [[nodiscard]] Interpolated faded(const FragmentPlace& place, const Interpolated& alpha) const;
  /// Where a smooth line's data may be evaluated in a pixel around `centre`: the line itself may be pixels away.
  [[nodiscard]] static EvaluationRegion nearby(Spot centre, RegionStorage& storage);
  [[nodiscard]] Interval depthOver(const EvaluationRegion& region) const;
  [[nodiscard]] EvaluationRegion regionOf(const Component& component, const FragmentPlace& place);
  void count(Rule rule) const;

  const SceneNeeds needs_;
  const Rules rules_;
  const State state_;
  RuleCounts* const counts_;
  AttributeLocation location_;
  FragmentInputs inputs_;
  BuiltInValues builtIns_;
  DepthStage depthStage_;
  bool perSample_ = false, needsMask_ = false, needsW_ = false, needsDepth_ = false;
  bool atCentre_ = false;  ///< all inputs are evaluated there, and nothing else is asked for
  bool mayWait_ = false;
  bool plainDepth_ = false;        ///< of a triangle: nothing to do but to round
  bool perspectiveDepth_ = false;  ///< a deliberate error
  double outside_ = 0;  ///< pixels outside of a triangle where its planes may be evaluated

  ValuePlanes planes_;
  std::vector<float> constants_;           ///< of flat components, and of all components at a point
  std::optional<FloatPlanes> varied_;      ///< of a legal renderer: evaluated instead of planes_
  std::optional<ValuePlanes> alternative_; ///< another legal parameter of a line, or the planes of the uncut triangle
  std::optional<std::array<RasterVertex, 3>> uncut_;  ///< of a cut triangle, where its planes may go through them
  bool atPoint_ = false;
  bool smoothLine_ = false;  ///< the current figure is one
  bool hasAlpha_ = false;    ///< the first varying has four components
  bool freeDepth_ = false;  ///< a line's depth may be that of the centre or of any sample
  const Primitive* primitive_ = nullptr;
  const SetupTriangle* piece_ = nullptr;
  const Figure* figure_ = nullptr;
  RegionStorage centreStorage_, storage_;
};

[[nodiscard]] inline double reciprocalWError(const RasterVertex& v) { return std::fabs(v.reciprocalW) * (kHalfUlp + v.relativeWError); }

template <size_t kVertices, class Planes, class Make>
void PieceValues::fillPlanes(const std::array<const RasterVertex*, kVertices>& vertices, Planes& planes, const Make& make) {
  std::array<double, kVertices> values{};
  double inputError = 0;
  if (needsW_) {
    for (size_t i = 0; i < kVertices; ++i) {
      values[i] = vertices[i]->reciprocalW;
      inputError = std::max(inputError, reciprocalWError(*vertices[i]));
    }
    planes.reciprocalW = make(values, inputError, outside_);
  }
  if (needsDepth_) {
    inputError = 0;
    for (size_t i = 0; i < kVertices; ++i) {
      values[i] = vertices[i]->position.z * (perspectiveDepth_ ? vertices[i]->reciprocalW : 1);
      inputError = std::max(inputError, vertices[i]->depthError);
    }
    planes.depth = make(values, inputError, builtIns_.any() ? outside_ : 0);
  }
  inputs_.fill(*primitive_, vertices, planes, [&](const std::array<double, kVertices>& inputs, double error) {
    return make(inputs, error, outside_);
  });
}

}  // namespace rasterdiff::rasterizer
