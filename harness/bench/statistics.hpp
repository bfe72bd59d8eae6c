// Robust statistics of a few timings.
#pragma once

#include <span>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness::bench {

/// Middle value; the mean of the two middle ones of an even number. NaN for none.
[[nodiscard]] double median(std::span<const double> values);

/// Median, fastest and median absolute deviation (as a fraction of the median) of seconds, one a round.
[[nodiscard]] Timing timingOf(std::span<const double> seconds, uint32_t draws);

}  // namespace rasterdiff::harness::bench
