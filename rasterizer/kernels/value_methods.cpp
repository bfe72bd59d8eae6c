// The table of value methods.
#include "rasterizer/kernels/value_methods.hpp"

#include <algorithm>

#include "rasterizer/kernels/value_kernel.hpp"
#include "rasterizer/kernels/value_oracle.hpp"

namespace rasterdiff::rasterizer {

const std::vector<ValueMethod>& valueMethods() {
  static const std::vector<ValueMethod> all = {
      {"value-spans", "exact spans, planes in double precision, varyings once a visible sample, SIMD", true, false,
       [](const ValueTriangles& t, ValueTarget& target) { drawValues(t, target); }},
      {"value-oracle", "int64 edge functions at every sample of the box, values in 113 bits", true, true, drawValuesOracle},
  };
  return all;
}

const ValueMethod* valueMethod(std::string_view name) {
  const auto found = std::ranges::find(valueMethods(), name, &ValueMethod::name);
  return found == valueMethods().end() ? nullptr : &*found;
}

}  // namespace rasterdiff::rasterizer
