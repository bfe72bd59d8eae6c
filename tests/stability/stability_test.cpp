// The families get harder without anything crashing or becoming infinite, and the exact methods stay exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "harness/report/stability_text.hpp"
#include "harness/stability/results.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness::stability {
namespace {

class HardFamily : public ::testing::TestWithParam<Family> {};

TEST_P(HardFamily, IsFiniteAndExactInTheReference) {
  const Family& family = GetParam();
  const rasterizer::Rules rules = *rasterizer::Rules::profile("reference", Limits{});
  for (const double dial : family.values) {
    const Scene scene = family.make(dial);
    const Result<Frame> frame = rasterizer::render(scene, rules);
    ASSERT_TRUE(frame) << family.name << " at " << dial << ": " << frame.error().what;
    const auto& values = frame->varyings[0].values.data;
    EXPECT_TRUE(std::ranges::all_of(values, [](float v) { return std::isfinite(v); })) << family.name << " at " << dial;
  }
  for (const Series& series : measureMethods(family)) {
    ASSERT_EQ(series.points.size(), family.values.size()) << series.method;
    const rasterizer::CoverageMethod* method = rasterizer::coverageMethod(series.method);
    if (!series.values && method->exact) {
      EXPECT_FALSE(breaksAt(series)) << series.method;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardFamily, ::testing::ValuesIn(families()), [](const auto& testInfo) {
  std::string name = testInfo.param.name;
  std::erase(name, '-');
  return name;
});

TEST(Families, HaveDialsThatGrow) {
  std::set<std::string> names;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_TRUE(std::ranges::is_sorted(family.values)) << family.name;
    EXPECT_GE(family.values.size(), 5U) << family.name;
    EXPECT_GT(family.values.front(), 0) << family.name;
  }
}

Series series(bool values, bool judged, std::vector<Point> points) { return {"family", "a method", values, judged, std::move(points)}; }

TEST(BreakingPoint, IsTheFirstWrongSample) {
  EXPECT_EQ(breaksAt(series(false, false, {{1, 9, 0}, {10, 9, 2}, {100, 9, 0}})), 10);
  EXPECT_EQ(breaksAt(series(false, false, {{1, 9, 0}, {10, 9, 0}})), std::nullopt);
}

TEST(BreakingPoint, OfAMethodIsWhereHalfTheBitsAreLost) {
  EXPECT_EQ(breaksAt(series(true, false, {{1, 9, 0, kLostUlp}, {10, 9, 0, kLostUlp + 1}})), 10);
  EXPECT_EQ(breaksAt(series(true, false, {{1, 9, 0, 0, 1}})), 1);
}

TEST(BreakingPoint, OfADriverIsWhereAValueLeavesItsInterval) {
  EXPECT_EQ(breaksAt(series(true, true, {{1, 9, 0, 1e9}, {10, 9, 1, 3}})), 10);
}

TEST(Records, SurviveTheWayOutOfAProcess) {
  const std::vector<Series> sent{series(true, true, {{0.0625, 9, 1, std::numeric_limits<double>::infinity(), 2}, {1e7, 1, 0, 0.25, 0}})};
  const Result<std::vector<Series>> received = readRecord(recordOf(sent));
  ASSERT_TRUE(received);
  ASSERT_EQ(received->size(), 1U);
  EXPECT_EQ(received->front().method, "a method");
  ASSERT_EQ(received->front().points.size(), 2U);
  EXPECT_EQ(received->front().points[0].maxUlp, std::numeric_limits<double>::infinity());
  EXPECT_EQ(received->front().points[1].dial, 1e7);
  EXPECT_FALSE(readRecord("half a line"));
}

}  // namespace
}  // namespace rasterdiff::harness::stability
