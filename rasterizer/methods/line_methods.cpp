#include "rasterizer/methods/line_methods.hpp"

#include <limits>

#include "rasterizer/methods/diamond_exit.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr PixelArea kEverywhere = {std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::min(),
                                   std::numeric_limits<int32_t>::max(), std::numeric_limits<int32_t>::max()};

}  // namespace

std::vector<PixelIndex> drawLineDiamondVulkan(SubpixelPosition a, SubpixelPosition b) {
  return diamondExitPixels(a, b, DiamondRule::Vulkan, kEverywhere);
}

std::vector<PixelIndex> drawLineDiamondDirect3D11(SubpixelPosition a, SubpixelPosition b) {
  return diamondExitPixels(a, b, DiamondRule::Direct3D11, kEverywhere);
}

std::span<const LineMethod> lineMethods() {
  static constexpr LineMethod kMethods[] = {
      {"four-octant", "lecture, four cases of the slope", drawLineFourOctants},
      {"long-axis", "lecture, one loop over the longer axis", drawLineLongAxis},
      {"long-axis-trimmed", "the same without end pixels whose diamond holds the end", drawLineLongAxisTrimmed},
      {"diamond-exit-vulkan", "integers, both ends moved by -(ε, ε²)", drawLineDiamondVulkan},
      {"diamond-exit-d3d11", "integers, Direct3D 11's diamond", drawLineDiamondDirect3D11},
  };
  return kMethods;
}

}  // namespace rasterdiff::rasterizer
