// A measurement of speed against error as one self-contained page: plots first, then the figures.
#pragma once

#include <string>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness {

/// Loads nothing from anywhere; light and dark; narrow screens scroll tables, not the page.
[[nodiscard]] std::string benchHtml(const bench::Results& results);

}  // namespace rasterdiff::harness
