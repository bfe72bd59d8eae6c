// Experiments about triangles' edges: ties, snapping, viewport arithmetic.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "harness/infer/experiments.hpp"
#include "harness/infer/scene_sketch.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/snap.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choices;
using rasterizer::Rules;

struct Point {
  double x = 0, y = 0;  ///< pixels
};

// A sample of some pixel of the inner half of the target.
Point someSample(Prng& random, uint32_t samples, const Rules& rules) {
  const std::vector<SubpixelPosition> pattern = *rasterizer::samplePattern(samples, rules);
  const SubpixelPosition offset = pattern[random.below(samples)];
  const auto pixel = [&] { return random.between(int32_t{kSketchExtent} / 4, int32_t{kSketchExtent} * 3 / 4); };
  return {pixel() + offset.x / double{kSubpixelOne}, pixel() + offset.y / double{kSubpixelOne}};
}

PixelPosition at(double x, double y) { return {x, y, 0.5, 1}; }

double onGrid(double value, double steps) { return std::floor(value * steps) / steps; }

// The third corner of a triangle over the edge from a to b: to either side of it, and in either order.
void addOver(SceneSketch& sketch, Prng& random, Point a, Point b, double steps) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy) + 0.25;
  const double side = (random.chance(50) ? 1.0 : -1.0) * random.between(3.0, 9.0);
  const Point c{onGrid((a.x + b.x) / 2 - dy / length * side, steps), onGrid((a.y + b.y) / 2 + dx / length * side, steps)};
  if (random.chance(50)) std::swap(a, b);
  sketch.triangle(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y));
}

}  // namespace

std::vector<uint32_t> sampleCounts(const Limits& limits) {
  std::vector<uint32_t> counts;
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    if ((limits.framebufferSampleCounts & samples) != 0) counts.push_back(samples);
  }
  return counts;
}

Scene tieScene(Prng& random, uint32_t samples, const Rules& rules) {
  constexpr double kSteps = 16;
  SceneSketch sketch("infer/ties", samples);
  sketch.widenViewport();  // nothing is clipped
  for (int i = 0; i < 24; ++i) {
    const Point s = someSample(random, samples, rules);
    Point d{random.between(-96, 96) / kSteps, random.between(-96, 96) / kSteps};
    const uint32_t kind = random.below(4);
    if (kind == 0) d.x = 0;
    if (kind == 1) d.y = 0;
    if (kind == 2) d.y = random.chance(50) ? d.x : -d.x;
    // An edge through the sample, and now and then a corner on it.
    const double far = random.chance(20) ? 0 : 1;
    addOver(sketch, random, {s.x - d.x, s.y - d.y}, {s.x + far * d.x, s.y + far * d.y}, kSteps);
  }
  return std::move(sketch.scene());
}

Scene snapScene(Prng& random, uint32_t samples, bool halves, const Rules& rules) {
  SceneSketch sketch("infer/snapping", samples);
  sketch.widenViewport();
  const auto extent = int32_t{kSketchExtent};
  for (int i = 0; i < 24; ++i) {
    const Point s = someSample(random, samples, rules);
    const double steps = std::ldexp(1.0, random.between(4, 8));
    const Point grid{random.between(-extent, 2 * extent) + random.below(static_cast<uint64_t>(steps)) / steps,
                     random.between(-extent, 2 * extent) + random.below(static_cast<uint64_t>(steps)) / steps};
    const auto moved = [&](double coordinate) {
      if (random.chance(30)) return coordinate;
      return coordinate + (halves ? 0.5 : (1 + random.below(31)) / 32.0) / steps;
    };
    // The other end mirrors the grid point, or the next one, at the sample.
    const double next = random.below(2) / steps;
    const Point other{2 * s.x - grid.x - next, 2 * s.y - grid.y - next};
    if (std::fabs(other.x - extent / 2.0) > extent || std::fabs(other.y - extent / 2.0) > extent) continue;
    addOver(sketch, random, {moved(grid.x), moved(grid.y)}, other, 16);
  }
  if (sketch.draw().positions.empty()) sketch.triangle(at(1, 1), at(9, 1), at(1, 9));
  return std::move(sketch.scene());
}

