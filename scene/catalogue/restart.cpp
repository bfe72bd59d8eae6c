// Primitive restart: an index of all ones ends a strip, fan or list. [vk:VkPipelineInputAssemblyStateCreateInfo]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kR = kRestartIndex;

Scene zigzag(PrimitiveTopology topology, std::vector<uint32_t> indices) {
  Scene scene = square(64);
  scene.state.topology = topology;
  scene.state.primitiveRestartEnable = true;
  std::vector<Px> v;
  for (int i = 0; i < 12; ++i) v.push_back({4.5 + 5 * i, i % 2 == 0 ? 8.25 + i : 54.5 - 2 * i});
  draw(scene, v).indices = std::move(indices);
  return scene;
}

}  // namespace

void addRestart(Entries& entries) {
  Family family(entries, "restart");
  using enum PrimitiveTopology;
  const std::vector<std::string> rules{"R11", "R14"};
  family.add("strip", "a strip of four, one of three, and the parity begins anew", rules,
             [] { return zigzag(TRIANGLE_STRIP, {0, 1, 2, 3, kR, 4, 5, 6, kR, 7, 8, 9, 10, 11}); });
  family.add("fan", "the centre of the second fan is its own first vertex", rules,
             [] { return zigzag(TRIANGLE_FAN, {0, 1, 3, 5, kR, 6, 7, 9, 11}); });
  family.add("line-strip", "two line strips that are not connected", {"R27"},
             [] { return zigzag(LINE_STRIP, {0, 1, 2, 3, kR, 5, 6, 7, kR, 9, 10}); });
  family.add("too-short", "strips of no, one and two vertices draw nothing", rules,
             [] { return zigzag(TRIANGLE_STRIP, {kR, 0, kR, kR, 1, 2, kR, 3, 4, 5, kR}); });
  family.add("list", "a restart leaves an incomplete triangle undrawn", rules,
             [] { return zigzag(TRIANGLE_LIST, {0, 1, 2, 3, 4, kR, 5, 6, 7}); });
  family.add("points", "a restart between points does nothing", {"R25"},
             [] { return zigzag(POINT_LIST, {0, kR, 1, 2, kR}); });
  family.add("provoking", "flat values after a restart", rules, [] {
    Scene scene = zigzag(TRIANGLE_STRIP, {0, 1, 2, 3, kR, 4, 5, 6, 7, 8});
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
}

}  // namespace rasterdiff::families
