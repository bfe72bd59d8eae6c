// A row of the method table out of summed errors.
#pragma once

#include <utility>

#include "rasterizer/methods/error_sum.hpp"
#include "rasterizer/methods/method_table.hpp"

namespace rasterdiff::rasterizer {

[[nodiscard]] inline MethodRow measuredRow(std::string family, std::string method, bool hard, std::string inputs,
                                           const ErrorSum& errors, uint64_t wrongSamples) {
  return {std::move(family), std::move(method), hard,          std::move(inputs), errors.cases,
          wrongSamples,      errors.max,        errors.mean(), errors.rms()};
}

}  // namespace rasterdiff::rasterizer
