// Scenes drawn by one submit have the frames and the errors that they have alone.
#include <algorithm>
#include <cstring>

#include "scene/catalogue/catalogue.hpp"
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverTogether : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverTogether);

template <class Numbers>
bool sameBits(const Numbers& a, const Numbers& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

bool sameBits(const Frame& a, const Frame& b) {
  const auto samePlanes = [](const std::vector<VaryingPlane>& left, const std::vector<VaryingPlane>& right) {
    return std::ranges::equal(left, right, [](const VaryingPlane& p, const VaryingPlane& q) { return p.name == q.name && sameBits(p.values.data, q.values.data); });
  };
  return sameBits(a.primitive.data, b.primitive.data) && sameBits(a.count.data, b.count.data) && a.depth.has_value() == b.depth.has_value() &&
         (!a.depth || sameBits(a.depth->data, b.depth->data)) && samePlanes(a.varyings, b.varyings) && samePlanes(a.resolved, b.resolved);
}

/// Every so-many-eth scene of the catalogue that is small, and of which a driver draws the same twice.
std::vector<Scene> someScenes() {
  constexpr size_t kEach = 11;
  std::vector<Scene> scenes;
  size_t k = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (++k % kEach != 0 || entry.name.starts_with("mesh/") || entry.name.find("offset") != std::string::npos) continue;
    Result<Scene> scene = entry.make();
    if (scene && scene->target.width * scene->target.height <= 64 * 64) scenes.push_back(std::move(*scene));
  }
  return scenes;
}

TEST_P(DriverTogether, ScenesHaveTheFramesAndRefusalsThatTheyHaveAlone) {
  std::vector<Scene> scenes = someScenes();
  ASSERT_GT(scenes.size(), 30u);
  scenes[3].target.width = 0;      // not valid
  scenes[5].target.samples = 16;   // nobody offers it
  scenes[5].target.sampleLocations.reset();
  const std::vector<Result<Frame>> together = renderTogether(scenes, device());
  ASSERT_EQ(together.size(), scenes.size());
  size_t drawn = 0;
  for (size_t i = 0; i < scenes.size(); ++i) {
    const Result<Frame> alone = render(scenes[i], device());
    ASSERT_EQ(together[i].has_value(), alone.has_value()) << scenes[i].name;
    if (alone) {
      EXPECT_TRUE(sameBits(*together[i], *alone)) << scenes[i].name;
      ++drawn;
    } else {
      EXPECT_EQ(together[i].error().where, alone.error().where) << scenes[i].name;
      EXPECT_EQ(together[i].error().what, alone.error().what) << scenes[i].name;
    }
  }
  EXPECT_FALSE(together[3].has_value());
  EXPECT_FALSE(together[5].has_value());
  EXPECT_GT(drawn, 25u);
}

TEST_P(DriverTogether, MoreScenesThanFitABoundAreDrawnAllTheSame) {
  std::vector<Scene> scenes;
  for (uint32_t k = 0; k < 7; ++k) {
    scenes.push_back(sceneOf(wholeTarget(static_cast<float>(900 + k), 700), 900 + k, 700, 4));
    scenes.push_back(sceneOf(wholeTarget(static_cast<float>(8 + k), 5), 8 + k, 5, 1));
  }
  const std::vector<Result<Frame>> together = renderTogether(scenes, device());
  ASSERT_EQ(together.size(), scenes.size());
  for (size_t i = 0; i < scenes.size(); ++i) {
    ASSERT_TRUE(together[i].has_value());
    EXPECT_TRUE(sameBits(*together[i], draw(scenes[i]))) << i;
  }
}

TEST_P(DriverTogether, CostsAreThoseOfAllScenes) {
  const std::vector<Scene> scenes{sceneOf(wholeTarget(32, 16), 32, 16, 4), sceneOf(wholeTarget(8, 8), 8, 8, 1), sceneOf(wholeTarget(8, 8), 8, 8, 1)};
  for (const Result<Frame>& frame : renderTogether(scenes, device())) ASSERT_TRUE(frame.has_value());
  const RenderCost cost = device().lastCost();
  EXPECT_EQ(cost.passes, 3U);
  EXPECT_EQ(cost.colorAttachments, 6U);
  EXPECT_EQ(cost.readbackBytes, (32U * 16 * 4 + 2 * 8 * 8) * 8);
  for (const double seconds : {cost.uploadSeconds, cost.drawSeconds, cost.readbackSeconds}) EXPECT_GT(seconds, 0);
}

/// Not while a scene of several passes is recorded, whose earlier ones would be left without theirs.
TEST_P(DriverTogether, PipelinesAreDroppedBetweenScenes) {
  Result<std::unique_ptr<Device>> forgetful = openDevice({GetParam(), false, 20, /*mostPipelines=*/0});
  ASSERT_TRUE(forgetful.has_value());
  for (const Scene& scene : someScenes()) {
    const Result<Frame> expected = render(scene, device());
    for (int again = 0; expected && again < 2; ++again) {
      const Result<Frame> actual = render(scene, **forgetful);
      ASSERT_TRUE(actual.has_value()) << scene.name;
      EXPECT_TRUE(sameBits(*expected, *actual)) << scene.name;
      EXPECT_GT((*forgetful)->lastCost().pipelinesCreated, 0U) << scene.name << ": each time they are made anew";
    }
  }
}

TEST_P(DriverTogether, NoSceneIsNothing) { EXPECT_TRUE(renderTogether({}, device()).empty()); }

/// How 24-bit depths of several samples come is asked of the device before any scene is recorded.
TEST_P(DriverTogether, WhatIsLostBeforeTheSubmitIsLostForAllOfThem) {
  std::vector<Scene> scenes(2, sceneOf(wholeTarget(8, 8), 8, 8, 4));
  scenes[1].target.depthFormat = DepthFormat::X8_D24_UNORM_PACK32;
  const bool offered = render(scenes[1], device()).has_value();
  Result<std::unique_ptr<Device>> hasty = openDevice({GetParam(), false, /*timeoutSeconds=*/1e-9});
  ASSERT_TRUE(hasty.has_value());
  const std::vector<Result<Frame>> together = renderTogether(scenes, **hasty);
  ASSERT_EQ(together.size(), 2u);
  for (const Result<Frame>& frame : together) ASSERT_FALSE(frame.has_value());
  EXPECT_EQ((*hasty)->lastCost().passes, offered ? 0U : 1U);  // nothing is recorded after what is lost
  EXPECT_EQ(together[0].error().code, ErrorCode::TimedOut);
  EXPECT_EQ(together[1].error().code, offered ? ErrorCode::TimedOut : ErrorCode::NotOffered);
  EXPECT_FALSE(render(scenes[0], **hasty).has_value());
}

TEST_P(DriverTogether, WhatIsLostIsLostForAllOfThem) {
  Result<std::unique_ptr<Device>> hasty = openDevice({GetParam(), false, /*timeoutSeconds=*/1e-9});
  ASSERT_TRUE(hasty.has_value());
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) {
    for (const Point& p : wholeTarget(1024, 1024)) points.push_back(p);
  }
  const std::vector<Scene> scenes(3, sceneOf(points, 1024, 1024));
  const std::vector<Result<Frame>> together = renderTogether(scenes, **hasty);
  ASSERT_EQ(together.size(), 3u);
  for (const Result<Frame>& frame : together) {
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().code, ErrorCode::TimedOut);
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
