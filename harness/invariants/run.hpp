// An invariant put to a driver over random cases.
#pragma once

#include "harness/invariants/invariant.hpp"
#include "harness/subject.hpp"

namespace rasterdiff::harness::invariants {

struct Outcome {
  std::string name;
  uint64_t cases = 0, skipped = 0;  ///< drawn; not offered by the driver
  uint64_t samples = 0;             ///< that the property spoke about
  uint64_t brokenCases = 0;
  std::optional<Broken> broken;     ///< of the first broken case
  std::vector<Scene> scenes;        ///< of the first broken case
};

/// Draws `count` cases; the same seed gives the same ones, whatever other invariants do. Error: DeviceLost or TimedOut.
[[nodiscard]] Result<Outcome> run(const Invariant& invariant, Subject& subject, uint64_t seed, uint64_t count);

}  // namespace rasterdiff::harness::invariants
