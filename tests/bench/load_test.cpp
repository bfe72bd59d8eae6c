// Loads and the truth about them: built-in workloads are what they say, and verification sees what hides in a full mask.
#include "harness/bench/load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/bench/truth.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/render.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterdiff::bench::builtInWorkload;
using rasterizer::CoverageMask;
using rasterizer::SnappedTriangle;

Load small() { return loadOf(*rasterdiff::bench::randomTriangles("small", 3000, 40, 256, 200), 1); }

Frame reference(const Scene& scene) { return *rasterizer::render(scene, *rasterizer::Rules::profile("reference", Limits{})); }

TEST(Workloads, AreTheSameEveryTimeOnScreenAndOfTheStatedArea) {
  for (const auto name : rasterdiff::bench::builtInNames()) {
    if (name.starts_with("W4")) continue;  // needs the mesh
    const auto a = builtInWorkload(name, {}, 0.002), b = builtInWorkload(name, {}, 0.002);
    ASSERT_TRUE(a.has_value()) << name;
    EXPECT_EQ(a->triangles, b->triangles) << name;
    const Load load = loadOf(*a, 1);
    const double mean = coveredSamples(load, load.triangles.size()) / static_cast<double>(load.triangles.size());
    const double stated = name == "W1" ? 10 : name == "W2" ? 1000 : name == "W3" ? 500000 : 150;
    EXPECT_NEAR(mean, stated, stated / 50) << name;  // vertices are rounded to 1/256 pixel
    for (const SnappedTriangle& t : load.triangles)
      EXPECT_TRUE(std::ranges::all_of(t.v, [](auto v) { return v.x >= 0 && v.y >= 0 && v.x <= 1920 * 256 && v.y <= 1080 * 256; }));
  }
}

TEST(Workloads, UnknownNamesAndTargetsThatAreTooSmallAreRefused) {
  EXPECT_FALSE(builtInWorkload("W9", {}).has_value());
  EXPECT_FALSE(builtInWorkload("W5", {}, 1, 512, 512).has_value());
}

TEST(Workloads, TrianglesThatCannotFitAreRefusedInsteadOfSoughtForEver) {
  using namespace rasterdiff::bench;
  EXPECT_EQ(randomTriangles("large", 10, 500'000, 1000, 700).error().what, "random triangles of 500000 px do not fit into 1000 x 700 pixels");
  EXPECT_FALSE(randomTriangles("flat", 10, 1000, 32768, 3).has_value());
  EXPECT_FALSE(slivers("long", 10, 1000, 0.3, 600, 600).has_value());
}

TEST(Loads, TheSceneOfAWorkloadSnapsBackToItsTriangles) {
  const Load load = small();
  for (const Task task : {Task::Coverage, Task::Depth, Task::Varyings}) {
    const Scene scene = sceneOf(load, task, 500);
    ASSERT_TRUE(validate(scene).has_value());
    EXPECT_EQ(needsOf(scene).depth, task != Task::Coverage);
    EXPECT_EQ(needsOf(scene).varyings, task == Task::Varyings ? 1U : 0U);
    const Load again = loadOf(scene);
    ASSERT_EQ(again.triangles.size(), 500U);
    for (size_t i = 0; i < 500; ++i) {
      for (const SubpixelPosition v : load.triangles[i].v) EXPECT_NE(std::ranges::find(again.triangles[i].v, v), again.triangles[i].v.end());
    }
  }
}

TEST(Loads, ASceneWithLinesOrAScissorSaysWhatKernelsLeaveOut) {
  EXPECT_EQ(loadOf(sceneOf(small(), Task::Coverage, 10)).note, "");
  Scene scene = sceneOf(small(), Task::Coverage, 10);
  scene.scissor = Rect2D{0, 0, 10, 10};
  EXPECT_NE(loadOf(scene).note.find("scissor"), std::string::npos);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  const Load lines = loadOf(scene);
  EXPECT_TRUE(lines.triangles.empty());
  EXPECT_NE(lines.note.find("lines"), std::string::npos);
}

TEST(Truth, ExactMethodsAreExactAndMistakesUnderOtherTrianglesAreSeen) {
  const Load load = small();  // covers the target more than twice over
  const Truth truth(load, 1e9);
  EXPECT_EQ(truth.triangles(), load.triangles.size());
  const DrawMask exact = [](auto triangles, CoverageMask& mask) { rasterizer::drawCoverage(triangles, mask); };
  // Leaves out every triangle that starts in an even column: in a full mask others would hide most of it.
  const DrawMask lossy = [](auto triangles, CoverageMask& mask) {
    for (const SnappedTriangle& t : triangles)
      if (t.v[0].x / 256 % 2 == 1) rasterizer::drawCoverage({&t, 1}, mask);
  };
  const DrawMask methods[] = {exact, lossy};
  const auto errors = truth.masks(methods);
  ASSERT_TRUE(errors.has_value());
  EXPECT_EQ((*errors)[0].wrong, 0U);
  EXPECT_EQ((*errors)[0].triangles, load.triangles.size());
  EXPECT_NEAR(static_cast<double>((*errors)[1].wrong) / static_cast<double>((*errors)[1].covered), 0.5, 0.05);
}

TEST(Difference, CountsSamplesAndMeasuresValuesInUlps) {
  const Scene scene = sceneOf(small(), Task::Varyings, 200);
  const Frame expected = reference(scene);
  EXPECT_EQ(difference(expected, expected).wrong, 0U);
  EXPECT_EQ(difference(expected, expected).maxUlp, 0);
  EXPECT_GT(difference(expected, expected).values, 1000U);
  Frame actual = expected;
  const auto covered = static_cast<size_t>(std::ranges::find_if(actual.primitive.data, [](uint32_t p) { return p != 0; }) -
                                           actual.primitive.data.begin());
  actual.depth->data[covered] = std::nextafter(actual.depth->data[covered], 2.F);
  EXPECT_EQ(difference(expected, actual).maxUlp, 1);
  actual.primitive.data[covered] = 0;
  EXPECT_EQ(difference(expected, actual).wrong, 1U);
}

}  // namespace
}  // namespace rasterdiff::harness::bench
