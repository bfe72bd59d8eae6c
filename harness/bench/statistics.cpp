#include "harness/bench/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterdiff::harness::bench {

double median(std::span<const double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

Timing timingOf(std::span<const double> seconds, uint32_t draws) {
  Timing timing;
  timing.median = median(seconds);
  timing.fastest = *std::min_element(seconds.begin(), seconds.end());
  std::vector<double> distances;
  for (const double s : seconds) distances.push_back(std::fabs(s - timing.median));
  timing.deviation = timing.median > 0 ? median(distances) / timing.median : 0;
  timing.rounds = static_cast<uint32_t>(seconds.size());
  timing.draws = draws;
  return timing;
}

}  // namespace rasterdiff::harness::bench
