#include "rasterizer/methods/interpolation_methods.hpp"

namespace rasterdiff::rasterizer {

std::span<const InterpolationMethod> interpolationMethods() {
  static constexpr InterpolationMethod kMethods[] = {
      {"bilinear", "along two edges, then along the row", false, interpolateBilinear},
      {"plane", "plane equation anchored at the origin", false, interpolatePlane},
      {"plane-at-vertex", "plane equation anchored at a vertex", false, interpolatePlaneAtVertex},
      {"barycentric", "expanded line equations", false, interpolateBarycentric},
      {"barycentric-differences", "edge functions of differences", false, interpolateBarycentricDifferences},
      {"perspective", "(f/w) / (1/w) by barycentric-differences", true, interpolatePerspective},
      {"perspective-plane", "(f/w) / (1/w) by plane", true, interpolatePerspectivePlane},
      {"affine", "barycentric-differences, w ignored", true, interpolateBarycentricDifferences},
  };
  return kMethods;
}

}  // namespace rasterdiff::rasterizer
