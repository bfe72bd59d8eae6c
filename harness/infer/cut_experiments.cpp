// Experiments about what leaves the view volume: new vertices, folded polygons, facing, outlines, the drawing region.
#include <cmath>
#include <functional>

#include "harness/infer/experiments.hpp"
#include "harness/infer/scene_sketch.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/snap.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Rules;
using Corners = std::array<ClipPosition, 3>;

float someW(Prng& random) {
  return static_cast<float>(random.chance(25) ? 1.0 : std::ldexp(1 + random.unit(), random.between(-2, 3)));
}

// A corner within `reach` times the view volume.
ClipPosition someCorner(Prng& random, double reach) {
  ClipPosition p;
  p.w = someW(random);
  p.x = static_cast<float>(random.between(-reach, reach) * double{p.w});
  p.y = static_cast<float>(random.between(-reach, reach) * double{p.w});
  p.z = static_cast<float>((random.chance(70) ? random.unit() : random.between(-1.0, 2.0)) * double{p.w});
  return p;
}

Corners someTriangle(Prng& random) {
  const double far = std::ldexp(1.0, random.between(0, 12));
  Corners corners;
  for (ClipPosition& p : corners) {
    p = someCorner(random, random.chance(50) ? 1 : far);
    if (random.chance(10)) p.w = -p.w;
  }
  return corners;
}

// Leaves the view volume at both ends, with a corner less than a grid step beside the middle: snapping may move it to the
// other side.
Corners someRibbon(Prng& random, double step) {
  const bool level = random.chance(50);
  const double start = random.between(-0.9, 0.9), end = random.between(-0.9, 0.9);
  const auto corner = [&](double along, double across) {
    const auto a = static_cast<float>(along), b = static_cast<float>(across);
    return level ? ClipPosition{a, b, 0.5F, 1} : ClipPosition{b, a, 0.5F, 1};
  };
  const double side = random.chance(50) ? 1 : -1;
  const double along = random.between(-0.9, 0.9), beside = random.between(-0.75, 0.75) * step;
  return {corner(-2.5 * side, start), corner(2.5 * side, end), corner(along * side, start + (end - start) * (along + 2.5) / 5 + beside)};
}

// The third corner lies a grid step at most beside the middle of the long edge, and near a corner of the view volume more
// often than not.
Corners someSliver(Prng& random, double step) {
  const auto place = [&](double reach) { return random.between(-reach, reach); };
  const bool cornerwise = random.chance(60);
  const double x = cornerwise ? (random.chance(50) ? 1 : -1) : place(1.0), y = cornerwise ? (random.chance(50) ? 1 : -1) : place(1.0);
  const double dx = place(1.5), dy = place(1.5), along = random.unit();
  const std::array<std::array<double, 2>, 3> ndc{{{x - dx, y - dy},
                                                  {x + dx * random.unit(), y + dy * random.unit()},
                                                  {x + dx * (along - 0.5) + place(step), y + dy * (along - 0.5) + place(step)}}};
  Corners corners;
  for (size_t i = 0; i < 3; ++i) {
    const float w = random.chance(50) ? 1.0F : someW(random);
    corners[i] = {static_cast<float>(ndc[i][0]) * w, static_cast<float>(ndc[i][1]) * w, 0.5F * w, w};
  }
  return corners;
}

