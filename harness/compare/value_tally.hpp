// Many samples and values of two frames at a time, as long as nothing about them needs an explanation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "scene/frame.hpp"

namespace rasterdiff::harness {

/// Runs are whole multiples of this many samples or values.
inline constexpr size_t kTallyStep = 16;

/// How many of `samples` samples are drawn (their primitive is not 0); none if both sides do not agree in every primitive and count.
[[nodiscard]] std::optional<uint32_t> drawnIfAlike(const uint32_t* primitives, const uint32_t* otherPrimitives, const uint32_t* counts,
                                                   const uint32_t* otherCounts, size_t samples);

/// Values of one plane.
struct ValueRun {
  const float *expected = nullptr, *actual = nullptr;
  const Bounds* legal = nullptr;
  const uint32_t* drawn = nullptr;  ///< a word a value, 0: not drawn; null: all are
  size_t values = 0;
};

/// Of the values that are not alike in every bit; in the units of ValueStats.
struct ValueTally {
  bool unequal = false;  ///< there are such values
  uint64_t allowed = 0;  ///< others than -0 for +0
  uint64_t ulpSum = 0;
  uint32_t maxUlp = 0;
  double maxAbs = 0, maxRatio = 0;
};

/// None if a value that is not alike in every bit is not drawn, not finite, or outside of its interval: that takes a
/// closer look at each.
[[nodiscard]] std::optional<ValueTally> tallyValues(const ValueRun& run);

}  // namespace rasterdiff::harness
