// The machine that a measurement ran on, and the memory that a piece of work needs. Linux.
#pragma once

#include <optional>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness::bench {

[[nodiscard]] Machine thisMachine();

/// "AMD EPYC, 2 cores, AVX3_ZEN4, g++ 12.2.0, 2025-01-31 12:00 UTC": in one line.
[[nodiscard]] std::string machineLine(const Machine& machine);

/// How far the resident memory of this process has risen, at most, above where it stood when the meter was made.
class PeakMeter {
 public:
  PeakMeter();
  /// Bytes; none where the system does not tell.
  [[nodiscard]] std::optional<uint64_t> growth() const;

 private:
  std::optional<uint64_t> before_;
};

}  // namespace rasterdiff::harness::bench
