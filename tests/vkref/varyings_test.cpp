// Fragment inputs: interpolation qualifiers, component counts, passes, and values that belong to a fragment.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverVaryings : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverVaryings);

// Far above any float32 evaluation error of values of size 1 on 8 pixels (about 1e-6), far below the difference
// between the interpolations in these tests (0.1 and more).
constexpr float kTellsInterpolationsApart = 1e-3F;

/// Covers the target; w is 1 on the left and 3 at the right corner, which lies at twice the width.
std::vector<Point> perspectiveTarget() { return {{0, 0, 0.5F, 1}, {16, 0, 0.5F, 3}, {0, 16, 0.5F, 1}}; }

/// 0 at the left vertices, 1 at the right one, in every component.
Varying ramp(const std::string& name, Interpolation interpolation, uint32_t components = 1) {
  Varying varying{name, interpolation, components, {}};
  for (float value : {0.0F, 1.0F, 0.0F}) varying.values.insert(varying.values.end(), components, value);
  return varying;
}

TEST_P(DriverVaryings, EachQualifierInterpolatesInItsOwnWay) {
  Scene scene = sceneOf(perspectiveTarget());
  scene.draws.front().varyings = {ramp("s", Interpolation::smooth), ramp("n", Interpolation::noperspective),
                                  ramp("f", Interpolation::flat)};
  scene.state.provokingVertexMode = ProvokingVertexMode::LAST_VERTEX;
  const Frame frame = draw(scene);
  for (uint32_t x = 0; x < 8; ++x) {
    const float b = (static_cast<float>(x) + 0.5F) / 16;  // barycentric of the right corner
    // [vk:primsrast-polygon-barycentrics] perspective and linear
    EXPECT_NEAR(frame.varyings[0].values.at(x, 0, 0), b / 3 / (1 - b + b / 3), kTellsInterpolationsApart);
    EXPECT_NEAR(frame.varyings[1].values.at(x, 0, 0), b, kTellsInterpolationsApart);
    EXPECT_EQ(frame.varyings[2].values.at(x, 0, 0), 0.0F);
  }
}

TEST_P(DriverVaryings, EightVaryingsOfAllQualifiersAndComponentsComeBackWhole) {
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = sceneOf(wholeTarget(), 8, 8, samples);
    Draw& draw1 = scene.draws.front();
    const uint32_t components[] = {1, 2, 3, 4, 4, 3, 2, 1};
    for (uint32_t v = 0; v < 8; ++v) {
      std::vector<float> value;
      for (uint32_t c = 0; c < components[v]; ++c) value.push_back(static_cast<float>(10 * v + c) + 0.5F);
      draw1.varyings.push_back(constantVarying(fmt::format("v{}", v), 3, value));
      // Flat values are exact on every driver; the others are checked above and below.
    }
    const Frame frame = draw(scene);
    EXPECT_EQ(device().lastCost().passes, 2U);  // ten planes, eight attachments
    ASSERT_EQ(frame.varyings.size(), 8U);
    for (uint32_t v = 0; v < 8; ++v) {
      const Plane<float>& plane = frame.varyings[v].values;
      EXPECT_EQ(frame.varyings[v].name, fmt::format("v{}", v));
      ASSERT_EQ(plane.components, components[v]);
      ASSERT_EQ(plane.data.size(), size_t{64} * samples * components[v]);
      for (size_t i = 0; i < plane.data.size(); ++i) {
        ASSERT_EQ(plane.data[i], static_cast<float>(10 * v + i % components[v]) + 0.5F) << "varying " << v;
      }
    }
  }
}

TEST_P(DriverVaryings, EveryPassSeesTheSameFragments) {
  for (uint32_t samples : {1U, 4U}) {
    for (const auto interpolation : {Interpolation::smooth, Interpolation::noperspective, Interpolation::flat}) {
      std::vector<Point> points = perspectiveTarget();
      for (const Point& p : std::vector<Point>{{1.3F, 0.2F, 0.3F}, {7.1F, 2.9F, 0.9F}, {2.2F, 7.7F, 0.1F}}) {
        points.push_back(p);
      }
      Scene scene = sceneOf(points, 8, 8, samples);
      scene.target.depthFormat = DepthFormat::D32_SFLOAT;
      scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
      for (uint32_t v = 0; v < 8; ++v) {
        Varying varying{fmt::format("v{}", v), interpolation, 1, {0.1F, 7.3F, -2.6F, 5.5F, 0.01F, -9.9F}};
        scene.draws.front().varyings.push_back(varying);
      }
      const Frame frame = draw(scene);
      for (uint32_t v = 1; v < 8; ++v) {
        EXPECT_EQ(frame.varyings[v].values.data, frame.varyings[0].values.data) << "varying " << v;
      }
    }
  }
}

TEST_P(DriverVaryings, AMixOfQualifiersKeepsItsPlacesInBothPasses) {
  Scene scene = sceneOf(perspectiveTarget());
  for (uint32_t v = 0; v < 8; ++v) {
    scene.draws.front().varyings.push_back(ramp(fmt::format("v{}", v), static_cast<Interpolation>(v % 3), 1 + v % 4));
  }
  const Frame frame = draw(scene);
  const float b = 7.5F / 16;
  const float expected[] = {b / 3 / (1 - b + b / 3), b, 0};
  for (uint32_t v = 0; v < 8; ++v) {
    for (uint32_t c = 0; c < 1 + v % 4; ++c) {
      EXPECT_NEAR(frame.varyings[v].values.at(7, 0, 0, c), expected[v % 3], kTellsInterpolationsApart) << v;
    }
  }
}

TEST_P(DriverVaryings, SamplesOfAWholeFragmentShareOneValue) {
  Scene scene = sceneOf(perspectiveTarget(), 8, 8, 4);
  scene.draws.front().varyings = {ramp("s", Interpolation::smooth, 3)};
  const Frame frame = draw(scene);
  for (uint32_t x = 0; x < 8; ++x) {
    for (uint32_t s = 1; s < 4; ++s) {
      EXPECT_EQ(frame.varyings[0].values.at(x, 2, s, 2), frame.varyings[0].values.at(x, 2, 0, 2));
    }
  }
  EXPECT_NE(frame.varyings[0].values.at(0, 2, 0), frame.varyings[0].values.at(1, 2, 0));
}

TEST_P(DriverVaryings, ValuesAreZeroWhereNothingWasDrawn) {
  Scene scene = sceneOf({{0, 0}, {4, 0}, {0, 4}}, 8, 8, 4);
  scene.draws.front().varyings = {constantVarying("f", 3, {3, 4})};
  const Frame frame = draw(scene);
  for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
    ASSERT_EQ(frame.varyings[0].values.data[2 * i + 1], frame.primitive.data[i] ? 4.0F : 0.0F);
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
