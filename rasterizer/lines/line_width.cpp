#include "rasterizer/lines/line_width.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kWidest = 1 << 16;  // pixels; more than any target needs

int64_t nearest(double value) { return static_cast<int64_t>(std::floor(value + 0.5)); }

double sane(float width) { return width > 0 ? std::min<double>(width, kWidest) : 0; }

}  // namespace

LineWidth lineWidth(float width, const Limits& limits) {
  const double requested = sane(width), lowest = limits.lineWidthMin, highest = limits.lineWidthMax;
  const double granularity = limits.lineWidthGranularity;
  double supported = std::clamp(requested, lowest, highest);
  if (granularity > 0) {
    supported = std::min(highest, lowest + granularity * std::floor((supported - lowest) / granularity + 0.5));
  } else if (highest == lowest) {
    supported = lowest;
  }
  const double distance = std::fabs(supported - requested);
  LineWidth result;
  result.nominal = std::max<int64_t>(1, nearest(supported * LineWidth::kUnit));
  const double low = std::min(requested - distance, supported), high = std::max(requested + distance, supported);
  result.narrowest = std::clamp<int64_t>(static_cast<int64_t>(std::floor(low * LineWidth::kUnit)), 0, result.nominal);
  result.widest = std::max(result.nominal, static_cast<int64_t>(std::ceil(high * LineWidth::kUnit)));
  return result;
}

BresenhamWidth bresenhamWidth(float width, const Limits& limits) {
  const int64_t lowest = nearest(limits.lineWidthMin), highest = nearest(limits.lineWidthMax);
  const auto actual = [&](int64_t rounded) {
    return std::max<int64_t>(1, std::clamp(rounded, lowest, std::max(lowest, highest)));
  };
  const double requested = sane(width), below = std::floor(requested);
  BresenhamWidth result;
  result.nominal = result.other = actual(nearest(requested));
  if (requested - below == 0.5) result.other = actual(static_cast<int64_t>(below));
  return result;
}

}  // namespace rasterdiff::rasterizer
