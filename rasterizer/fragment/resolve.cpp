#include "rasterizer/fragment/resolve.hpp"

#include <array>

namespace rasterdiff::rasterizer {
namespace {

// `at(i)`: sample i. All of these are monotonic in every sample, so that bounds go through them like values.
template <class At>
float meanBy(ResolveArithmetic arithmetic, size_t n, const At& at) {
  const float scale = 1.0F / static_cast<float>(n);
  if (arithmetic == ResolveArithmetic::InOrder) {
    float sum = at(0);
    for (size_t i = 1; i < n; ++i) sum += at(i);
    return sum * scale;
  }
  if (arithmetic == ResolveArithmetic::Pairwise) {
    std::array<float, 16> sums{};
    for (size_t i = 0; i < n; ++i) sums[i] = at(i);
    for (size_t left = n; left > 1; left /= 2) {
      for (size_t i = 0; i < left / 2; ++i) sums[i] = sums[2 * i] + sums[2 * i + 1];
    }
    return sums[0] * scale;
  }
  double sum = 0;
  for (size_t i = 0; i < n; ++i) sum += double{at(i)};
  return static_cast<float>(sum / static_cast<double>(n));
}

}  // namespace

Interpolated meanOf(std::span<const float> values, std::span<const Bounds> bounds, size_t stride,
                    ResolveArithmetic arithmetic) {
  const size_t n = (values.size() + stride - 1) / stride;
  if (arithmetic != ResolveArithmetic::Any) {
    return {meanBy(arithmetic, n, [&](size_t i) { return values[i * stride]; }),
            {meanBy(arithmetic, n, [&](size_t i) { return bounds[i * stride].lo; }),
             meanBy(arithmetic, n, [&](size_t i) { return bounds[i * stride].hi; })}};
  }
  double sum = 0, lo = 0, hi = 0, magnitude = 0;
  for (size_t i = 0; i < values.size(); i += stride) {
    sum += double{values[i]};
    lo += double{bounds[i].lo};
    hi += double{bounds[i].hi};
    magnitude += std::max(std::fabs(double{bounds[i].lo}), std::fabs(double{bounds[i].hi}));
  }
  const auto count = static_cast<double>(n);
  // n - 1 sums and a division, each within 2^-24 of at most the sum of magnitudes; scaled first, n products more.
  const double rounding = n == 1 ? 0 : (2 * count) * kHalfUlp * magnitude / count;
  return toFloat({sum / count, lo / count - rounding, hi / count + rounding});
}

namespace {

// Deliberate errors; `samples` holds a value every `stride`.
float mistakenMean(std::span<const float> samples, size_t stride, float mean, DeliberateError error) {
  const size_t n = (samples.size() + stride - 1) / stride;
  const auto count = static_cast<float>(n);
  switch (error) {
    case DeliberateError::ResolveSampleZero: return samples[0];
    case DeliberateError::ResolveDropsLast: return (mean * count - samples[(n - 1) * stride]) / (count - 1);
    case DeliberateError::ResolveEightBits: return std::nearbyint(mean * 255) / 255;
    default: return mean;
  }
}

}  // namespace

VaryingPlane resolved(const VaryingPlane& plane, const Rules& rules, RuleCounts& counts) {
  const Plane<float>& values = plane.values;
  const uint32_t components = values.components;
  VaryingPlane result{plane.name, Plane<float>(values.width, values.height, 1, components), std::nullopt};
  result.bounds.emplace(values.width, values.height, 1, components);
  const size_t pixels = size_t{values.width} * values.height, perPixel = size_t{values.samples} * components;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    bool differ = false;
    for (size_t c = 0; c < components; ++c) {
      const size_t first = pixel * perPixel + c, count = perPixel - c;
      const std::span<const float> samples = std::span(values.data).subspan(first, count);
      const Interpolated mean = meanOf(samples, std::span(plane.bounds->data).subspan(first, count), components,
                                       rules.choices.resolveArithmetic);
      result.values.data[pixel * components + c] = mistakenMean(samples, components, mean.value, rules.error);
      result.bounds->data[pixel * components + c] = mean.bounds;
      for (size_t s = components; s < count; s += components) differ = differ || samples[s] != samples[0];
    }
    if (differ) ++counts[Rule::Resolve];
  }
  return result;
}

}  // namespace rasterdiff::rasterizer
