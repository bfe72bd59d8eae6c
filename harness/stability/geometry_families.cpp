// Families where it is hard to say which samples are covered.
#include <cmath>
#include <numbers>

#include "harness/stability/families.hpp"
#include "harness/stability/hard_scene.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::harness::stability {
namespace {

constexpr double kSliverLength = 1018;

/// A triangle `kSliverLength` long and that divided by `aspect` thick, its first corner at (2.5, y).
void addSliver(Scene& scene, double y, double aspect) {
  addTriangle(scene, {{{2.5, y, 0}, {2.5 + kSliverLength, y + 9.3, 1}, {511.2, y + 4.65 + kSliverLength / aspect, 0.5F}}});
}

Scene sliver(double aspect) {
  Scene scene = hardTarget(1024, 64);
  addSliver(scene, 20.3, aspect);
  return scene;
}

Scene movingSlivers(double aspect) {
  Scene scene = hardTarget(1024, 256);
  for (int k = 0; k < 16; ++k) addSliver(scene, 6.5 + 15 * k + k / 16.0, aspect);
  return scene;
}

Scene subpixel(double dial) {
  Scene scene = hardTarget(64, 64);
  Prng random(11);
  for (int k = 0; k < 1024; ++k) {
    const double x = random.between(2.0, 60.0), y = random.between(2.0, 60.0);
    const auto corner = [&](float value) {
      return HardVertex{x + random.between(0.0, 1.0) / dial, y + random.between(0.0, 1.0) / dial, value};
    };
    addTriangle(scene, {corner(0), corner(1), corner(2)});
  }
  return scene;
}

Scene fan(double dial) {
  Scene scene = hardTarget(64, 64);
  const int n = static_cast<int>(dial);
  const auto rim = [n](int k) {
    const double angle = 2 * std::numbers::pi * (k % n) / n + 0.1;
    return HardVertex{32.5 + 30 * std::cos(angle), 32.5 + 30 * std::sin(angle), static_cast<float>(k % 7)};
  };
  for (int k = 0; k < n; ++k) addTriangle(scene, {HardVertex{32.5, 32.5, 3}, rim(k), rim(k + 1)});
  return scene;
}

Scene ties(double grid) {
  Scene scene = hardTarget(64, 64);
  Prng random(13);
  for (int k = 0; k < 400; ++k) {
    const auto corner = [&](float value) {
      const auto at = [&] { return 0.5 + grid * random.between(0, static_cast<int32_t>(63 / grid)); };
      const double x = at(), y = at();
      return HardVertex{x, y, value};
    };
    addTriangle(scene, {corner(0), corner(1), corner(2)});
  }
  return scene;
}

Scene farFromOrigin(double distance) {
  Scene scene = hardTarget(static_cast<uint32_t>(distance) + 64, 16);
  Prng random(17);
  for (int k = 0; k < 64; ++k) {
    const double x = distance + random.between(0.0, 56.0), y = random.between(1.0, 11.0);
    const auto corner = [&](float value) { return HardVertex{x + random.between(0.0, 4.0), y + random.between(0.0, 4.0), value}; };
    addTriangle(scene, {corner(0), corner(1), corner(2)});
  }
  return scene;
}

Scene guardBand(double dial) {
  Scene scene = hardTarget(64, 64);
  const auto s = static_cast<float>(dial);
  const ClipPosition a{-s, -s, 0.5F, 1}, b{s, -s, 0.5F, 1}, c{s, s, 0.5F, 1}, d{-s, s, 0.5F, 1};
  addClipTriangle(scene, {a, b, c}, {0, 1, 2});
  addClipTriangle(scene, {a, c, d}, {0, 2, 1});
  return scene;
}

Scene nearPlane(double dial) {
  Scene scene = hardTarget(64, 64);
  scene.state.negativeOneToOne = true;
  const auto z = [dial](double s) { return static_cast<float>(-1 + s / dial); };
  addClipTriangle(scene, {ClipPosition{-0.8F, -0.8F, z(-1), 1}, {0.85F, -0.7F, z(1), 1}, {0.1F, 0.9F, z(2), 1}}, {0, 1, 2});
  return scene;
}

Scene drift(double width) {
  Scene scene = hardTarget(static_cast<uint32_t>(width), 16);
  addTriangle(scene, {{{0.3, 2.1, 0}, {width - 0.3, 9.7, 1}, {1.9, 13.3, 2}}});
  return scene;
}

Scene tJunction(double length) {
  Scene scene = hardTarget(static_cast<uint32_t>(length), 16);
  const HardVertex a{0.5, 1.25, 0}, b{length - 0.5, 12.6, 1};
  const HardVertex middle{a.x + 0.37 * (b.x - a.x), a.y + 0.37 * (b.y - a.y), 0.37F};
  const HardVertex above{length - 1.5, 0.5, 2}, below{1.5, 15.25, 3};
  addTriangle(scene, {a, b, below});
  addTriangle(scene, {a, middle, above});
  addTriangle(scene, {middle, b, above});
  return scene;
}

}  // namespace

std::vector<Family> geometryFamilies() {
  const std::vector<double> aspects = decades(1, 6), widths{64, 256, 1024, 4096, 16384};
  return {
      {"sliver", "a triangle 1018 pixels long", "length over thickness", aspects, sliver},
      {"moving-slivers", "sixteen of them, each 1/16 pixel farther down", "length over thickness", aspects, movingSlivers},
      {"subpixel", "1024 small triangles, in the end without area on the grid", "1 over the size in pixels", {0.0625, 0.25, 1, 4, 16, 64, 256, 1024}, subpixel},
      {"fan", "a closed fan around a vertex on a sample", "triangles", {3, 10, 30, 100, 300, 768}, fan},
      {"ties", "400 triangles with corners on sample centres and on steps between them", "step, pixels", {0.00390625, 0.015625, 0.0625, 0.25, 1}, ties},
      {"far", "64 triangles of four pixels, far from the origin", "distance, pixels", {16, 64, 256, 1024, 4096, 16000}, farFromOrigin},
      {"guard-band", "two triangles that are larger than the view volume and share its diagonal", "size over that of the volume", decades(0, 6), guardBand},
      {"near-plane", "a triangle that leans against the near plane and goes through it", "1 over its depth behind the plane", decades(0, 7), nearPlane},
      {"drift", "one triangle across the whole target: what adding up along a row loses", "width, pixels", widths, drift},
      {"t-junction", "a long edge with a vertex of its neighbours in the middle", "length, pixels", widths, tJunction},
  };
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> both = geometryFamilies();
    const std::vector<Family> values = valueFamilies();
    both.insert(both.end(), values.begin(), values.end());
    return both;
  }();
  return all;
}

}  // namespace rasterdiff::harness::stability
