// How many distances a depth buffer tells apart, against a depth that is spread by the logarithm of the distance: what
// the ratio of far to near plane costs, conventional and reversed. (lecture "Near, Far and Depth Precision")
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "rasterizer/depth/format.hpp"
#include "rasterizer/methods/measure_row.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint32_t kSteps = 16384;  // distances from near (1) to far (the ratio), evenly by their logarithm

/// Depth of distance z under a perspective projection with near plane 1, as a float32 vertex attribute.
float depthOf(double z, double ratio, bool reversed) {
  return static_cast<float>(reversed ? (ratio - z) / (z * (ratio - 1)) : ratio * (z - 1) / (z * (ratio - 1)));
}

MethodRow measure(double ratio, bool reversed, DepthFormat format, const char* name) {
  std::vector<float> depths;
  for (uint32_t i = 0; i < kSteps; ++i) {
    const float depth = depthOf(std::pow(ratio, (i + 0.5) / kSteps), ratio, reversed);
    depths.push_back(stored({depth, depth, depth}, format).value);
  }
  ErrorSum errors;
  uint64_t lost = 0;
  for (uint32_t begin = 0, end = 0; begin < kSteps; begin = end) {
    while (end < kSteps && depths[end] == depths[begin]) ++end;
    for (uint32_t i = begin; i < end; ++i) errors.add(end - begin - 1);
    lost += end - begin - 1;
  }
  return measuredRow("depth", fmt::format("{} {}", name, reversed ? "reversed" : "conventional"), ratio > 1e4,
                     fmt::format("far = {:.0e} near", ratio), errors, lost);
}

}  // namespace

void measureDepth(std::vector<MethodRow>& rows) {
  using enum DepthFormat;
  struct Format {
    DepthFormat format;
    const char* name;
  };
  for (const Format& format : {Format{D16_UNORM, "D16_UNORM"}, {X8_D24_UNORM_PACK32, "X8_D24_UNORM_PACK32"}, {D32_SFLOAT, "D32_SFLOAT"}}) {
    for (const bool reversed : {false, true}) {
      for (int exponent = 1; exponent <= 7; ++exponent) {
        rows.push_back(measure(std::pow(10.0, exponent), reversed, format.format, format.name));
      }
    }
  }
}

}  // namespace rasterdiff::rasterizer
