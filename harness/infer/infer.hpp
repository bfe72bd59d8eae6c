// Finds a driver's profile by experiment alone: nothing here knows a driver's name.
#pragma once

#include <functional>
#include <string_view>

#include "harness/infer/finding.hpp"
#include "harness/subject.hpp"

namespace rasterdiff::harness {

struct InferOptions {
  uint64_t seed = 1;
  /// Called after every experiment: what is being looked for, and experiments so far.
  std::function<void(std::string_view question, uint32_t scenes)> progress{};
};

/// Error: the driver's own (lost, timed out). What a device does not offer, or what no candidate explains, is a finding.
[[nodiscard]] Result<Inference> infer(Subject& subject, const InferOptions& options);

/// The rules that were found, closed except for what stayed open.
[[nodiscard]] rasterizer::Rules inferredRules(const Inference& inference, const Limits& limits);

}  // namespace rasterdiff::harness
