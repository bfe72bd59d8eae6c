// compare() on frames that differ in a known way from the reference's.
#include "harness/compare/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/scenes.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Rules;

Rules openRules() { return Rules::specification(Limits{}); }

const std::vector<testing::Point> kSquare{{1.5, 1.5}, {5.5, 1.5}, {5.5, 5.5}, {1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5}};

Scene squareWithValues() {
  Scene scene = testing::sceneOf({{1, 1, 0.25}, {6, 1, 0.5}, {6, 6, 0.75}, {1, 1, 0.25}, {6, 6, 0.75}, {1, 6, 0.5}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.draws[0].varyings = {{"colour", Interpolation::smooth, 2, {0, 1, 2, 3, 4, 5, 0, 1, 4, 5, 6, 7}},
                             {"id", Interpolation::flat, 1, {3, 0, 0, 4, 0, 0}}};
  return scene;
}

struct Compared {
  Scene scene;
  Rules rules;
  Frame reference, actual;
  Compared(Scene s, Rules r) : scene(std::move(s)), rules(std::move(r)) {
    reference = *rasterizer::render(scene, rules);
    actual = *rasterizer::render(scene, testing::referenceRules());
  }
  [[nodiscard]] SceneResult result() const { return *compare(scene, rules, reference, actual); }
  void set(uint32_t x, uint32_t y, uint32_t primitive, uint32_t count) {
    actual.primitive.at(x, y, 0) = primitive;
    actual.count.at(x, y, 0) = count;
  }
};

TEST(Compare, EqualFramesAreSame) {
  for (const Rules& rules : {testing::referenceRules(), openRules()}) {
    const Compared c(squareWithValues(), rules);
    const SceneResult result = c.result();
    EXPECT_EQ(result.verdict, Verdict::Same);
    EXPECT_EQ(result.id, "test");
    EXPECT_EQ(result.samples, 64U);
    EXPECT_EQ(result.same, 64U);
    EXPECT_EQ(result.coveredSamples, 25U);
    EXPECT_TRUE(result.differences.empty());
    EXPECT_TRUE(result.freedoms.empty());
    ASSERT_EQ(result.values.size(), 3U);
    EXPECT_EQ(result.values[0].name, "depth");
    EXPECT_EQ(result.values[1].name, "colour");
    EXPECT_EQ(result.values[1].compared, 50U);
    EXPECT_EQ(result.values[2].name, "id");
    EXPECT_FALSE(isUnexpected(result));
  }
}

TEST(Compare, OtherOwnerOfATieIsAllowedByTheSpecificationOnly) {
  Compared open(testing::sceneOf(kSquare, 8), openRules());
  open.set(3, 3, 2, 1);  // the diagonal's sample goes to the other triangle
  const SceneResult result = open.result();
  EXPECT_EQ(result.verdict, Verdict::Allowed);
  EXPECT_EQ(result.allowed, 1U);
  EXPECT_EQ(result.same, 63U);
  EXPECT_EQ(result.freedoms, (std::map<std::string, uint64_t>{{"tie-owner", 1}}));
  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].x, 3U);
  EXPECT_EQ(result.differences[0].y, 3U);
  EXPECT_EQ(result.differences[0].reason, "tie-owner");
  EXPECT_EQ(result.differences[0].anchor, "vk:primsrast-polygons-basic");
  EXPECT_EQ(result.differences[0].expectedPrimitive, 1U);
  EXPECT_EQ(result.differences[0].actualPrimitive, 2U);

  Compared closed(testing::sceneOf(kSquare, 8), testing::referenceRules());
  closed.set(3, 3, 2, 1);
  EXPECT_EQ(closed.result().verdict, Verdict::Differs);
}

TEST(Compare, HoleAndDoubleHitOnASharedEdgeDiffer) {
  for (const auto& [primitive, count] : {std::pair{0U, 0U}, std::pair{2U, 2U}}) {
    Compared c(testing::sceneOf(kSquare, 8), openRules());
    c.set(3, 3, primitive, count);
    const SceneResult result = c.result();
    EXPECT_EQ(result.verdict, Verdict::Differs) << count;
    EXPECT_EQ(result.differing, 1U);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_TRUE(isUnexpected(result));
  }
}

TEST(Compare, WrongCountAloneDiffers) {
  Compared c(testing::sceneOf(kSquare, 8), openRules());
  c.actual.count.at(4, 2, 0) = 2;
  const SceneResult result = c.result();
  EXPECT_EQ(result.verdict, Verdict::Differs);
  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].expectedCount, 1U);
  EXPECT_EQ(result.differences[0].actualCount, 2U);
  EXPECT_EQ(result.differences[0].actualPrimitive, result.differences[0].expectedPrimitive);
}

TEST(Compare, CountsEveryDifferenceAndListsTheFirstOnes) {
  Compared c(testing::sceneOf({{0, 0}, {8, 0}, {8, 8}, {0, 0}, {8, 8}, {0, 8}}, 8), openRules());
  for (uint32_t y = 0; y < 8; ++y) {
    for (uint32_t x = 0; x < 8; ++x) c.set(x, y, 0, 0);
  }
  const SceneResult result = c.result();
  EXPECT_EQ(result.differing, 64U);
  EXPECT_EQ(result.same + result.allowed, 0U);
  ASSERT_EQ(result.differences.size(), kListedDifferences);
  for (size_t i = 0; i < kListedDifferences; ++i) {
    EXPECT_EQ(result.differences[i].x, i % 8);
    EXPECT_EQ(result.differences[i].y, i / 8);
  }
}

