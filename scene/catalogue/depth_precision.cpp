// How many distances a depth buffer tells apart: near/far ratios up to ten million, either way round.
#include <fmt/format.h>

#include <cmath>

#include "scene/camera/projection.hpp"
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// 24 × 24 level squares at distances from near to far, even steps of their logarithm, smaller to the right.
Result<Scene> squares(double ratio, bool reversed, Convention convention, DepthFormat format) {
  const double near = 0.1, far = near * ratio;
  const Result<glm::dmat4> projection =
      perspective(90, 1, reversed ? far : near, reversed ? near : far, convention);
  if (!projection) return tl::unexpected(projection.error());
  Scene scene = square(96);
  if (convention == Convention::OpenGL) {
    scene.state.negativeOneToOne = true;
    scene.viewport = {0, 96, 96, -96, 0, 1};
  }
  useDepth(scene, CompareOp::ALWAYS, true, reversed ? 0.0f : 1.0f);
  scene.target.depthFormat = format;
  constexpr int kSide = 24;
  Draw& all = scene.draws.emplace_back();
  for (int i = 0; i < kSide * kSide; ++i) {
    const double t = (i + 0.5) / (kSide * kSide), distance = near * std::pow(ratio, t);
    const auto at = [&](int dx, int dy) {
      const double x = (2.0 * (i % kSide + dx) / kSide - 1) * distance;
      const double y = (2.0 * (i / kSide + dy) / kSide - 1) * distance;
      all.positions.push_back(toClip(*projection, x, y, -distance));
    };
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) at(dx, dy);
  }
  return scene;
}

}  // namespace

void addDepthPrecision(Entries& entries) {
  Family family(entries, "depth-precision");
  const std::vector<std::string> rules{"R22", "R38"};
  using enum DepthFormat;
  for (const int decades : {2, 4, 7}) {
    const double ratio = std::pow(10.0, decades);
    for (const DepthFormat format : {D16_UNORM, X8_D24_UNORM_PACK32, D32_SFLOAT}) {
      const char* name = format == D16_UNORM ? "d16" : format == D32_SFLOAT ? "d32f" : "x8d24";
      family.addFallible(fmt::format("{}-1e{}", name, decades), "576 distances: most of the depths lie next to 1", rules,
                         [=] { return squares(ratio, false, Convention::Vulkan, format); });
    }
    family.addFallible(fmt::format("d32f-reversed-1e{}", decades),
                       "576 distances with reversed z: float32 spends its steps where they are needed", rules,
                       [=] { return squares(ratio, true, Convention::Vulkan, D32_SFLOAT); });
    family.addFallible(fmt::format("d32f-opengl-1e{}", decades), "576 distances through depths from -1 to 1", rules,
                       [=] { return squares(ratio, false, Convention::OpenGL, D32_SFLOAT); });
  }
}

}  // namespace rasterdiff::families
