#include "rasterizer/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kHalfUlp = 0x1p-24;  // relative rounding error of float32
constexpr double kInfinity = std::numeric_limits<double>::infinity();

float downward(double value) {
  const float rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float upward(double value) {
  const float rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

Interpolated within(double value, double lo, double hi) {
  if (std::isnan(lo) || std::isnan(hi)) {
    lo = -kInfinity;
    hi = kInfinity;
  }
  return {static_cast<float>(value), {downward(lo), upward(hi)}};
}

double weighted(const std::array<double, 3>& weights, const std::array<double, 3>& values) {
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
}

}  // namespace

struct PieceValues::Frame3 {
  double x[3], y[3];
  double e1x, e1y, e2x, e2y, determinant;
  double perimeter;   // L1, pixels
  double deviation;   // pixels
  double condition;   // 1 + (|e| + |f|) / |det|, how much the determinant's cancellation amplifies roundings
  double sensitivity; // relative change of the determinant under legal placements
  double spread;      // bound on Σ |bᵢ| where values are evaluated
};

PieceValues::PieceValues(const Scene& scene, const SceneNeeds& needs, const Rules& rules) : needs_(needs) {
  if (scene.draws.empty()) return;
  const bool multisampled = scene.target.samples > 1;
  areaFreedom_ = rules.open && multisampled;
  outsidePositions_ = multisampled;
  for (size_t v = 0; v < scene.draws[0].varyings.size(); ++v) {
    const Varying& varying = scene.draws[0].varyings[v];
    Kind kind = Kind::Flat;
    if (varying.interpolation == Interpolation::smooth) {
      kind = rules.error == DeliberateError::MissingPerspective ? Kind::Linear : Kind::Perspective;
    } else if (varying.interpolation == Interpolation::noperspective) {
      kind = rules.error == DeliberateError::PerspectiveOnLinear ? Kind::Perspective : Kind::Linear;
    }
    anyPerspective_ = anyPerspective_ || kind == Kind::Perspective;
    for (uint32_t c = 0; c < varying.components; ++c) components_.push_back({v, c, varying.components, kind, {}, 0});
  }
}

LinearFunction PieceValues::linear(const Frame3& f, const std::array<double, 3>& a, double inputError) const {
  LinearFunction result;
  const double d1 = a[1] - a[0], d2 = a[2] - a[0];
  const double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  result.value = a[0];
  result.x0 = f.x[0];
  result.y0 = f.y[0];
  if (f.determinant == 0 || f.sensitivity >= 0.5) {
    // A sliver whose area a legal placement can halve or lose: its plane is not determined.
    if (f.determinant != 0) {
      result.dx = (d1 * f.e2y - d2 * f.e1y) / f.determinant;
      result.dy = (d2 * f.e1x - d1 * f.e2x) / f.determinant;
    }
    result.constantRadius = d1 == 0 && d2 == 0 ? 4 * kHalfUlp * largest * f.condition : kInfinity;
    return result;
  }
  const double area = std::fabs(f.determinant);
  result.dx = (d1 * f.e2y - d2 * f.e1y) / f.determinant;
  result.dy = (d2 * f.e1x - d1 * f.e2x) / f.determinant;
  // Roundings of float32, each 2^-24 relative. Gradient: differences 2, product 1, sum 1, 1/det 1, product 1, and the
  // determinant's own 3 amplified by its condition. Anchor at the origin and final sum: 3 products and sums each.
  const double gradientX = (std::fabs(d1 * f.e2y) + std::fabs(d2 * f.e1y)) / area;
  const double gradientY = (std::fabs(d2 * f.e1x) + std::fabs(d1 * f.e2x)) / area;
  const double roundings = 6 + 3 * f.condition + 6;
  result.radiusPerX = kHalfUlp * roundings * gradientX;
  result.radiusPerY = kHalfUlp * roundings * gradientY;
  // Placement: the value at a point moves by Σ |bᵢ| δ |gradient|; the gradient itself may change with the determinant.
  const double change = 2 * f.deviation * (std::fabs(d1) + std::fabs(d2)) / area;
  const double steepest = (std::fabs(result.dx) + std::fabs(result.dy) + 2 * change) / (1 - f.sensitivity);
  result.constantRadius = f.spread * (3 * kHalfUlp * largest + inputError + f.deviation * steepest);
  result.farX = std::max({std::fabs(f.x[0]), std::fabs(f.x[1]), std::fabs(f.x[2])});
  result.farY = std::max({std::fabs(f.y[0]), std::fabs(f.y[1]), std::fabs(f.y[2])});
  return result;
}

void PieceValues::setUp(const Primitive& primitive, const SetupTriangle& piece) {
  if (!needs_.depth && components_.empty()) return;
  const RasterVertex* v[3];
  Frame3 f{};
  for (size_t i = 0; i < 3; ++i) {
    v[i] = &primitive.polygon[piece.corner[i]];
    f.x[i] = v[i]->position.x;
    f.y[i] = v[i]->position.y;
    f.deviation = std::max(f.deviation, v[i]->deviation);
  }
  f.e1x = f.x[1] - f.x[0];
  f.e1y = f.y[1] - f.y[0];
  f.e2x = f.x[2] - f.x[0];
  f.e2y = f.y[2] - f.y[0];
  f.determinant = f.e1x * f.e2y - f.e1y * f.e2x;
  const double area = std::fabs(f.determinant);
  f.perimeter = std::fabs(f.e1x) + std::fabs(f.e1y) + std::fabs(f.e2x) + std::fabs(f.e2y) +
                std::fabs(f.e2x - f.e1x) + std::fabs(f.e2y - f.e1y);
  f.condition = 1 + (std::fabs(f.e1x * f.e2y) + std::fabs(f.e1y * f.e2x)) / area;
  f.sensitivity = (f.deviation * f.perimeter + 6 * f.deviation * f.deviation) / area;
  const auto spreadAt = [&](double outside) { return 1 + 2 * (f.deviation + 0x1p-7 + outside) * f.perimeter / area; };

  if (needs_.depth) {
    f.spread = spreadAt(0);
    const double inputError = std::max({v[0]->depthError, v[1]->depthError, v[2]->depthError});
    depth_ = linear(f, {v[0]->position.z, v[1]->position.z, v[2]->position.z}, inputError);
  }
  if (components_.empty()) return;
  // Undecorated inputs of a multisampled fragment may be evaluated outside the triangle, within its pixel.
  f.spread = spreadAt(outsidePositions_ ? 1 : 0);
  const std::array<double, 3> q{v[0]->reciprocalW, v[1]->reciprocalW, v[2]->reciprocalW};
  const bool made = v[0]->made || v[1]->made || v[2]->made;
  if (anyPerspective_) {
    double inputError = 0;
    for (size_t i = 0; i < 3; ++i) inputError = std::max(inputError, std::fabs(q[i]) * (kHalfUlp + v[i]->relativeWError));
    reciprocalW_ = linear(f, q, inputError);
  }
  for (Component& component : components_) {
    const std::vector<float>& values = primitive.draw->varyings[component.varying].values;
    const auto valueOf = [&](uint32_t vertex) { return values[size_t{vertex} * component.stride + component.component]; };
    if (component.kind == Kind::Flat) {
      component.flat = valueOf(primitive.assembled.provoking);
      continue;
    }
    const std::array<double, 3> corners{valueOf(primitive.assembled.vertices[0]), valueOf(primitive.assembled.vertices[1]),
                                        valueOf(primitive.assembled.vertices[2])};
    const double largest = std::max({std::fabs(corners[0]), std::fabs(corners[1]), std::fabs(corners[2])});
    std::array<double, 3> a{};
    double inputError = 0;
    for (size_t i = 0; i < 3; ++i) {
      const bool perspectiveCorrect = component.kind == Kind::Perspective;
      a[i] = weighted(perspectiveCorrect ? v[i]->smoothWeights : v[i]->linearWeights, corners);
      if (perspectiveCorrect) a[i] *= q[i];
      // f / w: two roundings; a lerped attribute: 6 more of the largest corner, as for clipped positions.
      const double scale = perspectiveCorrect ? std::fabs(q[i]) : 1;
      inputError = std::max(inputError, std::fabs(a[i]) * (2 * kHalfUlp + (perspectiveCorrect ? v[i]->relativeWError : 0)) +
                                            (made ? 6 * kHalfUlp * largest * scale : 0));
    }
    component.function = linear(f, a, inputError);
  }
}

Interpolated PieceValues::depth(double x, double y) const {
  const double value = depth_.at(x, y);
  const double radius = depth_.radius(x, y) + kHalfUlp * std::fabs(value);
  return within(value, value - radius, value + radius);
}

Interpolated PieceValues::perspective(const Component& component, double x, double y) const {
  const double denominator = reciprocalW_.at(x, y);
  const double value = component.function.at(x, y) / denominator;
  const double weight = std::fabs(denominator);
  const double radiusN = component.function.radius(x, y), radiusD = reciprocalW_.radius(x, y);
  if (!(weight > radiusD)) return within(value, -kInfinity, kInfinity);
  double lo = value, hi = value, smallestWeight = weight;
  if (areaFreedom_) {
    for (int corner = 0; corner < 4; ++corner) {
      const double cx = x + ((corner & 1) != 0 ? 0.5 : -0.5), cy = y + ((corner & 2) != 0 ? 0.5 : -0.5);
      const double d = reciprocalW_.at(cx, cy);
      if ((d > 0) != (denominator > 0) || !(std::fabs(d) > radiusD)) return within(value, -kInfinity, kInfinity);
      const double v = component.function.at(cx, cy) / d;
      lo = std::min(lo, v);
      hi = std::max(hi, v);
      smallestWeight = std::min(smallestWeight, std::fabs(d));
    }
  }
  const double magnitude = std::max(std::fabs(lo), std::fabs(hi));
  // The quotient's first-order bound, and a reciprocal, a product and its roundings.
  const double radius = (radiusN + magnitude * radiusD) / (smallestWeight - radiusD) + 4 * kHalfUlp * magnitude;
  return within(value, lo - radius, hi + radius);
}

Interpolated PieceValues::screenLinear(const Component& component, double x, double y) const {
  const LinearFunction& f = component.function;
  const double value = f.at(x, y);
  const double area = areaFreedom_ ? 0.5 * (std::fabs(f.dx) + std::fabs(f.dy)) : 0;
  const double radius = f.radius(x, y) + area + kHalfUlp * std::fabs(value);
  return within(value, value - radius, value + radius);
}

void PieceValues::varyings(double x, double y, Interpolated* out) const {
  for (const Component& component : components_) {
    switch (component.kind) {
      case Kind::Flat: *out++ = {component.flat, {component.flat, component.flat}}; break;
      case Kind::Linear: *out++ = screenLinear(component, x, y); break;
      case Kind::Perspective: *out++ = perspective(component, x, y); break;
    }
  }
}

}  // namespace rasterdiff::rasterizer
