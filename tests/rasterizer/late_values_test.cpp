// Values that wait until all is drawn are those of drawing at once: one input at the sample makes a scene not wait.
#include <gtest/gtest.h>

#include <cstring>

#include "rasterizer/late_values.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::rasterizer {
namespace {

Rules rulesNamed(const std::string& name) {
  const Limits limits;
  return name == "spec" ? Rules::specification(limits) : Rules::profile(name, limits).value();
}

bool waits(const Scene& scene, const Rules& rules) {
  const SceneNeeds needs = needsOf(scene);
  return LateValues::serve(scene, needs, PieceValues(scene, needs, rules));
}

Scene notWaiting(Scene scene) {
  for (Draw& draw : scene.draws) {
    Varying atSample{.name = "atSample", .interpolation = Interpolation::sample, .components = 1};
    atSample.values.assign(draw.positions.size(), 0.0F);
    draw.varyings.push_back(atSample);
  }
  return scene;
}

template <class T>
bool sameBits(const Plane<T>& a, const Plane<T>& b) {
  return a.data.size() == b.data.size() && std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(T)) == 0;
}

void expectSameAtOnce(const CatalogueEntry& entry, const std::string& rulesName) {
  SCOPED_TRACE(entry.name + " under " + rulesName);
  const Scene scene = entry.remake(11, 300).value();
  const Rules rules = rulesNamed(rulesName);
  ASSERT_TRUE(waits(scene, rules));
  const Scene watched = notWaiting(scene);
  ASSERT_FALSE(waits(watched, rules));
  RuleCounts lateCounts, counts;
  const Frame late = render(scene, rules, &lateCounts).value();
  const Frame atOnce = render(watched, rules, &counts).value();
  EXPECT_TRUE(sameBits(late.primitive, atOnce.primitive));
  EXPECT_TRUE(sameBits(late.count, atOnce.count));
  ASSERT_EQ(late.depth.has_value(), atOnce.depth.has_value());
  if (late.depth) {
    EXPECT_TRUE(sameBits(*late.depth, *atOnce.depth));
    EXPECT_TRUE(sameBits(*late.depthBounds, *atOnce.depthBounds));
  }
  for (size_t v = 0; v < late.varyings.size(); ++v) {
    EXPECT_TRUE(sameBits(late.varyings[v].values, atOnce.varyings[v].values)) << late.varyings[v].name;
    EXPECT_TRUE(sameBits(*late.varyings[v].bounds, *atOnce.varyings[v].bounds)) << late.varyings[v].name;
  }
  for (const Rule rule : {Rule::Order, Rule::DepthTest, Rule::Invariance, Rule::TieBreak}) EXPECT_EQ(lateCounts[rule], counts[rule]);
}

TEST(LateValues, AreThoseOfDrawingAtOnce) {
  size_t compared = 0, deep = 0, multisampled = 0, cut = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.remake) continue;
    const Scene scene = entry.remake(11, 300).value();
    if (!waits(scene, rulesNamed("reference"))) continue;
    for (const char* rules : {"reference", "lavapipe"}) expectSameAtOnce(entry, rules);
    // Under open rules a cut triangle may have the planes of the whole one, too: its values do not wait.
    if (needsClipping(scene)) {
      EXPECT_FALSE(waits(scene, rulesNamed("spec"))) << entry.name;
    } else {
      expectSameAtOnce(entry, "spec");
    }
    ++compared;
    deep += needsOf(scene).depth ? 1U : 0U;
    multisampled += scene.target.samples > 1 ? 1U : 0U;
    cut += needsClipping(scene) ? 1U : 0U;
  }
  EXPECT_GE(compared, 4U);
  EXPECT_GE(deep, 1U);
  EXPECT_GE(multisampled, 1U);
  EXPECT_GE(cut, 1U);
}

TEST(LateValues, OfFoldedPiecesAreBoundedByBoth) {
  // A quadrilateral that a clip distance makes of a needle folds over itself when it is snapped.
  Scene scene;
  scene.target.width = scene.target.height = 8;
  scene.target.samples = 4;
  scene.viewport = {0, 0, 8, 8, 0, 1};
  Draw draw;
  Varying value{.name = "value", .components = 1};
  for (int i = 0; i < 200; ++i) {
    const float shift = static_cast<float>(i) * 0x1p-10F;
    draw.positions.insert(draw.positions.end(), {{-0.9F, -0.9F + shift, 0, 1}, {0.9F, -0.897F, 0, 1}, {0.9F, -0.899F + shift, 0, 1}});
    value.values.insert(value.values.end(), {0, 1, 2});
    draw.clipDistances.insert(draw.clipDistances.end(), {1, -0.01F, 0.5F});
  }
  draw.clipDistanceCount = 1;
  draw.varyings.push_back(value);
  scene.draws.push_back(draw);
  const Scene watched = notWaiting(scene);
  const Rules rules = rulesNamed("spec");
  const Frame late = render(scene, rules).value(), atOnce = render(watched, rules).value();
  EXPECT_TRUE(sameBits(late.primitive, atOnce.primitive));
  EXPECT_TRUE(sameBits(*late.varyings[0].bounds, *atOnce.varyings[0].bounds));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
