// What is drawn in a measurement: snapped triangles for the kernels, and the same triangles as scenes for the reference
// and the driver. Where they come from: the built-in workloads, or any scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/workloads.hpp"
#include "harness/bench/results.hpp"
#include "rasterizer/kernels/snapped_triangle.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::bench {

struct Load {
  std::string name, what, note;
  uint32_t width = 0, height = 0, samples = 1;
  std::vector<rasterizer::SnappedTriangle> triangles;
  std::optional<Scene> scene;  ///< what the triangles were taken from; none for a built-in workload
};

/// A built-in workload with `samples` a pixel.
[[nodiscard]] Load loadOf(rasterdiff::bench::Workload workload, uint32_t samples);

/// The filled triangles of a valid scene after clipping, culling and snapping, under the exact profile. Kernels know
/// neither scissor nor masks nor depth tests; `note` names what they leave out.
[[nodiscard]] Load loadOf(const Scene& scene);

/// The tasks that a load stands for: all of them, or the one of its own scene.
[[nodiscard]] std::vector<Task> tasksOf(const Load& load);

/// What the vertices of a built-in workload carry besides their place, three vertices a triangle: depths in [0, 1) of 24
/// bits, w of 1, 2 or 4 (so that z · w and 1 / w are exact), four components in [0, 1). The same for every load.
struct Attributes {
  std::vector<float> depth, reciprocalW, values;
};
inline constexpr uint32_t kComponents = 4;
[[nodiscard]] Attributes attributesOf(size_t triangles);

/// The first `triangles` of a load as a scene (a load's own scene is always whole): vertices in pixels, brought to clip
/// space; for Depth and Varyings with the depths and w of attributesOf, LESS and written; for Varyings with one smooth
/// input of its components.
[[nodiscard]] Scene sceneOf(const Load& load, Task task, size_t triangles);

/// Samples of the target that the triangles cover, overdraw counted: their area where they lie inside the target, else
/// counted.
[[nodiscard]] double coveredSamples(const Load& load, size_t triangles);

}  // namespace rasterdiff::harness::bench
