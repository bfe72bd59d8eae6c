// The planes of the value kernels; drawing is in value_kernel.cpp.
#include "rasterizer/kernels/value_target.hpp"

#include <algorithm>
#include <bit>

namespace rasterdiff::rasterizer {

ValueRows<float> carriedValues(std::span<const float> reciprocalW, std::span<const float> values, size_t components) {
  ValueRows<float> carried(reciprocalW.size() / 3 * carriedSize(components));
  float* to = carried.data();
  for (size_t t = 0; t < reciprocalW.size() / 3; ++t, to += carriedSize(components)) {
    std::copy_n(reciprocalW.data() + 3 * t, 3, to);
    std::copy_n(values.data() + 3 * components * t, 3 * components, to + kBeforeValues);
  }
  return carried;
}

Result<ValueTarget> ValueTarget::create(uint32_t width, uint32_t height, uint32_t samples, ValueNeeds needs) {
  constexpr uint32_t kLargest = 16384;
  if (width == 0 || height == 0 || width > kLargest || height > kLargest)
    return fail(ErrorCode::BadInput, "value planes", "width and height must be 1 to 16384 pixels");
  if (needs.components > kMaxValueComponents || (needs.components > 0 && !needs.primitive))
    return fail(ErrorCode::BadInput, "value planes", "varyings need a primitive plane and are at most 16 components");
  const auto locations = standardSampleLocations(samples);
  if (locations.empty())
    return fail(ErrorCode::NotOffered, "value planes", "no standard sample locations for this sample count",
                "use 1, 2, 4, 8 or 16 samples");
  return ValueTarget(width, height, locations, needs);
}

ValueTarget::ValueTarget(uint32_t width, uint32_t height, std::span<const SampleLocation> locations, ValueNeeds needs)
    : width_(width), height_(height), locations_(locations), needs_(needs) {
  const size_t size = stride() * height * locations.size();
  if (needs.primitive) primitive.resize(size);
  if (needs.count) count.resize(size);
  if (needs.depth) depth.resize(size, 1.0F);
  varyings.resize(needs.components);
  for (ValueRows<float>& plane : varyings) plane.resize(size);
}

void ValueTarget::clear() {
  // Varyings first: what is drawn into next is then what the caches hold.
  for (ValueRows<float>& plane : varyings) std::ranges::fill(plane, 0.0F);
  std::ranges::fill(count, 0);
  std::ranges::fill(primitive, 0);
  std::ranges::fill(depth, 1.0F);
}

uint64_t ValueTarget::differing(const ValueTarget& other) const {
  uint64_t sum = 0;
  for (uint32_t row = 0; row < height_ * samples(); ++row)
    for (size_t i = row * stride(); i < row * stride() + width_; ++i) {
      const bool same = (!needs_.primitive || primitive[i] == other.primitive[i]) && (!needs_.count || count[i] == other.count[i]) &&
                        (!needs_.depth || std::bit_cast<uint32_t>(depth[i]) == std::bit_cast<uint32_t>(other.depth[i]));
      sum += same ? 0 : 1;
    }
  return sum;
}

}  // namespace rasterdiff::rasterizer
