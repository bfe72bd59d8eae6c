// Sample shading: at least so many invocations a pixel, each for its own samples. [vk:primsrast-sampleshading]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene shaded(float minimum, bool perspective) {
  Scene scene = square(32, 4);
  scene.state.sampleShadingEnable = true;
  scene.state.minSampleShading = minimum;
  draw(scene, {{3.25, 2.5, 0.5, perspective ? 0.5 : 1}, {28.75, 9, 0.5, 1}, {11, 29.125, 0.5, perspective ? 3.0 : 1}});
  addVarying(scene, "smooth", Interpolation::smooth, 2);
  addVarying(scene, "screen", Interpolation::noperspective, 1);
  return scene;
}

}  // namespace

void addSampleShading(Entries& entries) {
  Family family(entries, "sample-shading");
  for (const float minimum : {0.0f, 0.25f, 0.5f, 1.0f}) {
    family.add(fmt::format("minimum-{}", minimum), "values of pixels that are shaded more than once", {"R19", "R20", "R21"},
               [minimum] { return shaded(minimum, true); });
  }
  family.add("frag-coord", "with one invocation a sample FragCoord is the sample's place", {"R19", "R23"}, [] {
    Scene scene = shaded(1, false);
    scene.builtIns = {BuiltIn::FragCoord};
    return scene;
  });
  family.add("sample-inputs", "inputs with `sample` are evaluated at each sample", {"R19", "R20", "R21"}, [] {
    Scene scene = square(32, 4);
    draw(scene, {{3.25, 2.5, 0.5, 0.5}, {28.75, 9, 0.5, 1}, {11, 29.125, 0.5, 3}});
    addVarying(scene, "sample", Interpolation::sample, 3);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  for (const float minimum : {0.0f, 0.5f}) {
    family.add(fmt::format("masks-{}", minimum), "SampleMask has the samples of an invocation, however many there are", {"R19", "R24"},
               [minimum] {
                 Scene scene = square(16, 4);
                 scene.state.sampleShadingEnable = true;
                 scene.state.minSampleShading = minimum;
                 draw(scene, {{1.25, 1.5}, {14.75, 5}, {5.5, 14.125}});
                 scene.builtIns = {BuiltIn::SampleMask};
                 return scene;
               });
  }
  family.add("ids", "SampleId and SamplePosition shade every sample by itself", {"R19", "R24"}, [] {
    Scene scene = square(16, 4);
    draw(scene, {{1.25, 1.5}, {14.75, 5}, {5.5, 14.125}});
    scene.builtIns = {BuiltIn::SampleId, BuiltIn::SamplePosition, BuiltIn::SampleMask};
    return scene;
  });
}

}  // namespace rasterdiff::families
