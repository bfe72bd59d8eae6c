// Green's theorem: the area of triangle ∩ {x ≤ X, y ≤ Y} is the sum of ∫ min(x(y), X) dy over the right edges, less
// that over the left edges, as far as y ≤ Y; a pixel is four such corners. Each integral is an integer, plus h² dx / dy
// where the edge itself bounds the area, plus k² dy / dx where it crosses x = X.
#include "rasterizer/methods/exact_area.hpp"

#include <algorithm>
#include <utility>

#include "rasterizer/edge_function.hpp"

namespace rasterdiff::rasterizer {
namespace {

__extension__ typedef __int128 Wide;  // squares of 2^29 times 2^29 need 87 bits

/// An edge from its upper to its lower end; dy > 0.
struct Edge {
  int64_t ax, ay, dx, dy;
};

struct Sum {
  int64_t whole = 0;
  int64_t overDx = 0, overDy = 0;  ///< numerators; four corners add up to less than 4 denominators

  void add(int64_t sign, int64_t integer) { whole += sign * integer; }
  void addFraction(int64_t sign, Wide numerator, int64_t denominator, int64_t& rest) {
    whole += sign * static_cast<int64_t>(numerator / denominator);
    rest += sign * static_cast<int64_t>(numerator % denominator);
  }
};

/// Adds sign · 2 ∫ min(x(y), right) dy over the edge's rows above `bottom`.
void addIntegral(const Edge& e, int64_t right, int64_t bottom, int64_t sign, Sum& sum) {
  const int64_t h = std::clamp<int64_t>(bottom - e.ay, 0, e.dy);
  if (h == 0) return;
  const int64_t k = right - e.ax;  // > 0: the edge starts left of `right`
  // x(end) ≤ right, times dy  // 2^29 · 2^29 on both sides
  const bool endsLeft = e.dx * h <= k * e.dy;
  if (k >= 0 && endsLeft) {  // 2 ax h + h² dx / dy
    sum.add(sign, 2 * e.ax * h);
    sum.addFraction(sign, Wide{h} * h * e.dx, e.dy, sum.overDy);
  } else if (k <= 0 && !endsLeft) {
    sum.add(sign, 2 * right * h);
  } else if (k > 0) {  // left at first, right of it in the end: 2 right h - k² dy / dx
    sum.add(sign, 2 * right * h);
    sum.addFraction(-sign, Wide{k} * k * e.dy, e.dx, sum.overDx);
  } else {  // the other way round: 2 ax h + h² dx / dy + k² dy / dx, with dx < 0
    sum.add(sign, 2 * e.ax * h);
    sum.addFraction(sign, Wide{h} * h * e.dx, e.dy, sum.overDy);
    sum.addFraction(-sign, Wide{k} * k * e.dy, -e.dx, sum.overDx);
  }
}

}  // namespace

double ExactArea::pixels() const {
  double fractions = 0;
  for (const Part& part : parts) {
    fractions += static_cast<double>(part.numerator) / static_cast<double>(part.denominator);
  }
  return (static_cast<double>(whole) + fractions) / static_cast<double>(kFullPixel);
}

ExactArea coveredArea(const SnappedTriangle& triangle, PixelIndex pixel) {
  ExactArea result;
  const int64_t area = doubleArea(triangle.v[0], triangle.v[1], triangle.v[2]);
  if (area == 0) return result;
  const int64_t left = int64_t{pixel.x} * kSubpixelOne, top = int64_t{pixel.y} * kSubpixelOne;
  for (size_t i = 0; i < 3; ++i) {
    SubpixelPosition a = triangle.v[i], b = triangle.v[(i + 1) % 3];
    if (a.y == b.y) continue;
    // Of a positively oriented triangle the edges that go down bound it to the right.
    int64_t sign = area > 0 ? 1 : -1;
    if (a.y > b.y) {
      std::swap(a, b);
      sign = -sign;
    }
    // Relative to the pixel, so that whole parts of the four corners stay small.
    const Edge edge{a.x - left, a.y - top, int64_t{b.x} - a.x, int64_t{b.y} - a.y};
    Sum sum;
    addIntegral(edge, kSubpixelOne, kSubpixelOne, sign, sum);
    addIntegral(edge, 0, kSubpixelOne, -sign, sum);
    addIntegral(edge, kSubpixelOne, 0, -sign, sum);
    addIntegral(edge, 0, 0, sign, sum);
    result.whole += sum.whole;
    if (edge.dx != 0) result.parts[2 * i] = {sum.overDx, edge.dx < 0 ? -edge.dx : edge.dx};
    result.parts[2 * i + 1] = {sum.overDy, edge.dy};
  }
  return result;
}

}  // namespace rasterdiff::rasterizer
