#include "rasterizer/fragment/fragment_inputs.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

double largestOf(const std::array<double, 3>& corners) {
  return std::max({std::fabs(corners[0]), std::fabs(corners[1]), std::fabs(corners[2])});
}

double weighted(const std::array<double, 3>& weights, const std::array<double, 3>& values) {
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
}

}  // namespace

FragmentInputs::Component FragmentInputs::componentOf(const Varying& varying, const Rules& rules) {
  Component component;
  component.stride = varying.components;
  switch (varying.interpolation) {
    case Interpolation::flat: component.kind = Kind::Flat; return component;
    case Interpolation::noperspective:
      component.kind = rules.error == DeliberateError::PerspectiveOnLinear ? Kind::Perspective : Kind::Linear;
      return component;
    case Interpolation::smooth: break;
    case Interpolation::centroid: component.location = Location::Centroid; break;
    case Interpolation::sample: component.location = Location::Sample; break;
    case Interpolation::offset:
      component.location = Location::Offset;
      component.offset = evaluationOffset(varying.offsetX, varying.offsetY, rules);
      break;
  }
  component.kind = rules.error == DeliberateError::MissingPerspective ? Kind::Linear : Kind::Perspective;
  return component;
}

FragmentInputs::FragmentInputs(const Scene& scene, const Rules& rules)
    : flatFromWrongLineEnd_(rules.error == DeliberateError::FlatFromWrongLineEnd) {
  if (scene.draws.empty()) return;
  for (size_t v = 0; v < scene.draws[0].varyings.size(); ++v) {
    const Varying& varying = scene.draws[0].varyings[v];
    Component component = componentOf(varying, rules);
    component.varying = v;
    for (uint32_t c = 0; c < varying.components; ++c) {
      component.component = c;
      components_.push_back(component);
    }
    anyPerspective_ = anyPerspective_ || component.kind == Kind::Perspective;
    anyAt_[static_cast<size_t>(component.location)] = true;
  }
}

std::array<double, 3> FragmentInputs::cornersOf(const Component& component, const Primitive& primitive) {
  const std::vector<float>& values = primitive.draw->varyings[component.varying].values;
  std::array<double, 3> corners{};
  for (size_t i = 0; i < 3; ++i) {
    corners[i] = double{values[size_t{primitive.assembled.vertices[i]} * component.stride + component.component]};
  }
  return corners;
}

double FragmentInputs::valueAt(const Component& component, const RasterVertex& vertex, const std::array<double, 3>& corners) {
  if (component.kind == Kind::Linear) return weighted(vertex.linearWeights, corners);
  return weighted(vertex.smoothWeights, corners) * vertex.reciprocalW;
}

// f / w: two roundings; a lerped attribute: 6 more of the largest corner, as for clipped positions.
double FragmentInputs::errorAt(const Component& component, const RasterVertex& vertex, const std::array<double, 3>& corners,
                               double value) {
  const bool correct = component.kind == Kind::Perspective;
  const double scale = correct ? std::fabs(vertex.reciprocalW) : 1;
  return std::fabs(value) * (2 * kHalfUlp + (correct ? vertex.relativeWError : 0)) +
         (vertex.made ? 6 * kHalfUlp * largestOf(corners) * scale : 0);
}

void FragmentInputs::fillPoint(const Primitive& primitive, const RasterVertex& vertex, ValuePlanes& planes,
                               std::vector<float>& constants) const {
  for (size_t c = 0; c < components_.size(); ++c) {
    const Component& component = components_[c];
    if (component.kind == Kind::Flat) continue;
    const std::array<double, 3> corners = cornersOf(component, primitive);
    LinearFunction constant;
    constant.value = weighted(component.kind == Kind::Perspective ? vertex.smoothWeights : vertex.linearWeights, corners);
    // A corner that clipping made has lerped attributes.
    constant.constantRadius = vertex.made ? 8 * kHalfUlp * largestOf(corners) : 0;
    planes.inputs[c] = constant;
    constants[c] = static_cast<float>(constant.value);
  }
}

void FragmentInputs::fillFlat(const Primitive& primitive, std::vector<float>& constants) const {
  const AssembledTriangle& assembled = primitive.assembled;
  uint32_t vertex = assembled.provoking;
  if (assembled.count == 2 && flatFromWrongLineEnd_) {
    vertex = vertex == assembled.vertices[0] ? assembled.vertices[1] : assembled.vertices[0];
  }
  for (size_t c = 0; c < components_.size(); ++c) {
    const Component& component = components_[c];
    if (component.kind != Kind::Flat) continue;
    constants[c] = primitive.draw->varyings[component.varying].values[size_t{vertex} * component.stride + component.component];
  }
}

}  // namespace rasterdiff::rasterizer
