// Alpha to coverage: the fourth component of the first varying takes samples away. [vk:fragops-covg]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// The last component of every vertex is as given.
void setAlpha(Draw& draw, const std::vector<float>& alpha) {
  for (size_t i = 0; i < draw.positions.size(); ++i) draw.varyings[0].values[4 * i + 3] = alpha[i % alpha.size()];
}

Scene withAlpha(const std::vector<float>& alpha) {
  Scene scene = square(32, 4);
  scene.state.alphaToCoverageEnable = true;
  draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
  addVarying(scene, "color", Interpolation::smooth, 4);
  setAlpha(scene.draws[0], alpha);
  return scene;
}

}  // namespace

void addAlphaToCoverage(Entries& entries) {
  Family family(entries, "alpha-to-coverage");
  const std::vector<std::string> rules{"R41"};
  family.add("zero", "alpha 0 covers no sample", rules, [] { return withAlpha({0}); });
  family.add("one", "alpha 1 takes no sample away", rules, [] { return withAlpha({1}); });
  family.add("beyond", "alphas below 0 and above 1 are as 0 and 1", rules, [] {
    Scene scene = withAlpha({-1});
    draw(scene, {{20.25, 16.5}, {30.75, 18}, {24, 30.125}});
    scene.draws[1].varyings = scene.draws[0].varyings;
    setAlpha(scene.draws[1], {2});
    return scene;
  });
  family.add("half", "the same alpha everywhere", rules, [] { return withAlpha({0.5f}); });
  family.add("ramp", "alpha from 0 to 1: more alpha, not fewer samples", rules, [] { return withAlpha({0, 1, 0.5f}); });
  family.add("with-mask", "alpha and the sample mask", {"R40", "R41"}, [] {
    Scene scene = withAlpha({1});
    scene.state.sampleMask = 0x5;
    return scene;
  });
  family.add("with-depth", "samples that alpha takes away keep their depth", {"R38", "R41"}, [] {
    Scene scene = withAlpha({0, 1, 1});
    useDepth(scene);
    return scene;
  });
}

}  // namespace rasterdiff::families
