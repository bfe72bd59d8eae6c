// Depth and varyings inside a triangle: plane equations in doubles, and the interval of legal float32 results.
//
// A value is v = N / D with N = Σ bᵢ fᵢ / wᵢ and D = Σ bᵢ / wᵢ, both linear on the screen (lecture "Perspective-correct
// interpolation"; [vk:primsrast-polygon-barycentrics]); noperspective and depth are linear themselves.
// The specification states no precision. The interval around the exact value is
//   - where the vertices may be: their deviation times the gradient, with the gradient's own change;
//   - float32 evaluation of a plane equation anchored at the framebuffer's origin, by counting roundings;
//   - under open rules, anywhere in the fragment's area for undecorated inputs of multisampled targets.
#pragma once

#include <vector>

#include "rasterizer/geometry.hpp"
#include "scene/frame.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::rasterizer {

/// value + dx (x - x0) + dy (y - y0), pixels; radius(x, y) bounds the deviation of a legal float32 evaluation there.
struct LinearFunction {
  double value = 0, dx = 0, dy = 0, x0 = 0, y0 = 0;
  double constantRadius = 0, radiusPerX = 0, radiusPerY = 0, farX = 0, farY = 0;
  [[nodiscard]] double at(double x, double y) const { return value + dx * (x - x0) + dy * (y - y0); }
  [[nodiscard]] double radius(double x, double y) const {
    return constantRadius + radiusPerX * (std::max(farX, x) + 1) + radiusPerY * (std::max(farY, y) + 1);
  }
};

struct Interpolated {
  float value = 0;
  Bounds bounds;
};

/// The planes of one piece of a primitive. Set up once a triangle, and only for what the scene needs.
class PieceValues {
 public:
  PieceValues(const Scene& scene, const SceneNeeds& needs, const Rules& rules);

  void setUp(const Primitive& primitive, const SetupTriangle& piece);

  /// Depth at a point in pixels.
  [[nodiscard]] Interpolated depth(double x, double y) const;
  /// All components of all varyings for the fragment whose centre is (x, y); `out` has componentCount() elements.
  void varyings(double x, double y, Interpolated* out) const;
  [[nodiscard]] size_t componentCount() const { return components_.size(); }

 private:
  enum class Kind : uint8_t { Perspective, Linear, Flat };
  struct Component {
    size_t varying = 0;
    uint32_t component = 0, stride = 0;
    Kind kind = Kind::Linear;
    LinearFunction function;
    float flat = 0;
  };
  struct Frame3;  // the triangle's geometry, shared by all its linear functions
  [[nodiscard]] LinearFunction linear(const Frame3& frame, const std::array<double, 3>& values, double inputError) const;
  [[nodiscard]] Interpolated perspective(const Component& component, double x, double y) const;
  [[nodiscard]] Interpolated screenLinear(const Component& component, double x, double y) const;

  const SceneNeeds needs_;
  bool areaFreedom_ = false;   ///< [choice:attribute-position] open: undecorated inputs anywhere in the pixel
  bool anyPerspective_ = false;
  bool outsidePositions_ = false;
  LinearFunction depth_, reciprocalW_;
  std::vector<Component> components_;
};

}  // namespace rasterdiff::rasterizer
