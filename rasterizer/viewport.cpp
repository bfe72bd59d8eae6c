#include "rasterizer/viewport.hpp"

#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kHalfUlp = 0x1p-24;  // relative rounding error of float32

bool isFloat(double value) { return static_cast<double>(static_cast<float>(value)) == value; }

// May a driver that keeps `bits` fractional bits of the viewport's bounds move this one?
bool isOnViewportGrid(double bound, uint32_t bits) {
  const double scaled = std::ldexp(bound, static_cast<int>(bits));
  return scaled == std::nearbyint(scaled);
}

}  // namespace

ViewportTransform viewportTransform(const Viewport& viewport, bool negativeOneToOne, uint32_t bits) {
  ViewportTransform transform;
  transform.x = {viewport.width * 0.5, viewport.x, viewport.width * 0.5};
  transform.y = {viewport.height * 0.5, viewport.y, viewport.height * 0.5};
  const double minDepth = viewport.minDepth, maxDepth = viewport.maxDepth;
  if (negativeOneToOne) {
    transform.z = {(maxDepth - minDepth) * 0.5, minDepth * 0.5, maxDepth * 0.5};
  } else {
    transform.z = {maxDepth - minDepth, minDepth, 0};
  }
  const bool onGrid = isOnViewportGrid(viewport.x, bits) && isOnViewportGrid(viewport.y, bits) &&
                      isOnViewportGrid(double{viewport.x} + viewport.width, bits) &&
                      isOnViewportGrid(double{viewport.y} + viewport.height, bits);
  transform.boundsUncertainty = onGrid ? 0 : std::ldexp(1.0, -static_cast<int>(bits));
  return transform;
}

FramebufferPosition toFramebuffer(const double clip[4], const ViewportTransform& transform) {
  const auto map = [&](int i, const ViewportAxis& axis) { return clip[i] * axis.scale / clip[3] + axis.offset(); };
  return {map(0, transform.x), map(1, transform.y), map(2, transform.z)};
}

float toFramebufferFloat(float coordinate, float w, const ViewportAxis& axis, ViewportArithmetic arithmetic, float origin) {
  const float scale = static_cast<float>(axis.scale);
  float offset = static_cast<float>(axis.centre) + static_cast<float>(axis.origin);
  if (origin != 0) offset -= origin;
  const bool divides = arithmetic == ViewportArithmetic::Float32Division || arithmetic == ViewportArithmetic::Float32DivisionFma;
  const bool fuses = arithmetic == ViewportArithmetic::Float32Fma || arithmetic == ViewportArithmetic::Float32DivisionFma;
  const float reciprocal = 1.0F / w;
  const float ndc = divides ? coordinate / w : coordinate * reciprocal;
  return fuses ? std::fma(ndc, scale, offset) : ndc * scale + offset;
}

double viewportArithmeticBound(float coordinate, float w, const ViewportAxis& axis) {
  const double ndc = double{coordinate} / w;
  const double scaled = ndc * axis.scale;
  const double offset = axis.offset();
  const double result = scaled + offset;
  int exponent = 0;
  const bool powerOfTwo = std::fabs(std::frexp(w, &exponent)) == 0.5;
  if (powerOfTwo && isFloat(ndc) && isFloat(scaled) && isFloat(axis.scale) && isFloat(offset) && isFloat(result) &&
      isFloat(result - 0.5)) {
    return 0;
  }
  // 1/w, x·(1/w), ·scale: three roundings of |scaled|; the offset: one; the sum and the sum less a half: one each.
  return kHalfUlp * (3 * std::fabs(scaled) + std::fabs(offset) + 2 * std::fabs(result) + 1);
}

}  // namespace rasterdiff::rasterizer
