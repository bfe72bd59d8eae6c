#include "harness/bench/load.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "rasterizer/geometry.hpp"
#include "rasterizer/kernels/integer_spans.hpp"
#include "rasterizer/rules.hpp"
#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterizer::SnappedTriangle;

double area(const SnappedTriangle& t) {  // pixels
  const auto& [a, b, c] = t.v;
  const double abx = double{1} * b.x - a.x, aby = double{1} * b.y - a.y, acx = double{1} * c.x - a.x, acy = double{1} * c.y - a.y;
  return std::fabs(abx * acy - aby * acx) / 2 / (kSubpixelOne * kSubpixelOne);
}

bool inside(const Load& load, const SnappedTriangle& t) {
  return std::ranges::all_of(t.v, [&](SubpixelPosition v) {
    return v.x >= 0 && v.y >= 0 && v.x <= int64_t{load.width} * kSubpixelOne && v.y <= int64_t{load.height} * kSubpixelOne;
  });
}

/// Row by row, inside the target.
double counted(const Load& load, const SnappedTriangle& t) {
  const auto [low, high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  const int64_t first = std::max(0, low >> kSubpixelBits), last = std::min<int64_t>(load.height - 1, high >> kSubpixelBits);
  double sum = 0;
  for (const SampleLocation at : standardSampleLocations(load.samples)) {
    for (int64_t y = first; y <= last; ++y) {
      const rasterizer::IntegerSpan span = rasterizer::integerSpan(t, y, at, load.width);
      sum += static_cast<double>(std::max<int64_t>(0, span.end - span.begin));
    }
  }
  return sum;
}

bool testsFragments(const Scene& scene) {
  const auto masks = ~uint32_t{0} >> (32 - scene.target.samples);
  return scene.scissor || scene.state.depthTestEnable || scene.state.alphaToCoverageEnable ||
         (scene.state.sampleMask & masks) != masks || scene.state.shaderSampleMask != ShaderSampleMask::NONE ||
         std::ranges::any_of(scene.draws, [](const Draw& d) { return d.clipDistanceCount + d.cullDistanceCount > 0; });
}

}  // namespace

Load loadOf(rasterdiff::bench::Workload workload, uint32_t samples) {
  return {std::move(workload.name), std::move(workload.what), {}, workload.width, workload.height, samples,
          std::move(workload.triangles), std::nullopt};
}

Load loadOf(const Scene& scene) {
  Load load{scene.name, {}, {}, scene.target.width, scene.target.height, scene.target.samples, {}, scene};
  rasterizer::RuleCounts counts;
  const Result<rasterizer::Rules> rules = rasterizer::Rules::profile("reference", Limits{});
  bool figures = false;
  rasterizer::forEachPrimitive(scene, *rules, counts, [&](const rasterizer::Primitive& primitive) {
    figures = figures || !primitive.figures.empty();
    for (const rasterizer::SetupTriangle& piece : primitive.pieces) {
      if (piece.culled) continue;
      SnappedTriangle t;
      for (size_t i = 0; i < 3; ++i) t.v[i] = primitive.polygon[piece.corner[i]].snapped;
      load.triangles.push_back(t);
    }
  });
  load.what = "triangles after clipping";
  if (figures) load.note = "lines and points are drawn by the reference and the driver only";
  if (testsFragments(scene)) {
    load.note += std::string(load.note.empty() ? "" : "; ") +
                 "kernels draw every triangle whole: scissor, masks, distances and depth tests are left to the reference and the driver";
  }
  return load;
}

std::vector<Task> tasksOf(const Load& load) {
  if (!load.scene) return {Task::Coverage, Task::Depth, Task::Varyings};
  const SceneNeeds needs = needsOf(*load.scene);
  if (needs.varyings + needs.builtIns > 0) return {Task::Varyings};
  return {needs.depth ? Task::Depth : Task::Coverage};
}

Attributes attributesOf(size_t triangles) {
  Attributes all;
  Prng prng(0x5EED);
  for (size_t i = 0; i < 3 * triangles; ++i) {
    all.depth.push_back(static_cast<float>(prng.bits() >> 40) * 0x1p-24F);
    all.reciprocalW.push_back(1.F / static_cast<float>(1U << prng.below(3)));
    for (uint32_t c = 0; c < kComponents; ++c) all.values.push_back(static_cast<float>(prng.unit()));
  }
  return all;
}

Scene sceneOf(const Load& load, Task task, size_t triangles) {
  if (load.scene) return *load.scene;
  Scene scene;
  scene.name = load.name;
  scene.target.width = load.width, scene.target.height = load.height, scene.target.samples = load.samples;
  // A viewport of a power of two, larger than the target: positions in clip space are exact, and so are their snapped ones.
  scene.viewport.width = static_cast<float>(std::bit_ceil(load.width)), scene.viewport.height = static_cast<float>(std::bit_ceil(load.height));
  triangles = std::min(triangles, load.triangles.size());
  const bool values = task != Task::Coverage;
  Attributes attributes = attributesOf(values ? triangles : 0);
  if (values) {
    scene.target.depthFormat = DepthFormat::D32_SFLOAT;
    scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  }
  Draw draw;
  draw.positions.reserve(3 * triangles);
  for (size_t i = 0; i < 3 * triangles; ++i) {
    const SubpixelPosition v = load.triangles[i / 3].v[i % 3];
    PixelPosition p{static_cast<double>(v.x) / kSubpixelOne, static_cast<double>(v.y) / kSubpixelOne, 0.5, 1};
    if (values) p.z = attributes.depth[i], p.w = 1.0 / attributes.reciprocalW[i];
    draw.positions.push_back(clipFromPixels(scene.viewport, p));
  }
  if (task == Task::Varyings) {
    draw.varyings.push_back({"color", Interpolation::smooth, kComponents, std::move(attributes.values)});
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

double coveredSamples(const Load& load, size_t triangles) {
  double sum = 0;
  for (size_t i = 0; i < std::min(triangles, load.triangles.size()); ++i) {
    const SnappedTriangle& t = load.triangles[i];
    sum += inside(load, t) ? area(t) * load.samples : counted(load, t);
  }
  return sum;
}

}  // namespace rasterdiff::harness::bench
