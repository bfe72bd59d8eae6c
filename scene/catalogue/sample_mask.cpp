// The sample mask of the pipeline: bit s keeps sample s. [vk:fragops-samplemask]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene masked(uint32_t samples, uint32_t mask) {
  Scene scene = square(32, samples);
  scene.state.sampleMask = mask;
  draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
  return scene;
}

}  // namespace

void addSampleMask(Entries& entries) {
  Family family(entries, "sample-mask");
  for (const uint32_t mask : {0x0u, 0x1u, 0x2u, 0x4u, 0x8u, 0x6u, 0xBu, 0xFFFFFFF5u}) {
    family.add(fmt::format("4x-{:x}", mask), "only the samples of the mask are written", {"R16", "R40"},
               [mask] { return masked(4, mask); });
  }
  family.add("1x-0", "the only sample is masked", {"R40"}, [] { return masked(1, 0xFFFFFFFE); });
  family.add("1x-1", "bits beyond the samples mean nothing", {"R40"}, [] { return masked(1, 0x00000001); });
  family.add("8x-a5", "eight samples, four of them kept", {"R16", "R40"}, [] { return masked(8, 0xA5); });
  family.add("depth", "masked samples keep their depth", {"R38", "R40"}, [] {
    Scene scene = masked(4, 0x9);
    useDepth(scene);
    return scene;
  });
  family.add("bresenham-4x", "the mask takes samples of Bresenham lines, which cover whole pixels", {"R31", "R40"}, [] {
    Scene scene = square(16, 4);
    useLines(scene, LineRasterizationMode::BRESENHAM);
    scene.state.sampleMask = 0xD;
    draw(scene, {{1.25, 2.5}, {14.75, 8.25}});
    return scene;
  });
  family.add("values", "a mask does not move where values are evaluated from the primitive", {"R20", "R40"}, [] {
    Scene scene = masked(4, 0x3);
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "centroid", Interpolation::centroid, 2);
    return scene;
  });
}

}  // namespace rasterdiff::families
