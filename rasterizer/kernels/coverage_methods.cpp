// The table of coverage methods.
#include "rasterizer/kernels/coverage_methods.hpp"

#include <algorithm>

#include "rasterizer/kernels/coverage_oracle.hpp"
#include "rasterizer/kernels/integer_spans.hpp"
#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer {

const std::vector<CoverageMethod>& coverageMethods() {
  using Triangles = methods::Triangles;
  static const std::vector<CoverageMethod> all = {
      {"spans", "exact spans, SIMD", true, [](Triangles t, CoverageMask& m) { drawCoverage(t, m); }},
      {"hierarchical", "int64 edge functions, 8x8 blocks left out or filled by their corners", true, methods::hierarchical},
      {"block-hierarchy", "int64 edge functions, blocks of 64, 16 and 4 pixels left out or filled", true, methods::blockHierarchy},
      {"block-parallel", "int64 edge functions, all samples of 8x8 blocks", true, methods::blockParallel},
      {"integer-spans", "spans by 128-bit division", true,
       [](Triangles triangles, CoverageMask& m) {
         for (const SnappedTriangle& t : triangles) drawIntegerSpans(t, m);
       }},
      {"bounding-box", "int64 edge functions at every sample of the box: the oracle", true, drawCoverageOracle},
      {"cross-products", "three cross products, either winding, no tie rule", false, methods::threeCrossProducts},
      {"edge-double", "edge functions in double", false, methods::edgeFunctionsDouble},
      {"edge-float", "edge functions in float", false, methods::edgeFunctionsFloat},
      {"incremental-double", "edge functions stepped in double", false, methods::incrementalDouble},
      {"incremental-float", "edge functions stepped in float", false, methods::incrementalFloat},
      {"incremental-fixed", "edge functions stepped in fixed point, 1/16 pixel", false, methods::incrementalFixed},
      {"edge-walking", "trapezoids with stepped float ends", false, methods::edgeWalking},
  };
  return all;
}

const CoverageMethod* coverageMethod(std::string_view name) {
  const auto found = std::ranges::find(coverageMethods(), name, &CoverageMethod::name);
  return found == coverageMethods().end() ? nullptr : &*found;
}

}  // namespace rasterdiff::rasterizer
