// The inputs of a scene's fragments, component by component: how each is interpolated and where, and its values at the
// corners or ends of a primitive.
#pragma once

#include <array>
#include <vector>

#include "rasterizer/fragment/attribute_location.hpp"
#include "rasterizer/fragment/value_planes.hpp"

namespace rasterdiff::rasterizer {

class FragmentInputs {
 public:
  enum class Kind : uint8_t { Perspective, Linear, Flat };
  enum class Location : uint8_t { Centre, Centroid, Sample, Offset };
  struct Component {
    size_t varying = 0;
    uint32_t component = 0, stride = 0;
    Kind kind = Kind::Linear;
    Location location = Location::Centre;
    EvaluationOffset offset;
  };

  FragmentInputs(const Scene& scene, const Rules& rules);

  [[nodiscard]] size_t size() const { return components_.size(); }
  [[nodiscard]] const Component& operator[](size_t c) const { return components_[c]; }
  [[nodiscard]] bool anyPerspective() const { return anyPerspective_; }
  [[nodiscard]] bool anyAt(Location location) const { return anyAt_[static_cast<size_t>(location)]; }

  /// planes.inputs[c] = make(values of component c at `vertices`, bound on their deviation), flat ones left out.
  template <size_t kVertices, class Planes, class Make>
  void fill(const Primitive& primitive, const std::array<const RasterVertex*, kVertices>& vertices, Planes& planes,
            const Make& make) const {
    for (size_t c = 0; c < components_.size(); ++c) {
      const Component& component = components_[c];
      if (component.kind == Kind::Flat) continue;
      const std::array<double, 3> corners = cornersOf(component, primitive);
      std::array<double, kVertices> values{};
      double inputError = 0;
      for (size_t i = 0; i < kVertices; ++i) {
        values[i] = valueAt(component, *vertices[i], corners);
        inputError = std::max(inputError, errorAt(component, *vertices[i], corners, values[i]));
      }
      planes.inputs[c] = make(values, inputError);
    }
  }

  /// What the fragments of a point have, nothing being interpolated. [vk:shaders-interpolation-decorations]
  void fillPoint(const Primitive& primitive, const RasterVertex& vertex, ValuePlanes& planes,
                 std::vector<float>& constants) const;
  /// The provoking vertex's values of flat components. [vk:vertexpostproc-flatshading]
  void fillFlat(const Primitive& primitive, std::vector<float>& constants) const;

 private:
  [[nodiscard]] static Component componentOf(const Varying& varying, const Rules& rules);
  [[nodiscard]] static std::array<double, 3> cornersOf(const Component& component, const Primitive& primitive);
  [[nodiscard]] static double valueAt(const Component& component, const RasterVertex& vertex, const std::array<double, 3>& corners);
  [[nodiscard]] static double errorAt(const Component& component, const RasterVertex& vertex,
                                      const std::array<double, 3>& corners, double value);

  std::vector<Component> components_;
  const bool flatFromWrongLineEnd_;
  bool anyPerspective_ = false;
  std::array<bool, 4> anyAt_{};
};

}  // namespace rasterdiff::rasterizer
