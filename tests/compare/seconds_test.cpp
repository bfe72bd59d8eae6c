// Times of several rounds.
#include "harness/compare/seconds.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rasterdiff::harness {
namespace {

TEST(Seconds, OfSeveralRoundsAreTheMedianOfEachPart) {
  std::array<Seconds, 3> rounds{};
  rounds[0] = {.reference = 3, .driver = 10, .compare = 1, .parts = {.drawing = 9, .readback = 1}};
  rounds[1] = {.reference = 1, .driver = 4, .compare = 2, .parts = {.drawing = 2, .readback = 2}};
  rounds[2] = {.reference = 2, .driver = 5, .compare = 9, .parts = {.drawing = 3, .readback = 2}};
  const Seconds median = medianOf(rounds);
  EXPECT_EQ(median.reference, 2);
  EXPECT_EQ(median.driver, 5);
  EXPECT_EQ(median.compare, 2);
  EXPECT_EQ(median.parts.drawing, 3);
  EXPECT_EQ(median.parts.readback, 2);
}

TEST(Seconds, OfTwoRoundsAreTheirMean) {
  const std::array<Seconds, 2> rounds{Seconds{.reference = 1}, Seconds{.reference = 2}};
  EXPECT_EQ(medianOf(rounds).reference, 1.5);
}

}  // namespace
}  // namespace rasterdiff::harness