// The first of some scenes that two contenders draw differently; one rival after the other has its turn.
std::optional<Scene> contested(Prng& random, std::span<const Rules> contenders, const std::function<Scene()>& make) {
  constexpr int kAttempts = 30;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Scene scene = make();
    const Result<Frame> first = rasterizer::render(scene, contenders.front());
    const Result<Frame> other = rasterizer::render(scene, contenders[1 + random.below(contenders.size() - 1)]);
    if (first && other && differ(*first, *other)) return scene;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Scene> clipScene(Prng& random, uint32_t samples, std::span<const Rules> contenders) {
  return contested(random, contenders, [&] {
    SceneSketch sketch("infer/clipping", samples, 64);
    for (int i = 0; i < 60; ++i) sketch.clipTriangle(someTriangle(random));
    return std::move(sketch.scene());
  });
}

std::optional<Scene> sliverScene(Prng& random, uint32_t samples, std::span<const Rules> contenders) {
  constexpr uint32_t kExtent = 64;
  const double step = 2 * std::ldexp(1.0, -rasterizer::gridBits(contenders.front())) / kExtent;  // in NDC
  return contested(random, contenders, [&] {
    SceneSketch sketch("infer/slivers", samples, kExtent);
    constexpr std::array kModes{CullMode::NONE, CullMode::FRONT, CullMode::BACK};
    sketch.scene().state.cullMode = kModes[random.below(kModes.size())];
    for (int i = 0; i < 150; ++i) sketch.clipTriangle(random.chance(50) ? someSliver(random, step) : someRibbon(random, step));
    return std::move(sketch.scene());
  });
}

std::optional<Scene> distanceScene(Prng& random, uint32_t samples, std::span<const Rules> contenders) {
  return contested(random, contenders, [&] {
    SceneSketch sketch("infer/distances", samples, 64);
    Draw& draw = sketch.draw();
    draw.clipDistanceCount = 1 + random.below(2);
    for (int i = 0; i < 24; ++i) {
      Corners corners;
      for (ClipPosition& p : corners) {
        p = someCorner(random, 1);
        p.z = 0.5F * p.w;
        for (uint32_t d = 0; d < draw.clipDistanceCount; ++d) draw.clipDistances.push_back(static_cast<float>(random.between(-1.0, 2.0)));
      }
      sketch.clipTriangle(corners);
    }
    return std::move(sketch.scene());
  });
}

std::optional<Scene> outlineScene(Prng& random, uint32_t samples, bool distances, std::span<const Rules> contenders) {
  return contested(random, contenders, [&] {
    SceneSketch sketch("infer/outlines", samples, 64);
    State& state = sketch.scene().state;
    state.polygonMode = random.chance(60) ? PolygonMode::LINE : PolygonMode::POINT;
    state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR;
    Draw& draw = sketch.draw();
    draw.clipDistanceCount = distances ? 1 : 0;
    for (int i = 0; i < 12; ++i) {
      Corners corners;
      for (ClipPosition& p : corners) {
        p = someCorner(random, 1.7);
        p.z = static_cast<float>((random.chance(80) ? random.unit() : random.between(-0.5, 1.5)) * double{p.w});
        if (draw.clipDistanceCount > 0) draw.clipDistances.push_back(static_cast<float>(random.between(-1.0, 2.0)));
      }
      sketch.clipTriangle(corners);
    }
    return std::move(sketch.scene());
  });
}

std::optional<Scene> regionScene(Prng& random, uint32_t samples, std::span<const Rules> contenders) {
  return contested(random, contenders, [&] {
    SceneSketch sketch("infer/region", samples, 64);
    Scene& scene = sketch.scene();
    if (random.chance(60)) {
      scene.viewport.x = static_cast<float>(random.between(0.0, 12.0));
      scene.viewport.y = static_cast<float>(random.between(0.0, 12.0));
      scene.viewport.width = static_cast<float>(random.between(24.0, 50.0));
      scene.viewport.height = static_cast<float>(random.between(24.0, 50.0));
    }
    if (random.chance(60)) {
      scene.scissor = Rect2D{random.between(0, 20), random.between(0, 20), 8 + random.below(24), 8 + random.below(24)};
    }
    for (int i = 0; i < 12; ++i) {
      Corners corners;
      for (ClipPosition& p : corners) {
        p = someCorner(random, 1);
        p.z = 0.5F * p.w;
      }
      // A side of the viewport, exactly: nothing is clipped.
      if (random.chance(50)) corners[0].x = random.chance(50) ? corners[0].w : -corners[0].w;
      if (random.chance(50)) corners[1].y = random.chance(50) ? corners[1].w : -corners[1].w;
      if (random.chance(50)) corners[2].x = random.chance(50) ? corners[2].w : -corners[2].w;
      sketch.clipTriangle(corners);
    }
    return std::move(sketch.scene());
  });
}

}  // namespace rasterdiff::harness
