// Model only what a scene needs: derived once from a scene; both renderers and all kernels specialise on it.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace rasterdiff {

/// Planes and stages a scene asks for. Primitive index and overdraw count are always there; all else only on demand.
struct SceneNeeds {
  bool depth = false;           ///< a depth attachment exists: depth is interpolated, (perhaps) tested, read back, compared
  uint32_t varyings = 0;        ///< number of the scene's varyings
  uint32_t builtIns = 0;        ///< number of observed built-ins; planes of values: varyings + builtIns
  bool resolve = false;         ///< each varying has a plane of one value a pixel too
  uint32_t samples = 1;
};

[[nodiscard]] SceneNeeds needsOf(const Scene& scene);

// What only a look at every vertex tells.
/// Some w differs from 1: values need f/w and 1/w.
[[nodiscard]] bool needsPerspective(const Scene& scene);
/// Some vertex lies outside the clip volume: view volume and clip distances.
[[nodiscard]] bool needsClipping(const Scene& scene);

}  // namespace rasterdiff
