// Medians, deviations, and the Pareto line.
#include "harness/bench/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/report/plot.hpp"
#include "harness/report/plot_axes.hpp"

namespace rasterdiff::harness::bench {
namespace {

TEST(Statistics, MedianIsTheMiddleOrTheMeanOfTheTwoMiddleOnes) {
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
  EXPECT_EQ(median(std::vector<double>{4, 1, 3, 2}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(Statistics, OneSlowRoundChangesNeitherMedianNorDeviationMuch) {
  const Timing timing = timingOf(std::vector<double>{10, 11, 10, 9, 1000}, 7);
  EXPECT_EQ(timing.median, 10);
  EXPECT_EQ(timing.fastest, 9);
  EXPECT_EQ(timing.deviation, 0.1);
  EXPECT_EQ(timing.rounds, 5U);
  EXPECT_EQ(timing.draws, 7U);
}

TEST(ParetoOrder, HoldsWhatNoOtherPointBeatsInBoth) {
  const std::vector<PlotPoint> points{{0, 10, "exact", {}}, {0, 5, "slower", {}}, {1, 8, "worse and slower", {}},
                                      {2, 30, "fast", {}}, {3, 20, "beaten", {}}};
  EXPECT_EQ(paretoOrder(points), (std::vector<size_t>{0, 3}));
}

TEST(Spread, KeepsTheOrderTheSpacingAndTheBorders) {
  const std::vector<double> placed = spread({10, 11, 12, 50, 99, 99.5}, 5, 0, 100);
  for (size_t i = 1; i < placed.size(); ++i) EXPECT_GE(placed[i], placed[i - 1] + 5 - 1e-9) << i;
  EXPECT_GE(placed.front(), 0);
  EXPECT_LE(placed.back(), 100);
  EXPECT_EQ(placed[1], 11);  // the middle of three that push one another
  EXPECT_EQ(placed[3], 50);  // alone
}

TEST(ScatterPlot, HasAMarkAndALabelForEveryPointAndEscapesThem) {
  ScatterPlot plot{"title", "<subtitle>", "x", "y", {}};
  plot.points = {{0, 1e6, "a&b", Mark::Exact}, {12.5, 3e3, "second", Mark::Driver}};
  const std::string svg = svgOf(plot);
  EXPECT_NE(svg.find("a&amp;b"), std::string::npos);
  EXPECT_NE(svg.find("&lt;subtitle&gt;"), std::string::npos);
  EXPECT_NE(svg.find("class=\"Exact\""), std::string::npos);
  EXPECT_NE(svg.find("class=\"Driver\""), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace rasterdiff::harness::bench
