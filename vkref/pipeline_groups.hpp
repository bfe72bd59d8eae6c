// Which scenes are drawn with the same pipelines: one process that draws them all has the driver compile each only once.
#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include "scene/scene.hpp"

namespace rasterdiff::vkref {

class PipelineGroups {
 public:
  PipelineGroups();
  ~PipelineGroups();

  /// The number of the scene's group, from 0 in the order of first appearance. It only says what is worth doing together:
  /// the device is taken for a usual one. `scene` has passed validate().
  [[nodiscard]] size_t of(const Scene& scene);

 private:
  struct Known;
  std::unique_ptr<Known> known_;
};

}  // namespace rasterdiff::vkref
