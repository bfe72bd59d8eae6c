// Scenes that ask for NaN and infinities get a picture, whatever it is, from every kind of rules; the rest of the scene is
// drawn as without them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rasterizer/render.hpp"
#include "rasterizer/snap.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(NonFinite, SnapsToTheGuardBand) {
  constexpr auto kFar = static_cast<int32_t>(kGuardBand) * kSubpixelOne;
  for (const SnapRounding rounding : {SnapRounding::NearestEven, SnapRounding::NearestUp, SnapRounding::Floor, SnapRounding::TowardZero}) {
    EXPECT_EQ(snap(std::nan(""), 8, rounding), -kFar);
    EXPECT_EQ(snap(double{kInfinity}, 8, rounding), kFar);
    EXPECT_EQ(snap(-double{kInfinity}, 8, rounding), -kFar);
  }
  EXPECT_EQ(snapFloat(testing::referenceRules(), 4, kNaN), -kFar);
  EXPECT_EQ(snapFloat(testing::referenceRules(), 4, kInfinity), kFar);
}

TEST(NonFinite, VerticesDoNotDisturbTheOtherTriangles) {
  const std::vector<testing::Point> two{{1, 1}, {3, 1}, {1, 3}, {4, 4}, {7, 4}, {4, 7}};
  const Scene plain = testing::sceneOf({two[3], two[4], two[5]}, 8);
  for (const Rules& rules : {testing::referenceRules(), *Rules::profile("lavapipe", Limits{}), Rules::specification(Limits{})}) {
    const Frame expected = render(plain, rules).value();
    for (const float value : {kNaN, kInfinity, -kInfinity, std::numeric_limits<float>::max()}) {
      for (size_t vertex = 0; vertex < 3; ++vertex) {
        for (int coordinate = 0; coordinate < 4; ++coordinate) {
          Scene scene = testing::sceneOf(two, 8);
          scene.allowNonFinite = true;
          ClipPosition& p = scene.draws[0].positions[vertex];
          (coordinate == 0 ? p.x : coordinate == 1 ? p.y : coordinate == 2 ? p.z : p.w) = value;
          const Frame frame = render(scene, rules).value();
          for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
            EXPECT_EQ(frame.primitive.data[i] == 2, expected.primitive.data[i] == 1) << rules.name << ", " << value;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
