// Ways to find primitive index, overdraw count, depth and varyings, by name, with what each needs.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

struct ValueMethod {
  std::string name;
  std::string what;      ///< one line for people
  bool exact = false;    ///< coverage, and with it index and count, equal the oracle's wherever the depth test agrees
  bool rounded = false;  ///< values are the nearest float32: the yardstick of the others
  std::function<void(const ValueTriangles&, ValueTarget&)> draw;  ///< into the planes that the target has
};

/// All methods; the fastest exact one first, the oracle last. All take every ValueNeeds.
[[nodiscard]] const std::vector<ValueMethod>& valueMethods();

/// The method of that name; null if there is none.
[[nodiscard]] const ValueMethod* valueMethod(std::string_view name);

}  // namespace rasterdiff::rasterizer
