// Experiments about points, lines and values.
#include <algorithm>
#include <cmath>

#include "harness/infer/experiments.hpp"
#include "harness/infer/scene_sketch.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/snap.hpp"
#include "scene/generators/random_lines.hpp"
#include "scene/generators/random_points.hpp"
#include "scene/generators/random_triangles.hpp"

namespace rasterdiff::harness {
namespace {

constexpr uint32_t kFigureExtent = 64;

Grid someGrid(Prng& random) {
  constexpr std::array kGrids{Grid::Half, Grid::Sixteenth, Grid::TwoHundredFiftySixth, Grid::Free};
  return kGrids[random.below(kGrids.size())];
}

PixelPosition somewhere(Prng& random, double extent) {
  return {random.between(0.0, extent), random.between(0.0, extent), random.between(0.125, 0.875), 1};
}

// Triangles of `size` pixels.
void scatter(SceneSketch& sketch, Prng& random, int count, double size) {
  const double extent = sketch.scene().target.width;
  for (int i = 0; i < count; ++i) {
    const PixelPosition a = somewhere(random, extent - size);
    const auto near = [&] {
      return PixelPosition{a.x + random.unit() * size, a.y + random.unit() * size, random.between(0.125, 0.875), 1};
    };
    sketch.triangle(a, near(), near());
  }
}

// Moves half of the points so that two of their sides lie within a grid step of a sample, or much nearer: there every rounding
// shows, that of the grid and that of float32. (Where samples are grid points, rounding sides up to the grid may change nothing.)
void moveSidesToSamples(Scene& scene, Prng& random, const rasterizer::Rules& rules) {
  const std::vector<SubpixelPosition> pattern = *rasterizer::samplePattern(scene.target.samples, rules);
  const double step = std::ldexp(1.0, -rasterizer::gridBits(rules));
  Draw& draw = scene.draws.front();
  for (size_t i = 0; i < draw.positions.size(); ++i) {
    if (random.chance(50)) continue;
    const SubpixelPosition offset = pattern[random.below(pattern.size())];
    const double half = (random.chance(50) ? 0.5 : -0.5) * double{draw.pointSizes[i]};
    const auto place = [&](int32_t inPixel) {
      const double beside = std::ldexp(step, random.chance(50) ? 0 : -random.between(8, 20));
      return random.between(8, 56) + inPixel / double{kSubpixelOne} + half + random.between(-1.0, 1.0) * beside;
    };
    const double x = place(offset.x), y = place(offset.y);
    draw.positions[i] = clipFromPixels(scene.viewport, {x, y, 0.5, 1});
  }
}

}  // namespace

Scene pointScene(Prng& random, uint32_t samples, const rasterizer::Rules& rules) {
  const Limits& limits = rules.limits;
  const float largest = std::min(limits.pointSizeMax, 9.0F);
  const float smallest = std::min(largest, std::max(1.0F, limits.pointSizeMin));
  Scene scene = randomPoints({random.bits(), 40, someGrid(random), samples, smallest, largest, kFigureExtent});
  scene.name = "infer/points";
  // Half sides between grid points tell corners that are snapped one by one from a snapped centre. A device that advertises a
  // granularity may still draw what lies between.
  for (float& size : scene.draws.front().pointSizes) {
    if (limits.pointSizeGranularity == 0 || random.chance(50)) size = std::min(size + static_cast<float>(random.below(128)) / 1024, largest);
    if (random.chance(10)) size = std::max(limits.pointSizeMin, size / 16);
  }
  moveSidesToSamples(scene, random, rules);
  return scene;
}

Scene outerPointScene(Prng& random, uint32_t samples, const rasterizer::Rules& rules) {
  Scene scene = pointScene(random, samples, rules);
  scene.name = "infer/outer-points";
  Draw& draw = scene.draws.front();
  const float largest = std::min(rules.limits.pointSizeMax, 9.0F);
  for (size_t i = 0; i < draw.positions.size(); ++i) {
    ClipPosition& p = draw.positions[i];
    const double beyond = random.chance(50) ? std::ldexp(1.0, -random.between(3, 22)) : random.between(0.02, 0.2);
    float& side = random.chance(50) ? p.x : p.y;
    if (random.chance(70)) side = static_cast<float>((random.chance(50) ? 1 : -1) * (1 + beyond) * double{p.w});
    if (random.chance(10)) p.z = static_cast<float>((random.chance(50) ? -beyond : 1 + beyond) * double{p.w});
    if (!draw.pointSizes.empty() && largest > 1) draw.pointSizes[i] = largest;
  }
  return scene;
}

std::optional<Scene> diamondScene(Prng& random, uint32_t samples, const Limits& limits) {
  if (!limits.bresenhamLines) return std::nullopt;
  SceneSketch sketch("infer/diamonds", samples);
  Scene& scene = sketch.scene();
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
  // On the diamond |x| + |y| = ½ around the centre: corners, and points of its edges.
  const auto onDiamond = [&](double pixel, double other) {
    constexpr std::array kParts{0.0, 0.0, 0.25, 0.375, 0.5, 0.5};
    const double part = kParts[random.below(kParts.size())];
    const double x = random.chance(50) ? part : -part, y = random.chance(50) ? 0.5 - part : part - 0.5;
    return PixelPosition{pixel + 0.5 + x, other + 0.5 + y, 0.5, 1};
  };
  for (int i = 0; i < 40; ++i) {
    const int32_t x = random.between(6, 25), y = random.between(6, 25);
    const PixelPosition from = onDiamond(x, y);
    PixelPosition to = onDiamond(x + random.between(-5, 5), y + random.between(-5, 5));
    if (random.chance(20)) to.y = from.y;
    if (random.chance(20)) to.x = from.x;
    for (const PixelPosition& p : {from, to}) sketch.draw().positions.push_back(clipFromPixels(scene.viewport, p));
  }
  return std::move(scene);
}

std::optional<Scene> lineScene(Prng& random, uint32_t samples, bool bresenham, const Limits& limits) {
  if (!(bresenham ? limits.bresenhamLines : limits.rectangularLines)) return std::nullopt;
  const auto mode = bresenham ? LineRasterizationMode::BRESENHAM : LineRasterizationMode::RECTANGULAR;
  const bool wide = limits.lineWidthMax >= 4 && random.chance(50);
  Scene scene = randomLines({random.bits(), 30, someGrid(random), samples, mode, wide ? 3.0F : 1.0F, kFigureExtent});
  scene.name = "infer/lines";
  return scene;
}

Scene biasScene(Prng& random, DepthFormat format) {
  SceneSketch sketch("infer/depth-bias", 1);
  Scene& scene = sketch.scene();
  scene.target.depthFormat = format;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  scene.state.depthBiasEnable = true;
  const bool constant = random.chance(60);
  const double sign = random.chance(50) ? 1 : -1;
  scene.state.depthBiasConstantFactor = constant ? static_cast<float>(sign * std::ldexp(1 + random.unit(), random.between(5, 14))) : 0.0F;
  scene.state.depthBiasSlopeFactor = constant ? 0.0F : static_cast<float>(sign * random.between(1.0, 3.0));
  scatter(sketch, random, 12, 14);
  return std::move(scene);
}

Scene placeScene(Prng& random, uint32_t samples, Interpolation interpolation, bool perspective) {
  SceneSketch sketch("infer/places", samples);
  scatter(sketch, random, 24, 7);
  Varying place{.name = "place", .interpolation = interpolation, .components = 2, .values = {}};
  const auto extent = static_cast<float>(kSketchExtent);
  for (ClipPosition& p : sketch.draw().positions) {
    place.values.push_back((p.x + 1) * extent / 2);
    place.values.push_back((p.y + 1) * extent / 2);
    const float w = perspective ? static_cast<float>(1 + random.below(4)) : 1;
    p = {p.x * w, p.y * w, p.z * w, w};
  }
  sketch.draw().varyings.push_back(std::move(place));
  return std::move(sketch.scene());
}

Scene steepScene(Prng& random) {
  SceneSketch sketch("infer/steep", 1);
  scatter(sketch, random, 24, 9);
  Varying steep{.name = "steep", .interpolation = Interpolation::noperspective, .components = 1, .values = {}};
  for (size_t i = 0; i < sketch.draw().positions.size(); ++i) steep.values.push_back(static_cast<float>(random.between(-8.0, 8.0)));
  sketch.draw().varyings.push_back(std::move(steep));
  return std::move(sketch.scene());
}

Scene steepCutScene(Prng& random) {
  SceneSketch sketch("infer/steep-cut", 1);
  Varying steep{.name = "steep", .interpolation = Interpolation::smooth, .components = 1, .values = {}};
  for (int i = 0; i < 24; ++i) {
    std::array<ClipPosition, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const double w = random.between(0.5, 4.0), reach = k == 0 ? 3 : 1;
      corners[k] = {static_cast<float>(random.between(-reach, reach) * w), static_cast<float>(random.between(-reach, reach) * w),
                    static_cast<float>(random.between(0.125, 0.875) * w), static_cast<float>(w)};
      steep.values.push_back(static_cast<float>(random.between(-8.0, 8.0)));
    }
    if (random.chance(50)) {
      corners[0].w = -corners[0].w;
      corners[0].z = -corners[0].z;
    }
    sketch.clipTriangle(corners);
  }
  sketch.draw().varyings.push_back(std::move(steep));
  return std::move(sketch.scene());
}

Scene resolveScene(Prng& random, uint32_t samples) {
  SceneSketch sketch("infer/resolve", samples);
  sketch.scene().target.resolve = true;
  scatter(sketch, random, 60, 9);
  Varying constant{.name = "constant", .interpolation = Interpolation::flat, .components = 4, .values = {}};
  for (size_t i = 0; i < sketch.draw().positions.size() * 4; ++i) {
    constant.values.push_back(static_cast<float>(std::ldexp(random.between(-1.0, 1.0), random.between(0, 4))));
  }
  sketch.draw().varyings.push_back(std::move(constant));
  return std::move(sketch.scene());
}

Scene valueScene(Prng& random) {
  Scene scene = randomTriangles({random.bits(), 40, Grid::Free, 1, true, 128, true});
  scene.name = "infer/values";
  return scene;
}

}  // namespace rasterdiff::harness
