#include "harness/compare/value_accumulator.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "harness/compare/ulp.hpp"

namespace rasterdiff::harness {
namespace {

ValueStats::Worst worstAt(const ValueAccumulator::Place& place, float expected, float actual, Bounds legal) {
  return {place.x, place.y, place.sample, place.component, expected, actual, legal.lo, legal.hi};
}

}  // namespace

void ValueAccumulator::differs(const Place& place, float expected, float actual, Bounds legal) {
  ++stats_.differing;
  if (!stats_.firstDiffering) stats_.firstDiffering = worstAt(place, expected, actual, legal);
}

void ValueAccumulator::add(const Place& place, float expected, float actual, Bounds legal) {
  ++stats_.compared;
  if (std::bit_cast<uint32_t>(expected) == std::bit_cast<uint32_t>(actual)) {
    ++stats_.same;
    return;
  }
  const double ulps = ulpDistance(expected, actual);
  if (std::isfinite(ulps)) ulpSum_ += static_cast<uint64_t>(ulps);
  if (ulps > stats_.maxUlp || !stats_.worst) {
    stats_.maxUlp = std::max(stats_.maxUlp, ulps);
    stats_.worst = worstAt(place, expected, actual, legal);
  }
  const double error = double{actual} - expected;
  if (std::isfinite(error)) stats_.maxAbs = std::max(stats_.maxAbs, std::fabs(error));
  const double reach = error > 0 ? double{legal.hi} - expected : double{expected} - legal.lo;
  if (reach > 0 && std::isfinite(error)) stats_.maxRatio = std::max(stats_.maxRatio, std::fabs(error) / reach);

  if (ulps == 0) {
    ++stats_.same;  // -0 and +0
  } else if (actual >= legal.lo && actual <= legal.hi) {
    ++stats_.allowed;
  } else {
    differs(place, expected, actual, legal);
  }
}

void ValueAccumulator::addUndrawn(const Place& place, float clear, float actual, Bounds legal) {
  if (std::bit_cast<uint32_t>(clear) == std::bit_cast<uint32_t>(actual)) return;
  const bool either = legal.lo < legal.hi && actual >= legal.lo && actual <= legal.hi;
  if (!either) differs(place, clear, actual, legal);
}

bool ValueAccumulator::addTally(const ValueTally& tally, uint64_t compared) {
  stats_.compared += compared;
  stats_.allowed += tally.allowed;
  stats_.same += compared - tally.allowed;
  ulpSum_ += tally.ulpSum;
  const bool worst = tally.maxUlp > stats_.maxUlp || (tally.unequal && !stats_.worst);
  stats_.maxUlp = std::max(stats_.maxUlp, static_cast<double>(tally.maxUlp));
  stats_.maxAbs = std::max(stats_.maxAbs, tally.maxAbs);
  stats_.maxRatio = std::max(stats_.maxRatio, tally.maxRatio);
  return worst;
}

void ValueAccumulator::setWorst(const Place& place, float expected, float actual, Bounds legal) {
  stats_.worst = worstAt(place, expected, actual, legal);
}

void ValueAccumulator::append(const ValueAccumulator& later) {
  const ValueStats& more = later.stats_;
  if (more.worst && (more.maxUlp > stats_.maxUlp || !stats_.worst)) stats_.worst = more.worst;
  if (!stats_.firstDiffering) stats_.firstDiffering = more.firstDiffering;
  stats_.compared += more.compared;
  stats_.same += more.same;
  stats_.allowed += more.allowed;
  stats_.differing += more.differing;
  stats_.maxUlp = std::max(stats_.maxUlp, more.maxUlp);
  stats_.maxAbs = std::max(stats_.maxAbs, more.maxAbs);
  stats_.maxRatio = std::max(stats_.maxRatio, more.maxRatio);
  ulpSum_ += later.ulpSum_;
}

ValueStats ValueAccumulator::take() {
  stats_.meanUlp = stats_.compared == 0 ? 0 : static_cast<double>(ulpSum_) / static_cast<double>(stats_.compared);
  return std::move(stats_);
}

}  // namespace rasterdiff::harness
