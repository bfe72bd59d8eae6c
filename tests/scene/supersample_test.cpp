// A supersampled scene shows the same picture, larger; averages give it back.
#include "scene/supersample.hpp"

#include <gtest/gtest.h>

#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff {
namespace {

Scene scene() {
  Scene scene;
  scene.target = {.width = 8, .height = 4, .samples = 4, .supersample = 3};
  scene.viewport = {0.5f, 4, 8, -4, 0.25f, 1};
  scene.scissor = Rect2D{1, 2, 3, 1};
  scene.furtherViewports = {{{1, 2, 3, 1, 0, 1}, std::nullopt}, {{0, 0, 8, 4, 0, 1}, Rect2D{0, 1, 8, 2}}};
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineWidth = 1.5f;
  scene.state.pointSize = 2;
  scene.state.stippledLineEnable = true;
  scene.state.lineStippleFactor = 2;
  scene.state.depthBiasSlopeFactor = 0.5f;
  scene.draws.push_back({.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}}, .pointSizes = {1, 0.5f}});
  return scene;
}

TEST(Supersampled, EverythingInPixelsGrows) {
  const Scene large = supersampled(scene());
  EXPECT_TRUE(validate(large).has_value());
  EXPECT_EQ(large.target, (Target{.width = 24, .height = 12, .samples = 4}));
  EXPECT_EQ(large.viewport, (Viewport{1.5f, 12, 24, -12, 0.25f, 1}));
  EXPECT_EQ(large.scissor, (Rect2D{3, 6, 9, 3}));
  EXPECT_EQ(large.furtherViewports[0].viewport, (Viewport{3, 6, 9, 3, 0, 1}));
  EXPECT_FALSE(large.furtherViewports[0].scissor.has_value());
  EXPECT_EQ(large.furtherViewports[1].scissor, (Rect2D{0, 3, 24, 6}));
  EXPECT_EQ(large.state.lineWidth, 4.5f);
  EXPECT_EQ(large.state.pointSize, 6.0f);
  EXPECT_EQ(large.state.lineStippleFactor, 6u);
  EXPECT_EQ(large.state.depthBiasSlopeFactor, 1.5f);
  EXPECT_EQ(large.draws[0].pointSizes, (std::vector<float>{3, 1.5f}));
  EXPECT_EQ(large.draws[0].positions, scene().draws[0].positions);
}

TEST(Supersampled, OneChangesNothing) {
  Scene plain = scene();
  plain.target.supersample = 1;
  EXPECT_EQ(supersampled(plain), plain);
}

TEST(Supersampled, ScenesOfTheCatalogueStayValid) {
  size_t count = 0;
  for (const CatalogueEntry* entry : matchCatalogue("supersample/*")) {
    const Result<Scene> made = entry->make();
    ASSERT_TRUE(made.has_value()) << entry->name;
    const auto valid = validate(supersampled(*made));
    EXPECT_TRUE(valid.has_value()) << entry->name;
    ++count;
  }
  EXPECT_GE(count, 10u);
}

TEST(BoxAveraged, EachValueIsTheMeanOfItsBlock) {
  Plane<float> plane(4, 2, 2, 3);
  for (uint32_t y = 0; y < 2; ++y) {
    for (uint32_t x = 0; x < 4; ++x) {
      for (uint32_t s = 0; s < 2; ++s) {
        for (uint32_t c = 0; c < 3; ++c) plane.at(x, y, s, c) = static_cast<float>(x + 10 * y + 100 * s + 1000 * c);
      }
    }
  }
  const Plane<float> mean = boxAveraged(plane, 2);
  ASSERT_EQ(mean.width, 2u);
  ASSERT_EQ(mean.height, 1u);
  ASSERT_EQ(mean.samples, 2u);
  ASSERT_EQ(mean.components, 3u);
  EXPECT_EQ(mean.at(0, 0, 0, 0), 5.5f);
  EXPECT_EQ(mean.at(1, 0, 0, 0), 7.5f);
  EXPECT_EQ(mean.at(1, 0, 1, 2), 2107.5f);
}

TEST(BoxAveraged, IncompleteBlocksAreLeftOutAndZeroGivesNothing) {
  const Plane<float> plane(5, 3, 1, 1, 2.0f);
  const Plane<float> mean = boxAveraged(plane, 2);
  EXPECT_EQ(mean.width, 2u);
  EXPECT_EQ(mean.height, 1u);
  EXPECT_EQ(mean.data, (decltype(mean.data){2, 2}));
  EXPECT_EQ(boxAveraged(plane, 1).data, plane.data);
  EXPECT_TRUE(boxAveraged(plane, 0).data.empty());
}

}  // namespace
}  // namespace rasterdiff
