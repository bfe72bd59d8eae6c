// The stipple counter along a line: what bits a range of counters has, and where the next segment starts.
// [vk:primsrast-lines-stipple]
#pragma once

#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/shape_facts.hpp"

namespace rasterdiff::rasterizer {

[[nodiscard]] inline StippleFacts stippleFacts(const LineStipple& stipple, uint64_t counter) {
  return {counter, static_cast<uint32_t>(counter / stipple.factor % 16), stipple.draws(counter)};
}

/// What may happen to a sample whose counter is not known exactly.
struct StippleOutcome {
  bool mayDraw = false, mayDiscard = false;
  [[nodiscard]] bool certain() const { return mayDraw != mayDiscard; }
  void add(StippleOutcome other) {
    mayDraw = mayDraw || other.mayDraw;
    mayDiscard = mayDiscard || other.mayDiscard;
  }
};

/// Over the counters lowest ≤ s ≤ highest.
[[nodiscard]] StippleOutcome stippleOutcome(const LineStipple& stipple, uint64_t lowest, uint64_t highest);
/// Over all counters.
[[nodiscard]] StippleOutcome stippleOutcome(const LineStipple& stipple);

/// The counter at the start of the next segment of the strip (a list starts every line with a zero counter).
/// Nominal: each fragment of a Bresenham line counts once, each begun unit of length of any other line.
[[nodiscard]] StippleCounter stippleAfter(const LineEnds& ends, const LineStyle& style, const Rules& rules);

}  // namespace rasterdiff::rasterizer
