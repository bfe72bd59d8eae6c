// Values as a random legal renderer evaluates them: in float32, in its own order, at its own places of a fragment.
#include "rasterizer/interpolation.hpp"

namespace rasterdiff::rasterizer {
namespace {

template <size_t n>
std::array<float, n> toFloats(const std::array<double, n>& values) {
  std::array<float, n> result{};
  for (size_t i = 0; i < n; ++i) result[i] = static_cast<float>(values[i]);
  return result;
}

FloatSpot floatSpot(const Spot& spot) { return {static_cast<float>(spot.x), static_cast<float>(spot.y)}; }

FloatSpot cornerOf(const RasterVertex& vertex, bool snapped) {
  if (!snapped) return floatSpot({vertex.position.x, vertex.position.y});
  return floatSpot({vertex.snapped.x / double{kSubpixelOne}, vertex.snapped.y / double{kSubpixelOne}});
}

}  // namespace

void PieceValues::varyTriangle(const Corners& piece) {
  const Variation& variation = *rules_.variation;
  Corners v = piece;
  if (variation.uncutCorners && uncut_) v = {&(*uncut_)[0], &(*uncut_)[1], &(*uncut_)[2]};
  std::array<FloatSpot, 3> corners;
  for (size_t i = 0; i < 3; ++i) corners[i] = cornerOf(*v[i], variation.snappedCorners);
  if (!FloatFunction::hasArea(corners)) {  // what is drawn has one after snapping
    v = piece;
    for (size_t i = 0; i < 3; ++i) corners[i] = cornerOf(*v[i], true);
  }
  varied_.emplace().inputs.resize(inputs_.size());
  fillPlanes(v, *varied_, [&](const std::array<double, 3>& values, double, double) {
    return FloatFunction(variation.arithmetic, corners, toFloats(values));
  });
}

void PieceValues::varyLine(const Figure& figure, bool majorAxis) {
  const bool snapped = rules_.variation->snappedCorners;
  const FloatSpot a = cornerOf(figure.a, snapped), b = cornerOf(figure.b, snapped);
  varied_.emplace().inputs.resize(inputs_.size());
  fillPlanes(std::array<const RasterVertex*, 2>{&figure.a, &figure.b}, *varied_,
             [&](const std::array<double, 2>& values, double, double) { return FloatFunction(a, b, majorAxis, toFloats(values)); });
}

Interval PieceValues::varied(size_t component, Spot spot) const {
  const FloatSpot at = floatSpot(spot);
  float value = varied_->inputs[component].at(at);
  if (inputs_[component].kind == Kind::Perspective) {
    const float w = varied_->reciprocalW.at(at);
    value = rules_.variation->reciprocal ? value * (1 / w) : value / w;
  }
  return {value, value, value};
}

void PieceValues::variedFragment(const FragmentPlace& place, Interpolated* out) {
  for (size_t c = 0; c < inputs_.size(); ++c) {
    const Component& component = inputs_[c];
    const Spot spot = component.location == Location::Centre ? location_.variedCentre(place) : regionOf(component, place).nominal;
    *out++ = component.kind == Kind::Flat ? exactly(constants_[c]) : toFloat(varied(c, spot));
  }
  if (!builtIns_.any()) return;
  Interval depth, reciprocalW;
  if (builtIns_.observe(BuiltIn::FragCoord)) {
    const FloatSpot at = floatSpot(builtIns_.fragCoordRegion(place, location_, storage_).nominal);
    const double z = varied_->depth.at(at), w = varied_->reciprocalW.at(at);
    depth = depthStage_.shown({z, z, z});
    reciprocalW = {w, w, w};
  }
  builtIns_.evaluate(place, location_, depth, reciprocalW, out);
}

}  // namespace rasterdiff::rasterizer
