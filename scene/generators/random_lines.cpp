#include "scene/generators/random_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff {
namespace {

using Line = std::array<PixelPosition, 2>;

class Source {
 public:
  Source(const RandomLines& options, double extent) : grid_(options.grid), random_(options.seed), extent_(extent) {}

  Line next() {
    Line line = shape();
    for (PixelPosition& p : line) {
      p.x = std::clamp(p.x, 0.0, extent_);
      p.y = std::clamp(p.y, 0.0, extent_);
      p.z = 0.5;
    }
    return line;
  }

 private:
  double snapped(double v) { return snapToGrid(v, grid_); }
  PixelPosition anywhere() { return {snapped(random_.between(0.0, extent_)), snapped(random_.between(0.0, extent_)), 0, 1}; }
  PixelPosition around(const PixelPosition& p, double radius) {
    return {snapped(p.x + random_.between(-radius, radius)), snapped(p.y + random_.between(-radius, radius)), 0, 1};
  }

  /// A centre, or a corner or the middle of an edge of a pixel's diamond.
  PixelPosition onDiamond() {
    constexpr std::array<std::array<double, 2>, 9> kPlaces{
        {{0, 0}, {0.5, 0}, {-0.5, 0}, {0, 0.5}, {0, -0.5}, {0.25, 0.25}, {-0.25, 0.25}, {0.25, -0.25}, {-0.25, -0.25}}};
    const std::array<double, 2>& place = kPlaces[random_.below(kPlaces.size())];
    return {std::floor(random_.between(0.0, extent_)) + 0.5 + place[0],
            std::floor(random_.between(0.0, extent_)) + 0.5 + place[1], 0, 1};
  }

  Line moved(const PixelPosition& from, double dx, double dy) { return {from, {from.x + dx, from.y + dy, 0, 1}}; }
  double step() { return snapped(random_.between(-24.0, 24.0)); }

  Line shape() {
    const uint32_t kind = random_.below(100);
    const PixelPosition a = random_.chance(25) ? onDiamond() : anywhere();
    if (kind < 35) return {a, around(a, 24)};
    if (kind < 50) return {a, around(a, 2)};
    if (kind < 60) return {a, anywhere()};
    if (kind < 70) return {onDiamond(), onDiamond()};
    const double length = step();
    if (kind < 78) return moved(a, length, 0);
    if (kind < 86) return moved(a, 0, length);
    if (kind < 98) return moved(a, length, random_.chance(50) ? length : -length);
    return {a, a};
  }

  Grid grid_;
  Prng random_;
  double extent_;
};

}  // namespace

Scene randomLines(const RandomLines& options) {
  const uint32_t extent = std::bit_floor(std::clamp(options.extent, 16u, kMaxTargetExtent));
  Scene scene;
  scene.name = "random-lines";
  scene.target.width = scene.target.height = extent;
  scene.target.samples = options.samples;
  scene.viewport.width = scene.viewport.height = static_cast<float>(extent);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineRasterizationMode = options.mode;
  scene.state.lineWidth = options.width;
  Source source(options, extent);
  Draw& draw = scene.draws.emplace_back();
  draw.positions.reserve(size_t{options.lines} * 2);
  for (uint32_t i = 0; i < options.lines; ++i) {
    for (const PixelPosition& p : source.next()) draw.positions.push_back(clipFromPixels(scene.viewport, p));
  }
  return scene;
}

}  // namespace rasterdiff
