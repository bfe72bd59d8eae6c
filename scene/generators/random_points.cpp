#include "scene/generators/random_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff {

Scene randomPoints(const RandomPoints& options) {
  const uint32_t extent = std::bit_floor(std::clamp(options.extent, 16u, kMaxTargetExtent));
  Scene scene;
  scene.name = "random-points";
  scene.target.width = scene.target.height = extent;
  scene.target.samples = options.samples;
  scene.viewport.width = scene.viewport.height = static_cast<float>(extent);
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  Prng random(options.seed);
  Draw& draw = scene.draws.emplace_back();
  const auto coordinate = [&](bool onHalves) {
    const double v = random.between(0.0, static_cast<double>(extent));
    return snapToGrid(v, onHalves ? Grid::Half : options.grid);
  };
  for (uint32_t i = 0; i < options.points; ++i) {
    const bool onHalves = random.chance(25);
    const double x = coordinate(onHalves), y = coordinate(onHalves);
    draw.positions.push_back(clipFromPixels(scene.viewport, {x, y, 0.5, 1}));
    const double size = random.between(double{options.smallest}, double{options.largest});
    draw.pointSizes.push_back(std::clamp(static_cast<float>(std::round(size * 8) / 8), options.smallest, options.largest));
  }
  return scene;
}

}  // namespace rasterdiff
