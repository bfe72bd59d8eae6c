// A measurement of speed against error as a table on the terminal.
#pragma once

#include <string>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness {

/// Machine, one table a load and task, then sampling and scaling; figures that people can compare by eye.
[[nodiscard]] std::string benchText(const bench::Results& results);

/// "12.3M", "450k", "7": a rate or a count in three digits.
[[nodiscard]] std::string threeDigits(double number);

/// The error of a row in words: "exact", "3.2 wrong in a million", "at most 12 ULP, mean 0.5".
[[nodiscard]] std::string errorText(const bench::Row& row);

}  // namespace rasterdiff::harness
