// Error statistics of one value plane, sample by sample.
#pragma once

#include <string>

#include "harness/compare/value_tally.hpp"
#include "harness/compare/verdict.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::harness {

class ValueAccumulator {
 public:
  explicit ValueAccumulator(std::string name) { stats_.name = std::move(name); }

  struct Place {
    uint32_t x = 0, y = 0, sample = 0, component = 0;
  };
  /// A value where both sides drew the same primitive.
  void add(const Place& place, float expected, float actual, Bounds legal);
  /// `compared` drawn values at once. True: the largest distance so far is among them, and has to be told by setWorst().
  [[nodiscard]] bool addTally(const ValueTally& tally, uint64_t compared);
  void setWorst(const Place& place, float expected, float actual, Bounds legal);
  /// A value where neither side drew: the driver has to leave the clear value, which in a fixed-point attachment may be
  /// either of two.
  void addUndrawn(const Place& place, float clear, float actual, Bounds legal);

  /// Adds what another one gathered of later values.
  void append(const ValueAccumulator& later);

  [[nodiscard]] ValueStats take();

 private:
  void differs(const Place& place, float expected, float actual, Bounds legal);

  ValueStats stats_;
  uint64_t ulpSum_ = 0;  ///< distances below 2^32: exact, in whatever order they are added
};

}  // namespace rasterdiff::harness
