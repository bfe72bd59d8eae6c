// Every mistake of the fragment side shows in a small scene made for it, under a profile and under the specification.
#include <functional>

#include "fragment_support.hpp"
#include "rasterizer/deliberate_error.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene biased(float constantFactor, float slopeFactor, float clamp, PolygonMode mode = PolygonMode::FILL) {
  Scene scene = testing::sceneOf({{0.5, 0.5, 0.25}, {7.5, 0.5, 0.5}, {0.5, 7.5, 0.25}}, 8);
  useDepth(scene);
  scene.state.polygonMode = mode;
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = constantFactor;
  scene.state.depthBiasSlopeFactor = slopeFactor;
  scene.state.depthBiasClamp = clamp;
  return scene;
}

Scene outOfRange(bool bias) {
  Scene scene = coveringScene(8, 1, -0.5, 3.5, -0.5);
  useDepth(scene);
  scene.viewport.minDepth = 0.25F;
  scene.viewport.maxDepth = 0.75F;
  scene.state.depthClampEnable = true;
  scene.state.depthBiasEnable = bias;
  scene.state.depthBiasSlopeFactor = bias ? 1 : 0;
  return scene;
}

// Partly covered pixels along a slanting edge, with their places as values.
Scene edge(Interpolation interpolation, uint32_t samples = 4) {
  Scene scene = testing::sceneOf({{0, 0}, {4.25, 0}, {4.25, 8}}, 8, samples);
  addVarying(scene, "x", interpolation, 1, {0, 4.25F, 4.25F});
  if (interpolation == Interpolation::offset) scene.draws[0].varyings[0].offsetX = 0.25F;
  return scene;
}

Scene observing(BuiltIn builtIn, PrimitiveTopology topology = PrimitiveTopology::TRIANGLE_LIST, uint32_t samples = 4) {
  Scene scene = testing::sceneOf({{1, 1, 0.25, 2}, {4.5, 1, 0.5, 2}, {4.5, 7, 0.25, 2}}, 8, samples);
  if (topology == PrimitiveTopology::POINT_LIST) scene.draws[0].positions.resize(1);
  scene.state.topology = topology;
  scene.builtIns = {builtIn};
  return scene;
}

Scene line(Interpolation interpolation) {
  Scene scene = testing::sceneOf({{2.5, 1.5}, {5.5, 14.5}}, 16);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  addVarying(scene, "t", interpolation, 1, {0, 1});
  return scene;
}

Scene masked() {
  Scene scene = coveringScene(4, 4);
  scene.state.sampleMask = 0x3;
  return scene;
}

Scene withAlpha(float alpha) {
  Scene scene = coveringScene(4, 4);
  addVarying(scene, "colour", Interpolation::flat, 4, {1, 1, 1, alpha, 1, 1, 1, alpha, 1, 1, 1, alpha});
  scene.state.alphaToCoverageEnable = true;
  return scene;
}

Scene resolving() {
  Scene scene = edge(Interpolation::flat);
  scene.draws[0].varyings[0].values = {1, 1, 1};
  scene.target.resolve = true;
  return scene;
}

Scene d16() {
  Scene scene = coveringScene(8, 1, 0.1, 0.9, 0.3);
  useDepth(scene, DepthFormat::D16_UNORM);
  return scene;
}

struct Mistake {
  DeliberateError error;
  std::function<Scene()> make;
};

const std::vector<Mistake>& mistakes() {
  using enum DeliberateError;
  static const std::vector<Mistake> all{
      {DepthBiasUnclamped, [] { return biased(0, 2, 0.03125F); }},
      {DepthBiasTripled, [] { return biased(65536, 0, 0); }},
      {DepthBiasSlopeIgnored, [] { return biased(0, 2, 0); }},
      {DepthBiasOnFillOnly, [] { return biased(0, 2, 0, PolygonMode::LINE); }},
      {DepthTruncated, d16},
      {DepthClampIgnored, [] { return outOfRange(false); }},
      {DepthClampBeforeBias, [] { return outOfRange(true); }},
      {SampleMaskIgnored, masked},
      {SampleMaskShifted, masked},
      {CoverageMaskReversed, [] { return observing(BuiltIn::SampleMask); }},
      {SampleMaskInFull, [] { return observing(BuiltIn::SampleMask); }},
      {SampleIdZero, [] { return observing(BuiltIn::SampleId); }},
      {CentroidIgnored, [] { return edge(Interpolation::centroid); }},
      {SampleAtCentre, [] { return edge(Interpolation::sample); }},
      {OffsetFlipped, [] { return edge(Interpolation::offset, 1); }},
      {FragCoordInteger, [] { return observing(BuiltIn::FragCoord); }},
      {FragCoordW, [] { return observing(BuiltIn::FragCoord); }},
      {FrontFacingInverted, [] { return observing(BuiltIn::FrontFacing); }},
      {PointCoordUp, [] { return observing(BuiltIn::PointCoord, PrimitiveTopology::POINT_LIST, 1); }},
      {LineAttributesByX, [] { return line(Interpolation::noperspective); }},
      {FlatFromWrongLineEnd, [] { return line(Interpolation::flat); }},
      {AlphaInverted, [] { return withAlpha(0); }},
      {ResolveSampleZero, resolving},
  };
  return all;
}

Rules withSizes(Rules rules) {
  rules.limits.pointSizeMax = 64;
  return rules;
}

Scene sized(Scene scene) {
  if (scene.state.topology == PrimitiveTopology::POINT_LIST) scene.state.pointSize = 4;
  return scene;
}

class FragmentMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(FragmentMistake, IsIllegalUnderTheProfileAndTheSpecification) {
  const Scene scene = sized(GetParam().make());
  const Frame mistaken = drawn(scene, withSizes(withError(GetParam().error)));
  const Frame reference = drawn(scene, withSizes(testing::referenceRules()));
  const Frame specification = drawn(scene, withSizes(specificationRules()));
  EXPECT_EQ(illegalities(reference, reference), 0);
  EXPECT_EQ(illegalities(specification, specification), 0);
  EXPECT_GT(illegalities(reference, mistaken), 0);
  EXPECT_GT(illegalities(specification, mistaken), 0);
}

std::string nameOf(DeliberateError error) {
  std::string name;
  for (const DeliberateErrorInfo& known : deliberateErrors()) {
    if (known.error == error) name = known.name;
  }
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, FragmentMistake, ::testing::ValuesIn(mistakes()),
                         [](const auto& testInfo) { return nameOf(testInfo.param.error); });

}  // namespace
}  // namespace rasterdiff::rasterizer
