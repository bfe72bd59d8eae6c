// Where the time went, in words.
#pragma once

#include <string>

#include "harness/compare/seconds.hpp"

namespace rasterdiff::harness {

/// "driver 10.2 s (drawing 5.10 s, pipelines 2.90 s, upload 1.10 s, readback 1.10 s), reference 1.71 s, compare 0.41 s, set-up 0.10 s"
[[nodiscard]] std::string timeText(const Seconds& seconds);

/// "All but the driver's drawing and pipelines 2.20 s, 0.43 times its drawing"; what it shows is what a faster harness could save.
[[nodiscard]] std::string shareText(const Seconds& seconds);

}  // namespace rasterdiff::harness
