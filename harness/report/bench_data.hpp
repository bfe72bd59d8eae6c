// A measurement of speed against error for programs: JSON (bench.schema.json describes it) and CSV.
#pragma once

#include <string>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string benchJson(const bench::Results& results);

/// One line a row of every load, with a head; RFC 4180. Empty where there is no figure.
[[nodiscard]] std::string benchCsv(const bench::Results& results);

}  // namespace rasterdiff::harness
