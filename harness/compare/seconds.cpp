#include "harness/compare/seconds.hpp"

#include <algorithm>
#include <vector>

namespace rasterdiff::harness {

Seconds medianOf(std::span<const Seconds> rounds) {
  std::vector<double> values(rounds.size());
  const auto median = [&](const auto& part) {
    std::ranges::transform(rounds, values.begin(), part);
    std::ranges::sort(values);
    const size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  };
  return {median([](const Seconds& s) { return s.setUp; }),
          median([](const Seconds& s) { return s.reference; }),
          median([](const Seconds& s) { return s.driver; }),
          median([](const Seconds& s) { return s.compare; }),
          median([](const Seconds& s) { return s.pictures; }),
          {median([](const Seconds& s) { return s.parts.drawing; }), median([](const Seconds& s) { return s.parts.pipelines; }),
           median([](const Seconds& s) { return s.parts.upload; }), median([](const Seconds& s) { return s.parts.readback; })}};
}

}  // namespace rasterdiff::harness
