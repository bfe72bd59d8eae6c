// Random strips and random state: valid scenes, the same for the same seed, with what their heads promise.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/catalogue/catalogue.hpp"
#include "scene/generators/random_state.hpp"
#include "scene/generators/random_strips.hpp"
#include "scene/generators/random_triangles.hpp"
#include "scene/needs.hpp"

namespace rasterdiff {
namespace {

TEST(RandomStrips, HaveAtLeastThePrimitivesAskedForInsideTheVolume) {
  for (const PrimitiveTopology topology :
       {PrimitiveTopology::TRIANGLE_STRIP, PrimitiveTopology::TRIANGLE_FAN, PrimitiveTopology::LINE_STRIP}) {
    const Scene scene = randomStrips({.seed = 5, .primitives = 300, .topology = topology});
    ASSERT_TRUE(validate(scene).has_value());
    const uint32_t made = primitiveCount(scene.state, scene.draws[0]);
    EXPECT_GE(made, 300u);
    EXPECT_LE(made, 309u);
    EXPECT_FALSE(needsClipping(scene));
    EXPECT_EQ(scene, randomStrips({.seed = 5, .primitives = 300, .topology = topology}));
    EXPECT_NE(scene.draws, randomStrips({.seed = 6, .primitives = 300, .topology = topology}).draws);
  }
}

TEST(RandomStrips, RepeatVerticesAndReturnToTheirStart) {
  const Scene scene = randomStrips({.seed = 5, .primitives = 1000, .topology = PrimitiveTopology::LINE_STRIP});
  const std::vector<uint32_t>& indices = *scene.draws[0].indices;
  size_t repeated = 0, returned = 0;
  uint32_t first = 0;
  for (size_t i = 0; i < indices.size(); ++i) {
    const bool starts = i == 0 || indices[i - 1] == kRestartIndex;
    if (starts) first = indices[i];
    if (!starts && indices[i] != kRestartIndex && indices[i] == indices[i - 1]) ++repeated;
    const bool ends = i + 1 == indices.size() || indices[i + 1] == kRestartIndex;
    if (!starts && ends && indices[i] == first) ++returned;
  }
  EXPECT_GE(repeated, 10u);
  EXPECT_GE(returned, 10u);
}

TEST(RandomState, DepthsLieOnBothSidesOfBothPlanesAndOnThem) {
  Scene scene = randomTriangles({.seed = 3, .triangles = 400});
  leaveDepthRange(scene, 3);
  size_t before = 0, behind = 0, on = 0;
  for (const ClipPosition& p : scene.draws[0].positions) {
    before += p.z < 0;
    behind += p.z > p.w;
    on += p.z == 0 || p.z == p.w;
  }
  EXPECT_GE(before, 100u);
  EXPECT_GE(behind, 100u);
  EXPECT_GE(on, 10u);
}

TEST(RandomState, ClipDistancesHaveBothSignsAndZero) {
  Scene scene = randomTriangles({.seed = 3, .triangles = 100});
  giveClipDistances(scene, 3, 2);
  ASSERT_TRUE(validate(scene).has_value());
  size_t negative = 0, zero = 0, positive = 0;
  for (const float d : scene.draws[0].clipDistances) {
    negative += d < 0;
    zero += d == 0;
    positive += d > 0;
  }
  EXPECT_EQ(negative + zero + positive, 600u);
  EXPECT_GE(negative, 50u);
  EXPECT_GE(zero, 20u);
  EXPECT_GE(positive, 200u);
}

TEST(RandomState, ScissorsLieInsideTheTargetAndViewportsFlip) {
  size_t flipped = 0, thin = 0;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    Scene scene = randomTriangles({.seed = seed, .triangles = 1});
    giveScissor(scene, seed);
    giveViewport(scene, seed);
    ASSERT_TRUE(validate(scene).has_value()) << seed;
    EXPECT_LE(static_cast<uint32_t>(scene.scissor->x) + scene.scissor->width, scene.target.width);
    EXPECT_LE(static_cast<uint32_t>(scene.scissor->y) + scene.scissor->height, scene.target.height);
    thin += scene.scissor->width == 1 || scene.scissor->height == 1;
    flipped += scene.viewport.height < 0;
  }
  EXPECT_GE(thin, 5u);
  EXPECT_GE(flipped, 30u);
  EXPECT_LE(flipped, 70u);
}

TEST(Catalogue, EveryRandomFamilyIsRemadeFromASeed) {
  size_t families = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_EQ(entry.remake != nullptr, entry.name.starts_with("random")) << entry.name;
    if (!entry.remake) continue;
    ++families;
    const Result<Scene> a = entry.remake(77, 20), b = entry.remake(78, 20);
    ASSERT_TRUE(a && b) << entry.name;
    EXPECT_TRUE(validate(*a).has_value()) << entry.name;
    EXPECT_EQ(a->name, entry.name);
    EXPECT_NE(a->draws, b->draws) << entry.name;
    EXPECT_GE(primitiveCount(a->state, a->draws[0]), 20u) << entry.name;
  }
  EXPECT_GE(families, 100u);
}

}  // namespace
}  // namespace rasterdiff
