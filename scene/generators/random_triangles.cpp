#include "scene/generators/random_triangles.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "scene/camera/screen.hpp"
#include "scene/generators/grid.hpp"
#include "scene/generators/prng.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff {
namespace {

using Triangle = std::array<PixelPosition, 3>;

class Source {
 public:
  explicit Source(const RandomTriangles& options) : options_(options), random_(options.seed), extent_(options.extent) {}

  Triangle next() {
    Triangle triangle = shape();
    const bool mayLeave = options_.perspective || options_.grid == Grid::Free;
    if (mayLeave && random_.chance(5)) {
      moveAcrossBorder(triangle);
    } else {
      for (PixelPosition& p : triangle) {
        p.x = std::clamp(p.x, 0.0, extent_);
        p.y = std::clamp(p.y, 0.0, extent_);
      }
    }
    for (PixelPosition& p : triangle) p.z = random_.between(0.0625, 0.9375);
    if (options_.perspective) giveDepth(triangle);
    return triangle;
  }

  float value() { return static_cast<float>(random_.between(-8.0, 8.0)); }

 private:
  double snapped(double v) { return snapToGrid(v, options_.grid); }
  PixelPosition around(double x, double y, double radius) {
    return {snapped(x + random_.between(-radius, radius)), snapped(y + random_.between(-radius, radius)), 0, 1};
  }
  PixelPosition anywhere() { return around(extent_ / 2, extent_ / 2, extent_ / 2); }

  Triangle cluster(double smallest, double largest) {
    const double u = random_.unit();  // squared: more small ones; no library function that differs between machines
    const double radius = (smallest + (largest - smallest) * u * u) / 2;
    const double x = random_.between(0.0, extent_), y = random_.between(0.0, extent_);
    return {around(x, y, radius), around(x, y, radius), around(x, y, radius)};
  }

  Triangle sliver() {
    const PixelPosition a = anywhere();
    const PixelPosition b = around(a.x, a.y, 60);
    const double t = random_.unit();
    return {a, b, around(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.5)};
  }

  /// Right-angled, on samples where the grid has them, with a horizontal, a vertical and a diagonal or steep edge.
  Triangle tieRich() {
    const std::span<const SampleLocation> samples = standardSampleLocations(options_.samples);
    const bool onSample = options_.grid != Grid::Half || options_.samples == 1;
    const SampleLocation s = samples.empty() ? SampleLocation{8, 8} : samples[random_.below(samples.size())];
    const auto coordinate = [&](uint8_t sixteenths) {
      return std::floor(random_.between(0.0, extent_)) + (onSample ? sixteenths / 16.0 : random_.below(2) / 2.0);
    };
    const PixelPosition corner{coordinate(s.x), coordinate(s.y), 0, 1};
    const double dx = random_.between(-24, 24), dy = random_.chance(50) ? dx : random_.between(-24, 24);
    Triangle triangle{corner, corner, corner};
    triangle[1].x += dx;
    triangle[2].y += random_.chance(50) ? dy : -dy;
    if (random_.chance(50)) std::swap(triangle[1], triangle[2]);
    return triangle;
  }

  Triangle shape() {
    const uint32_t kind = random_.below(100);
    if (kind < 50) return cluster(2, 12);
    if (kind < 70) return cluster(12, 40);
    if (kind < 78) return cluster(0.25, 1.5);
    if (kind < 86) return sliver();
    if (kind < 88) return {anywhere(), anywhere(), anywhere()};
    return tieRich();
  }

  /// Its first vertex goes to a border, so that the others lie on both sides of it.
  void moveAcrossBorder(Triangle& triangle) {
    const double border = random_.chance(50) ? 0.0 : extent_;
    const double along = snapped(random_.between(0.0, extent_));
    const bool vertical = random_.chance(50);
    const double dx = (vertical ? border : along) - triangle[0].x, dy = (vertical ? along : border) - triangle[0].y;
    for (PixelPosition& p : triangle) {
      p.x += dx;
      p.y += dy;
    }
  }

  void giveDepth(Triangle& triangle) {
    const bool anyW = options_.grid == Grid::Free;
    for (PixelPosition& p : triangle) {
      p.w = std::ldexp(anyW ? 1 + random_.unit() : 1.0, random_.between(-3, 3));
    }
    if (!anyW || !random_.chance(1)) return;
    PixelPosition& p = triangle[random_.below(3)];
    if (random_.chance(50)) {
      p.z = -random_.between(0.0, 2.0);
    } else {
      p.w = -p.w;
    }
  }

  RandomTriangles options_;
  Prng random_;
  double extent_;
};

void addValues(Scene& scene, Source& source) {
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = true;
  scene.state.depthWriteEnable = true;
  Draw& draw = scene.draws.front();
  draw.varyings = {{.name = "color", .interpolation = Interpolation::smooth, .components = 4},
                   {.name = "screen", .interpolation = Interpolation::noperspective, .components = 2},
                   {.name = "id", .interpolation = Interpolation::flat, .components = 1}};
  for (Varying& varying : draw.varyings) {
    varying.values.resize(draw.positions.size() * varying.components);
    for (float& value : varying.values) value = source.value();
  }
}

}  // namespace

Scene randomTriangles(const RandomTriangles& asked) {
  RandomTriangles options = asked;
  options.extent = std::bit_floor(std::clamp(asked.extent, 16u, kMaxTargetExtent));
  Scene scene;
  scene.name = "random";
  scene.target.width = scene.target.height = options.extent;
  scene.target.samples = options.samples;
  scene.viewport.width = scene.viewport.height = static_cast<float>(options.extent);
  Source source(options);
  Draw& draw = scene.draws.emplace_back();
  draw.positions.reserve(size_t{options.triangles} * 3);
  for (uint32_t i = 0; i < options.triangles; ++i) {
    for (const PixelPosition& p : source.next()) draw.positions.push_back(clipFromPixels(scene.viewport, p));
  }
  if (options.values) addValues(scene, source);
  return scene;
}

}  // namespace rasterdiff