namespace {

// Holds the whole target, so that nothing is cut at its sides.
Viewport someViewport(Prng& random) {
  Viewport viewport;
  if (random.chance(40)) {
    // No offset: places keep all bits of their own until half a pixel is subtracted.
    viewport.x = viewport.y = -2 * static_cast<float>(kSketchExtent);
    viewport.width = viewport.height = 4 * static_cast<float>(kSketchExtent);
    return viewport;
  }
  const auto size = [&] { return static_cast<float>(random.chance(30) ? 64 : random.between(40.0, 150.0)); };
  const auto origin = [&] {
    if (random.chance(30)) return 0.0F;
    return static_cast<float>(random.chance(50) ? random.between(-64, 0) : random.between(-64.0, 0.0));
  };
  viewport.x = origin();
  viewport.y = origin();
  viewport.width = size() - std::min(0.0F, viewport.x);
  viewport.height = size() - std::min(0.0F, viewport.y);
  if (random.chance(25)) {
    viewport.y += viewport.height;
    viewport.height = -viewport.height;
  }
  return viewport;
}

float someW(Prng& random) {
  return static_cast<float>(random.chance(25) ? 1.0 : std::ldexp(1 + random.unit(), random.between(-2, 3)));
}

// One coordinate of a vertex through one axis of the viewport.
struct Mapping {
  uint32_t samples;
  const rasterizer::ViewportAxis& axis;

