#include "scene/generators/random_strips.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff {
namespace {

class Walk {
 public:
  Walk(const RandomStrips& options, double extent)
      : options_(options), random_(options.seed), extent_(extent) {}

  /// A run's first vertex, and how far its vertices are apart.
  PixelPosition begin() {
    radius_ = 3 + 27 * random_.unit();
    return placed(random_.between(0.0, extent_), random_.between(0.0, extent_));
  }

  PixelPosition after(const PixelPosition& p) {
    return placed(p.x + random_.between(-radius_, radius_), p.y + random_.between(-radius_, radius_));
  }

  uint32_t length() { return 1 + random_.below(10); }
  bool chance(uint32_t percent) { return random_.chance(percent); }

 private:
  PixelPosition placed(double x, double y) {
    const auto onGrid = [&](double v) { return std::clamp(snapToGrid(v, options_.grid), 0.0, extent_); };
    PixelPosition p{onGrid(x), onGrid(y), random_.between(0.0625, 0.9375), 1};
    if (options_.perspective) {
      p.w = std::ldexp(options_.grid == Grid::Free ? 1 + random_.unit() : 1.0, random_.between(-3, 3));
    }
    return p;
  }

  RandomStrips options_;
  Prng random_;
  double extent_;
  double radius_ = 0;
};

}  // namespace

Scene randomStrips(const RandomStrips& options) {
  const uint32_t extent = std::bit_floor(std::clamp(options.extent, 16u, kMaxTargetExtent));
  Scene scene;
  scene.name = "random-strips";
  scene.target.width = scene.target.height = extent;
  scene.target.samples = options.samples;
  scene.viewport.width = scene.viewport.height = static_cast<float>(extent);
  scene.state.topology = options.topology;
  scene.state.primitiveRestartEnable = true;
  Walk walk(options, extent);
  Draw& draw = scene.draws.emplace_back();
  std::vector<uint32_t>& indices = draw.indices.emplace();
  const auto add = [&](const PixelPosition& p) {
    indices.push_back(static_cast<uint32_t>(draw.positions.size()));
    draw.positions.push_back(clipFromPixels(scene.viewport, p));
  };
  const bool lines = options.topology == PrimitiveTopology::LINE_STRIP;
  const bool fan = options.topology == PrimitiveTopology::TRIANGLE_FAN;
  for (uint32_t made = 0; made < options.primitives;) {
    if (!indices.empty()) indices.push_back(kRestartIndex);
    const uint32_t first = static_cast<uint32_t>(draw.positions.size()), length = walk.length();
    const PixelPosition start = walk.begin();
    PixelPosition p = start;
    add(p);
    const uint32_t vertices = length + (lines ? 1 : 2);
    for (uint32_t i = 1; i < vertices; ++i) {
      if (i + 1 == vertices && walk.chance(20)) {
        indices.push_back(first);
      } else if (walk.chance(5)) {
        indices.push_back(indices.back());
      } else {
        p = walk.after(fan ? start : p);
        add(p);
      }
    }
    made += length;
  }
  return scene;
}

}  // namespace rasterdiff
