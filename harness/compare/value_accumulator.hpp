// Error statistics of one value plane, sample by sample.
#pragma once

#include <string>

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
  /// As many values that are alike in every bit.
  void addSame(uint64_t count) {
    stats_.compared += count;
    stats_.same += count;
  }
  /// A value where neither side drew: the driver has to leave the clear value, which in a fixed-point attachment may be
  /// either of two.
  void addUndrawn(const Place& place, float clear, float actual, Bounds legal);

  [[nodiscard]] ValueStats take();

 private:
  void differs(const Place& place, float expected, float actual, Bounds legal);

  ValueStats stats_;
  double ulpSum_ = 0;
};

}  // namespace rasterdiff::harness
