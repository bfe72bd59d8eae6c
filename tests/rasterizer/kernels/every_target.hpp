// A test on every instruction set of this machine.
#pragma once

#include <gtest/gtest.h>

#include <hwy/targets.h>

namespace rasterdiff::rasterizer::testing {

/// Runs `test` once for each instruction set that was built and is here.
template <class F>
void onEveryTarget(const F& test) {
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace rasterdiff::rasterizer::testing
