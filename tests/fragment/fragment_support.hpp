// Frames of small scenes, and what makes one frame an illegal answer to another: for the tests of the fragment side.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string_view>

#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {

inline Frame drawn(const Scene& scene, const Rules& rules = testing::referenceRules(), RuleCounts* counts = nullptr) {
  Result<Frame> frame = render(scene, rules, counts);
  EXPECT_TRUE(frame) << (frame ? "" : frame.error().where + ": " + frame.error().what);
  if (frame) return std::move(*frame);
  return Frame{};
}

inline Rules specificationRules() { return Rules::specification(Limits{}); }

inline Rules withError(DeliberateError error) {
  Rules rules = testing::referenceRules();
  rules.error = error;
  return rules;
}

inline const VaryingPlane& planeOf(const std::vector<VaryingPlane>& planes, std::string_view name) {
  for (const VaryingPlane& plane : planes) {
    if (plane.name == name) return plane;
  }
  static const VaryingPlane kNone;
  ADD_FAILURE() << "no plane named " << name;
  return kNone;
}

inline bool contains(const Bounds& bounds, float value) { return value >= bounds.lo && value <= bounds.hi; }

/// Depth that is tested against nothing and always written.
inline void useDepth(Scene& scene, DepthFormat format = DepthFormat::D32_SFLOAT) {
  scene.target.depthFormat = format;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
}

/// One triangle that covers a square target of `extent` pixels, with these depths at the corners (0, 0), (2e, 0), (0, 2e).
/// The viewport is as large as the triangle, so that nothing is cut.
inline Scene coveringScene(uint32_t extent = 8, uint32_t samples = 1, double z0 = 0.5, double z1 = 0.5, double z2 = 0.5) {
  const double reach = 2.0 * extent;
  Scene scene = testing::sceneOf({{0, 0, z0}, {reach, 0, z1}, {0, reach, z2}}, 2 * extent, samples);
  scene.target.width = scene.target.height = extent;
  return scene;
}

inline void addVarying(Scene& scene, std::string_view name, Interpolation interpolation, uint32_t components,
                       std::vector<float> values) {
  Varying varying;
  varying.name = name;
  varying.interpolation = interpolation;
  varying.components = components;
  varying.values = std::move(values);
  scene.draws[0].varyings.push_back(std::move(varying));
}

/// Pixel coordinates as varyings of a covering scene: x and y are values of the plane itself.
inline std::vector<float> pixelsOf(const Scene& scene, bool x) {
  std::vector<float> values;
  const float half = scene.viewport.width / 2;
  for (const ClipPosition& p : scene.draws[0].positions) values.push_back(((x ? p.x : p.y) / p.w + 1) * half);
  return values;
}

/// Samples and values of `actual` that `reference` does not allow (coverage: that are not its nominal ones).
inline int illegalities(const Frame& reference, const Frame& actual) {
  int wrong = 0;
  const auto outside = [&wrong](const Bounds& bounds, float value) {
    const bool unbounded = bounds.hi - bounds.lo == std::numeric_limits<float>::infinity();
    if (!unbounded && !contains(bounds, value)) ++wrong;
  };
  for (size_t i = 0; i < reference.primitive.data.size(); ++i) {
    if (reference.primitive.data[i] != actual.primitive.data[i] || reference.count.data[i] != actual.count.data[i]) {
      ++wrong;
      continue;
    }
    if (reference.depth) outside(reference.depthBounds->data[i], actual.depth->data[i]);
    for (size_t v = 0; v < reference.varyings.size(); ++v) {
      const size_t components = reference.varyings[v].values.components;
      for (size_t c = i * components; c < (i + 1) * components; ++c) {
        outside(reference.varyings[v].bounds->data[c], actual.varyings[v].values.data[c]);
      }
    }
  }
  for (size_t v = 0; v < reference.resolved.size(); ++v) {
    for (size_t c = 0; c < reference.resolved[v].values.data.size(); ++c) {
      outside(reference.resolved[v].bounds->data[c], actual.resolved[v].values.data[c]);
    }
  }
  return wrong;
}

}  // namespace rasterdiff::rasterizer
