// Resolving samples to one value a pixel: the average of k samples of one value and N - k of another.
// [vk:VkResolveModeFlagBits]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// A background and a triangle, each of its own flat value.
Scene mixed(uint32_t samples, float back, float front) {
  Scene scene = square(32, samples);
  scene.target.resolve = true;
  draw(scene, rectangle(0, 0, 32, 32));
  draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
  for (size_t i = 0; i < 2; ++i) {
    Draw& d = scene.draws[i];
    d.varyings = {{.name = "value",
                   .interpolation = Interpolation::flat,
                   .components = 1,
                   .values = std::vector<float>(d.positions.size(), i == 0 ? back : front)}};
  }
  return scene;
}

/// Two crossing triangles: depths that differ within a pixel along every edge and along the crossing.
Scene depths(DepthFormat format, ResolveMode mode) {
  Scene scene = square(32, 4);
  scene.target.depthFormat = format;
  scene.target.depthResolveMode = mode;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  draw(scene, {{3.25, 2.5, 0.1}, {28.75, 9, 0.9}, {11, 29.125, 0.4}});
  draw(scene, {{29.5, 28.25, 0.2}, {2.75, 22, 0.8}, {17, 1.125, 0.3}});
  return scene;
}

}  // namespace

void addResolve(Entries& entries) {
  Family family(entries, "resolve");
  const std::vector<std::string> rules{"R42"};
  family.add(
      "0-and-1-4x", "quarters: exact in every order of summation", rules, [] { return mixed(4, 0, 1); },
      issue("rerun-io/rerun", 12440));
  family.add(
      "thirds-4x", "mixes that float32 rounds", rules, [] { return mixed(4, 1.0f / 3, 0.7f); }, issue("gfx-rs/wgpu", 8617));
  family.add("0-and-1-8x", "eighths", rules, [] { return mixed(8, 0, 1); });
  family.add("0-and-1-2x", "halves", rules, [] { return mixed(2, 0, 1); });
  family.add("far-apart", "a large value swallows a small one, or not", rules, [] { return mixed(4, 1, 16777216); });
  family.add("cancelling", "values of opposite sign", rules, [] { return mixed(4, -1.1f, 1.1f); });
  family.add("smooth", "interpolated values, several of them", {"R21", "R42"}, [] {
    Scene scene = square(32, 4);
    scene.target.resolve = true;
    draw(scene, {{3.25, 2.5}, {28.75, 9, 0.5, 3}, {11, 29.125}});
    addVarying(scene, "a", Interpolation::smooth, 4);
    addVarying(scene, "b", Interpolation::sample, 2);
    return scene;
  });
  using enum DepthFormat;
  for (const auto& [format, formatName] : {std::pair{D32_SFLOAT, "d32f"}, {D16_UNORM, "d16"}, {X8_D24_UNORM_PACK32, "x8d24"}}) {
    for (const auto& [mode, modeName] : {std::pair{ResolveMode::SAMPLE_ZERO, "sample-zero"}, {ResolveMode::AVERAGE, "average"},
                                         {ResolveMode::MIN, "min"}, {ResolveMode::MAX, "max"}}) {
      family.add(fmt::format("depth-{}-{}", formatName, modeName), "depths of a pixel that differ become one", {"R38", "R42"},
                 [format, mode] { return depths(format, mode); });
    }
  }
}

}  // namespace rasterdiff::families
