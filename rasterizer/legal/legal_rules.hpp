// Random legal renderers: the reference with a random answer to each open choice. A verdict of Differs on one of them
// under the specification's rules is a false alarm.
#pragma once

#include <string>

#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {

/// The renderer with this number and the device that it plays (Rules::limits); the same one every time.
[[nodiscard]] Rules legalRules(uint64_t seed);

/// Its answers in one line.
[[nodiscard]] std::string describe(const Rules& rules);

}  // namespace rasterdiff::rasterizer
