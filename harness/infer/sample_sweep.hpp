// Where the samples of a pixel are: level edges stepped over one pixel by 1/16, and which samples they leave.
#pragma once

#include "harness/infer/finding.hpp"
#include "harness/subject.hpp"

namespace rasterdiff::harness {

/// For each sample, the last of the steps 0, 1, ... 16 sixteenths at which a left (top) edge still covers it, or -1: the
/// sample's own place if such edges own what lies on them, else the step before it.
struct SampleSweep {
  uint32_t samples = 1;
  std::vector<int32_t> lastLeft{}, lastTop{};
};

/// Error: the driver's own, NotOffered among them.
[[nodiscard]] Result<SampleSweep> sweepSamples(Subject& subject, uint32_t samples);

/// Sets the locations that the sweeps mean under the owner of ties in `choices`; none if all are the standard ones.
void placeSamples(std::span<const SampleSweep> sweeps, rasterizer::Choices& choices);

}  // namespace rasterdiff::harness