  [[nodiscard]] float clip(double pixels, float w) const {
    return static_cast<float>((pixels - axis.offset()) / axis.scale * double{w});
  }
  [[nodiscard]] int32_t snapped(const Rules& rules, float clip, float w) const {
    return rasterizer::snapUnder(rules, samples, clip, w, axis);
  }
  // A clip coordinate that `rules` snap to a place (1/256 pixel) of the grid.
  [[nodiscard]] std::optional<float> landingOn(int32_t place, float w, const Rules& rules) const {
    const double step = std::ldexp(1.0, -rasterizer::gridBits(rules));
    for (const double off : {0.0, 0.4, -0.4}) {
      const float candidate = clip(place / double{kSubpixelOne} + off * step, w);
      if (std::fabs(candidate) <= w && snapped(rules, candidate, w) == place) return candidate;
    }
    return std::nullopt;
  }
  // A clip coordinate near `pixels` that two rules snap to different places, if there is one within a few ulps.
  [[nodiscard]] std::optional<float> contested(double pixels, float w, const Rules& one, const Rules& other) const {
    constexpr int kUlps = 12;
    float candidate = clip(pixels, w);
    for (int i = 0; i < kUlps; ++i) candidate = std::nextafter(candidate, -std::numeric_limits<float>::infinity());
    for (int i = -kUlps; i <= kUlps; ++i) {
      if (std::fabs(candidate) <= w && snapped(one, candidate, w) != snapped(other, candidate, w)) return candidate;
      candidate = std::nextafter(candidate, std::numeric_limits<float>::infinity());
    }
    return std::nullopt;
  }
};

// A contender that has the first one's grid and rounding, if there is one, and often its arithmetic, too: those are the hard
// ones to tell apart.
const Rules& someRival(Prng& random, std::span<const Rules> contenders) {
  const Choices& first = contenders.front().choices;
  const bool nearest = random.chance(50);
  std::vector<const Rules*> near;
  for (const Rules& rules : contenders.subspan(1)) {
    const Choices& choices = rules.choices;
    const bool same = choices.subPixelBits == first.subPixelBits && choices.snapRounding == first.snapRounding;
    if (same && (!nearest || choices.viewportArithmetic == first.viewportArithmetic)) near.push_back(&rules);
  }
  if (near.empty() || random.chance(10)) return contenders[random.below(contenders.size())];
  return *near[random.below(near.size())];
}

// On a grid point, or a quarter or half of a step beside it. Often just above a negative power of two or around 0, where
// half a pixel costs a float32 bits when it is subtracted.
double somePlace(Prng& random, double step) {
  const double fraction = std::floor(random.unit() / step) * step + random.below(4) * 0.25 * step;
  const uint32_t zone = random.below(8);
  if (zone < 4) return fraction / 2 - std::ldexp(1.0, random.between(0, 5));
  if (zone < 6) return fraction - 0.5;
  return random.between(-48, 64) + fraction;
}

// A triangle with one vertex that `one` and `rival` snap to different places, such that a sample is in the middle of the
// edge that starts there, for one of the two. Nothing if no such vertex was found.
std::optional<std::array<ClipPosition, 3>> contestedTriangle(Prng& random, uint32_t samples, const Rules& one,
                                                             const Rules& rival, const rasterizer::ViewportTransform& viewport) {
  const bool alongX = random.chance(50);
  const Mapping mapping{samples, alongX ? viewport.x : viewport.y}, across{samples, alongX ? viewport.y : viewport.x};
  const Point sample = someSample(random, samples, one);
  const auto subpixels = [](double pixels) { return static_cast<int32_t>(std::lround(pixels * kSubpixelOne)); };
  const int32_t s = subpixels(alongX ? sample.x : sample.y), t = subpixels(alongX ? sample.y : sample.x);
  const float wa = someW(random), wb = someW(random), wc = someW(random);
  const double step = std::ldexp(1.0, -rasterizer::gridBits(one));
  const std::optional<float> a = mapping.contested(somePlace(random, step), wa, one, rival);
  if (!a) return std::nullopt;
  const int32_t start = mapping.snapped(random.chance(50) ? one : rival, *a, wa);
  const int32_t rise = random.between(-6, 6) * kSubpixelOne;
  const std::optional<float> b = mapping.landingOn(2 * s - start, wb, one);
  const std::optional<float> aAcross = across.landingOn(t - rise, wa, one), bAcross = across.landingOn(t + rise, wb, one);
  const int32_t aside = random.between(-8, 8) * kSubpixelOne, away = random.between(-8, 8) * kSubpixelOne;
  // Well away from the edge: whether a sliver is drawn at all is another question.
  const int64_t run = int64_t{s} - start;
  if (std::llabs(run * away - int64_t{rise} * aside) < 4 * std::max<int64_t>(std::llabs(run), std::llabs(rise)) * kSubpixelOne) return std::nullopt;
  const std::optional<float> c = mapping.landingOn(s + aside, wc, one);
  const std::optional<float> cAcross = across.landingOn(t + away, wc, one);
  if (!b || !aAcross || !bAcross || !c || !cAcross) return std::nullopt;
  const auto vertex = [&](float along, float other, float w) {
    return alongX ? ClipPosition{along, other, w / 2, w} : ClipPosition{other, along, w / 2, w};
  };
  return std::array{vertex(*a, *aAcross, wa), vertex(*b, *bAcross, wb), vertex(*c, *cAcross, wc)};
}

}  // namespace

std::optional<Scene> viewportScene(Prng& random, uint32_t samples, std::span<const Rules> contenders) {
  constexpr int kAttempts = 6000, kHopeless = 2000, kTriangles = 16;
  SceneSketch sketch("infer/viewport", samples);
  sketch.scene().viewport = someViewport(random);
  const rasterizer::ViewportTransform transform = rasterizer::viewportTransform(sketch.scene().viewport, false, 0);
  const Rules& rival = someRival(random, contenders);  // one a scene, so that those who are hard to tell have their turn
  int made = 0;
  for (int i = 0; i < kAttempts && made < kTriangles; ++i) {
    if (made == 0 && i == kHopeless) return std::nullopt;
    const auto corners = contestedTriangle(random, samples, contenders.front(), rival, transform);
    if (!corners) continue;
    sketch.clipTriangle(*corners);
    ++made;
  }
  return std::move(sketch.scene());
}

}  // namespace rasterdiff::harness
