// Pictures that alias: drawn n times as large and averaged, they show how much.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scene/camera/projection.hpp"
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// A quad of two triangles with one value.
void quad(Draw& d, const std::array<ClipPosition, 4>& corners, float value) {
  for (const size_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
    d.positions.push_back(corners[i]);
    d.varyings[0].values.push_back(value);
  }
}

Scene withValue(uint32_t extent, uint32_t n) {
  Scene scene = square(extent);
  scene.target.supersample = n;
  scene.draws.emplace_back().varyings = {{.name = "value", .interpolation = Interpolation::flat, .components = 1}};
  return scene;
}

/// A checkerboard of 24 × 48 cells on the ground, to far away: cells become smaller than pixels.
Result<Scene> checkerboard(uint32_t n) {
  const Result<glm::dmat4> projection = perspective(60, 1, 0.5, 200, Convention::Vulkan);
  if (!projection) return tl::unexpected(projection.error());
  Scene scene = withValue(64, n);
  for (int z = 0; z < 48; ++z) {
    for (int x = -12; x < 12; ++x) {
      const auto at = [&](int dx, int dz) { return toClip(*projection, x + dx, -1, -1.5 - (z + dz)); };
      quad(scene.draws[0], {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, (x + z) % 2 == 0 ? 1.0f : 0.0f);
    }
  }
  return scene;
}

/// Vertical stripes whose number grows with the square of x, as in a zone plate: 1 to 0 in ever shorter turns.
Scene stripes(uint32_t n) {
  Scene scene = withValue(64, n);
  constexpr int kStripes = 72;
  for (int k = 0; k < kStripes; ++k) {
    const auto at = [&](int i, float y) {
      return ClipPosition{static_cast<float>(2 * std::sqrt(static_cast<double>(i) / kStripes) - 1), y, 0.5f, 1};
    };
    quad(scene.draws[0], {at(k, -1), at(k + 1, -1), at(k + 1, 1), at(k, 1)}, k % 2 == 0 ? 1.0f : 0.0f);
  }
  return scene;
}

/// Rings around a corner, radii as the square root of their number; octagonal, so that no sine differs by machine.
Scene rings(uint32_t n) {
  Scene scene = withValue(64, n);
  constexpr int kRings = 48;
  constexpr std::array<std::array<double, 2>, 5> kRim{{{1, 0}, {0.9375, 0.375}, {0.7109375, 0.703125}, {0.375, 0.9375}, {0, 1}}};
  for (int k = 0; k < kRings; ++k) {
    const double inner = 2 * std::sqrt(static_cast<double>(k) / kRings), outer = 2 * std::sqrt((k + 1.0) / kRings);
    const auto at = [&](size_t i, double radius) {
      return ClipPosition{static_cast<float>(kRim[i][0] * radius - 1), static_cast<float>(kRim[i][1] * radius - 1), 0.5f, 1};
    };
    for (size_t i = 0; i < 4; ++i) {
      quad(scene.draws[0], {at(i, inner), at(i, outer), at(i + 1, outer), at(i + 1, inner)}, k % 2 == 0 ? 1.0f : 0.0f);
    }
  }
  return scene;
}

}  // namespace

void addSupersample(Entries& entries) {
  Family family(entries, "supersample");
  const std::vector<std::string> rules{"R11", "R14", "R15"};
  for (const uint32_t n : {1u, 2u, 4u, 8u}) {
    family.addFallible(fmt::format("checkerboard-{0}", n), "a far checkerboard: moire at the horizon", rules,
                       [n] { return checkerboard(n); });
    family.add(fmt::format("stripes-{}", n), "ever thinner stripes: false coarse ones appear", rules,
               [n] { return stripes(n); });
    family.add(fmt::format("zone-plate-{}", n), "ever thinner rings: false centres appear", rules, [n] { return rings(n); });
  }
  for (const uint32_t n : {16u, 32u}) {
    family.add(fmt::format("zone-plate-{}", n), "ever thinner rings: false centres appear", rules, [n] { return rings(n); });
  }
  family.add("edge-3", "a slanted edge three times as large: at most ten shades", {"R14"}, [] {
    Scene scene = square(32);
    scene.target.supersample = 3;
    draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
    return scene;
  });
  family.add("points-2", "point sizes grow with the picture", {"R25", "R34"}, [] {
    Scene scene = square(32);
    scene.target.supersample = 2;
    scene.state.polygonMode = PolygonMode::POINT;
    scene.state.pointSize = 3;
    draw(scene, {{5.25, 5.5}, {24.75, 9}, {11, 25.125}});
    return scene;
  });
}

}  // namespace rasterdiff::families
