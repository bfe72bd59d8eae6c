// Built-ins of the fragment shader as planes: their values, and that observing one does not change what is drawn.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverBuiltIns : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverBuiltIns);

/// [vk:primsrast-multisampling] the four standard locations, in pixels.
constexpr float kSamples[4][2] = {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}};

TEST_P(DriverBuiltIns, FragCoordIsThePixelsCentreWithItsDepthAndOneOverW) {
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = sceneOf({{0, 0, 0.5F, 2}, {16, 0, 0.5F, 2}, {0, 16, 0.5F, 2}}, 8, 8, samples);
    scene.builtIns = {BuiltIn::FragCoord};
    const Frame frame = draw(scene);
    ASSERT_EQ(frame.varyings.size(), 1U);
    EXPECT_EQ(frame.varyings[0].name, "FragCoord");
    const Plane<float>& coord = frame.varyings[0].values;
    ASSERT_EQ(coord.components, 4U);
    for (uint32_t s = 0; s < samples; ++s) {
      EXPECT_EQ(coord.at(5, 3, s, 0), 5.5F);
      EXPECT_EQ(coord.at(5, 3, s, 1), 3.5F);
      EXPECT_EQ(coord.at(5, 3, s, 2), 0.5F);
      EXPECT_EQ(coord.at(5, 3, s, 3), 0.5F);
    }
  }
}

TEST_P(DriverBuiltIns, FrontFacingTellsTheSidesAndIsTrueForPointsAndLines) {
  Scene scene = sceneOf({{0, 0}, {4, 0}, {0, 4}, {4, 4}, {4, 8}, {8, 4}});
  scene.builtIns = {BuiltIn::FrontFacing};
  scene.state.frontFace = FrontFace::CLOCKWISE;
  Frame frame = draw(scene);
  EXPECT_EQ(frame.varyings[0].values.at(0, 0, 0), 1.0F);
  ASSERT_EQ(frame.primitive.at(5, 5, 0), 2U);
  EXPECT_EQ(frame.varyings[0].values.at(5, 5, 0), 0.0F);
  for (const auto topology : {PrimitiveTopology::POINT_LIST, PrimitiveTopology::LINE_STRIP}) {
    scene.state.topology = topology;
    frame = draw(scene);
    for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
      EXPECT_EQ(frame.varyings[0].values.data[i], frame.primitive.data[i] ? 1.0F : 0.0F);
    }
  }
}

TEST_P(DriverBuiltIns, PointCoordRunsFromTheUpperLeftOfThePoint) {
  Scene scene = sceneOf({{4, 4}});
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.state.pointSize = 4;
  scene.builtIns = {BuiltIn::PointCoord};
  const Frame frame = draw(scene);
  const Plane<float>& coord = frame.varyings[0].values;
  for (uint32_t i = 0; i < 4; ++i) {  // [vk:primsrast-points] s = 1/2 + (x_p - x_f) / size
    EXPECT_EQ(coord.at(2 + i, 3, 0, 0), 0.125F + 0.25F * static_cast<float>(i)) << i;
    EXPECT_EQ(coord.at(3, 2 + i, 0, 1), 0.125F + 0.25F * static_cast<float>(i)) << i;
  }
}

TEST_P(DriverBuiltIns, SampleMaskIsTheCoverageOfTheFragment) {
  // Unclipped, so that no driver cuts it into several fragments a pixel.
  Scene scene = sceneOf({{0, 0}, {4.5F, 0}, {4.5F, 8}}, 8, 8, 4);
  scene.builtIns = {BuiltIn::SampleMask};
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.varyings[0].values.at(3, 1, 0), 15.0F);
  EXPECT_EQ(frame.varyings[0].values.at(4, 1, 0), 5.0F);  // samples 0 and 2
  EXPECT_EQ(frame.varyings[0].values.at(4, 1, 2), 5.0F);
  EXPECT_EQ(frame.varyings[0].values.at(4, 1, 1), 0.0F);  // not drawn
}

/// A triangle that holds all of pixel (1, 1), unclipped.
Scene aroundPixel(std::vector<BuiltIn> builtIns) {
  Scene scene = sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8, 8, 4);
  scene.builtIns = std::move(builtIns);
  return scene;
}

TEST_P(DriverBuiltIns, SampleIdAndPositionBelongToEachSample) {
  const Frame frame = draw(aroundPixel({BuiltIn::SampleId, BuiltIn::SamplePosition, BuiltIn::FragCoord}));
  for (uint32_t s = 0; s < 4; ++s) {
    EXPECT_EQ(frame.varyings[0].values.at(1, 1, s), static_cast<float>(s));
    for (uint32_t c = 0; c < 2; ++c) {
      EXPECT_EQ(frame.varyings[1].values.at(1, 1, s, c), kSamples[s][c]);
      EXPECT_EQ(frame.varyings[2].values.at(1, 1, s, c), 1 + kSamples[s][c]);
    }
    EXPECT_EQ(frame.count.at(1, 1, s), 1U);
  }
}

TEST_P(DriverBuiltIns, OnlySampleIdAndPositionForceSampleShading) {
  for (const BuiltIn builtIn : {BuiltIn::FragCoord, BuiltIn::FrontFacing, BuiltIn::SampleId, BuiltIn::SamplePosition}) {
    const Frame frame = draw(aroundPixel({builtIn, BuiltIn::SampleMask}));
    const bool forces = builtIn == BuiltIn::SampleId || builtIn == BuiltIn::SamplePosition;
    for (uint32_t s = 0; s < 4; ++s) {  // the mask of an invocation has the samples that it shades
      EXPECT_EQ(frame.varyings[1].values.at(1, 1, s), forces ? static_cast<float>(1U << s) : 15.0F);
    }
  }
}

TEST_P(DriverBuiltIns, PlanesFollowTheVaryingsAndChangeNothingElse) {
  Scene scene = sceneOf({{1.3F, 0.2F, 0.3F}, {7.1F, 2.9F, 0.9F}, {2.2F, 7.7F, 0.1F}}, 8, 8, 4);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.draws.front().varyings = {{"x", Interpolation::smooth, 1, {0, 16, 0}}};
  const Frame plain = draw(scene);
  scene.builtIns = {BuiltIn::SampleMask, BuiltIn::FragCoord, BuiltIn::FrontFacing};
  const Frame observed = draw(scene);
  ASSERT_EQ(observed.varyings.size(), 4U);
  EXPECT_EQ(observed.varyings[1].name, "SampleMask");
  EXPECT_EQ(observed.varyings[2].name, "FragCoord");
  EXPECT_EQ(observed.varyings[3].name, "FrontFacing");
  EXPECT_EQ(observed.primitive.data, plain.primitive.data);
  EXPECT_EQ(observed.count.data, plain.count.data);
  EXPECT_EQ(observed.depth->data, plain.depth->data);
  EXPECT_EQ(observed.varyings[0].values.data, plain.varyings[0].values.data);
  for (size_t i = 0; i < plain.primitive.data.size(); ++i) {
    EXPECT_EQ(observed.varyings[1].values.data[i] != 0, plain.primitive.data[i] != 0);
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
