// Mutants of a device that offers everything the reference draws, in this process.
#pragma once

#include <string>

#include "harness/subject.hpp"
#include "rasterizer/mistakes/played_device.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff {

inline Limits generousLimits() { return rasterizer::playedDevice(rasterizer::DeliberateError::None); }

class ReferenceWith final : public harness::Subject {
 public:
  explicit ReferenceWith(rasterizer::DeliberateError error)
      : rules_(*rasterizer::Rules::profile("reference", rasterizer::playedDevice(error))) {
    rules_.error = error;
  }
  std::string name() const override { return "mutant"; }
  std::string info() const override { return {}; }
  const Limits& limits() const override { return rules_.limits; }
  Result<Frame> render(const Scene& scene) override { return rasterizer::render(scene, rules_); }

 private:
  rasterizer::Rules rules_;
};

}  // namespace rasterdiff
