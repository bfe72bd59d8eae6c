// `explain` as text: the exact numbers behind one sample, the driver's answer and the verdict.
#pragma once

#include <optional>
#include <string>

#include "harness/compare/suspects.hpp"
#include "harness/compare/verdict.hpp"
#include "rasterizer/explain.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

struct DriverAnswer {
  std::string subject;  ///< subjectLine
  Frame frame;
  SceneResult verdict;  ///< about the asked sample alone
  std::optional<Suspicion> suspicion;  ///< where it differs, and the scene is small enough to try
};

struct Explanation {
  std::string address;  ///< as it was typed
  const Scene& scene;
  const rasterizer::Rules& rules;
  rasterizer::SampleQuery query;
  rasterizer::SampleExplanation sample;
  Frame reference;
  std::optional<DriverAnswer> driver;
};

[[nodiscard]] std::string explanationText(const Explanation& explanation);

}  // namespace rasterdiff::harness