TEST(Compare, ListsWhatDiffersBeforeWhatIsAllowed) {
  Compared c(testing::sceneOf(kSquare, 8), openRules());
  for (uint32_t i = 2; i <= 4; ++i) c.set(i, i, 2, 1);
  c.set(7, 7, 1, 1);
  const SceneResult result = c.result();
  EXPECT_EQ(result.allowed, 3U);
  EXPECT_EQ(result.differing, 1U);
  ASSERT_EQ(result.differences.size(), 4U);
  EXPECT_EQ(result.differences[0].verdict, Verdict::Differs);
  EXPECT_EQ(result.differences[0].x, 7U);
  EXPECT_EQ(result.differences[1].verdict, Verdict::Allowed);
}

TEST(Compare, ValueInsideItsIntervalIsAllowedByEvaluation) {
  Compared c(squareWithValues(), openRules());
  float& depth = c.actual.depth->at(3, 2, 0);
  depth = std::nextafter(depth, 1.0F);
  const SceneResult result = c.result();
  EXPECT_EQ(result.verdict, Verdict::Allowed);
  EXPECT_EQ(result.reason, "evaluation");
  EXPECT_EQ(result.same, 64U) << "coverage is the same everywhere";
  EXPECT_EQ(result.values[0].allowed, 1U);
  EXPECT_EQ(result.values[0].maxUlp, 1);
}

TEST(Compare, ValueOutsideItsIntervalDiffersAndNamesItsPlaneAndPlace) {
  Compared c(squareWithValues(), openRules());
  c.actual.varyings[0].values.at(4, 2, 0, 1) += 1;
  const SceneResult result = c.result();
  EXPECT_EQ(result.verdict, Verdict::Differs);
  EXPECT_NE(result.reason.find("colour"), std::string::npos);
  EXPECT_EQ(differingPlanes(result), std::vector<std::string>{"colour"});
  ASSERT_TRUE(result.values[1].firstDiffering);
  EXPECT_EQ(result.values[1].firstDiffering->x, 4U);
  EXPECT_EQ(result.values[1].firstDiffering->y, 2U);
  EXPECT_EQ(result.values[1].firstDiffering->component, 1U);
}

TEST(Compare, FlatValueMayNotMoveByOneBit) {
  Compared c(squareWithValues(), openRules());
  float& id = c.actual.varyings[1].values.at(4, 2, 0);
  id = std::nextafter(id, 100.0F);
  EXPECT_EQ(differingPlanes(c.result()), std::vector<std::string>{"id"});
}

TEST(Compare, NotANumberDiffers) {
  Compared c(squareWithValues(), openRules());
  c.actual.varyings[0].values.at(4, 2, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(differingPlanes(c.result()), std::vector<std::string>{"colour"});
}

TEST(Compare, WhereNothingIsDrawnTheClearValuesMustBe) {
  Compared c(squareWithValues(), openRules());
  c.actual.depth->at(7, 7, 0) = 0.5F;
  c.actual.varyings[1].values.at(0, 0, 0) = 1;
  EXPECT_EQ(differingPlanes(c.result()), (std::vector<std::string>{"depth", "id"}));
}

// Where another owner is legal, its values are judged by its own planes.
TEST(Compare, ValuesOfAnotherLegalOwnerAreItsOwn) {
  Scene scene = testing::sceneOf(kSquare, 8);
  scene.draws[0].varyings = {{"id", Interpolation::flat, 1, {3, 0, 0, 4, 0, 0}}};
  Compared c(scene, openRules());
  c.set(3, 3, 2, 1);
  c.actual.varyings[0].values.at(3, 3, 0) = 4;
  EXPECT_EQ(c.result().verdict, Verdict::Allowed);
  c.actual.varyings[0].values.at(3, 3, 0) = 3;
  EXPECT_EQ(differingPlanes(c.result()), std::vector<std::string>{"id"});
}

TEST(Compare, FramesOfDifferentShapeAreRefused) {
  const Scene scene = testing::sceneOf(kSquare, 8), other = testing::sceneOf(kSquare, 16), withValues = squareWithValues();
  const Frame frame = *rasterizer::render(scene, openRules());
  for (const Scene* s : {&other, &withValues}) {
    const auto result = compare(scene, openRules(), frame, *rasterizer::render(*s, openRules()));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::BadInput);
  }
}

TEST(Compare, EverySampleOfAPixelIsComparedOnItsOwn) {
  Compared c(testing::sceneOf({{1, 1}, {6, 1}, {1, 6}}, 8, 4), openRules());
  c.actual.primitive.at(2, 2, 3) = 0;
  c.actual.count.at(2, 2, 3) = 0;
  const SceneResult result = c.result();
  EXPECT_EQ(result.samples, 256U);
  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].sample, 3U);
}

TEST(Verdicts, HaveTheirNames) {
  EXPECT_EQ(toString(Verdict::Same), "Same");
  EXPECT_EQ(toString(Verdict::Allowed), "Allowed");
  EXPECT_EQ(toString(Verdict::Differs), "Differs");
  EXPECT_EQ(toString(Verdict::Skipped), "Skipped");
  EXPECT_EQ(toString(Verdict::Crashed), "Crashed");
  EXPECT_EQ(toString(Verdict::TimedOut), "TimedOut");
}

}  // namespace
}  // namespace rasterdiff::harness
