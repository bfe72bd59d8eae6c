#include "rasterizer/lines/stipple.hpp"

#include <algorithm>

#include "rasterizer/lines/bresenham_line.hpp"
#include "rasterizer/lines/end_box.hpp"
#include "rasterizer/lines/float_corners.hpp"
#include "rasterizer/lines/wide_integer.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint64_t kBits = 16;

uint64_t unitsOf(int64_t subpixels) {
  return static_cast<uint64_t>(std::max<int64_t>(0, subpixels) + kSubpixelOne - 1) >> kSubpixelBits;
}

uint64_t nominalSteps(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const bool bresenham = lineKind(style, rules.limits) == LineKind::Bresenham;
  if (rules.choices.lineArithmetic == LineArithmetic::Float32Corners) {
    return dashSteps(ends.floatA, ends.floatB, !bresenham);
  }
  const SubpixelPosition a = ends.a.snapped, b = ends.b.snapped;
  if (bresenham) {
    const int64_t width = bresenhamWidth(style.width, rules.limits).nominal;
    return static_cast<uint64_t>(bresenhamLine(a, b, width, rules.choices.diamondExit).count());
  }
  return unitsOf(squareRootUp(squared(int64_t{b.x} - a.x) + squared(int64_t{b.y} - a.y)));
}

}  // namespace

StippleOutcome stippleOutcome(const LineStipple& stipple, uint64_t lowest, uint64_t highest) {
  const uint64_t first = lowest / stipple.factor, last = highest / stipple.factor;
  if (last - first >= kBits) return stippleOutcome(stipple);
  StippleOutcome outcome;
  for (uint64_t bit = first; bit <= last; ++bit) {
    const bool draws = ((stipple.pattern >> (bit % kBits)) & 1) != 0;
    outcome.add({draws, !draws});
  }
  return outcome;
}

StippleOutcome stippleOutcome(const LineStipple& stipple) { return {stipple.pattern != 0, stipple.pattern != 0xFFFF}; }

StippleCounter stippleAfter(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  // The driver takes strips apart before it stipples them (it does where the fragment shader reads the primitive's
  // number), so that every line of a strip starts anew; the edges of a triangle share one counter.
  // [choice:line-arithmetic]
  if (rules.choices.lineArithmetic == LineArithmetic::Float32Corners && !style.ofPolygon) return {};
  StippleCounter next = style.stipple.start;
  // [vk:primsrast-lines-stipple] after clipping the counter is implementation-dependent.
  next.free = next.free || ends.removed || ends.a.made || ends.b.made;
  if (ends.removed) return next;
  const uint64_t steps = nominalSteps(ends, style, rules);
  next.s += steps;
  if (lineKind(style, rules.limits) == LineKind::Bresenham) {
    // A legal placement of the ends, and [vk:primsrast-lines-bresenham], change the number of fragments by one each.
    next.lowest += steps - std::min<uint64_t>(steps, 2);
    next.highest += steps + 2;
    return next;
  }
  const Range length2 = squaredLength(EndBox(ends.a), EndBox(ends.b));
  const int64_t shortest = squareRoot(length2.low), longest = squareRootUp(length2.high);
  // A length that no float32 evaluation can get wrong: fixed, whole, and short enough for its square.
  const bool exact = shortest == longest && longest < (1 << 11);
  const int64_t slack = exact ? 0 : 1 + (longest >> 20);
  next.lowest += unitsOf(shortest - slack);
  next.highest += unitsOf(longest + slack);
  next.carried += static_cast<double>(shortest + longest) / 2;
  next.uncertainty += static_cast<double>(longest - shortest) / 2 + static_cast<double>(slack);
  return next;
}

}  // namespace rasterdiff::rasterizer
