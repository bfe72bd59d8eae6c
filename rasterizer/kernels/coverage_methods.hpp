// Ways to find coverage, by name: the exact ones, and textbook ones that show what it costs to be different. The latter
// are deliberately simple and not tuned.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/kernels/coverage_mask.hpp"

namespace rasterdiff::rasterizer {

struct CoverageMethod {
  std::string name;
  std::string what;    ///< one line for people
  bool exact = false;  ///< equals the oracle in every sample of every triangle, ties included
  std::function<void(std::span<const SnappedTriangle>, CoverageMask&)> draw;  ///< adds the coverage of all triangles
};

/// All methods; the exact ones first, the fastest of them at the very front. Methods that are not exact are made for
/// vertices within ±2^14 pixels.
[[nodiscard]] const std::vector<CoverageMethod>& coverageMethods();

/// The method of that name; null if there is none.
[[nodiscard]] const CoverageMethod* coverageMethod(std::string_view name);

}  // namespace rasterdiff::rasterizer
