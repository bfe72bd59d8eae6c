#include "rasterizer/fragment/shader_mask.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

RowSpan intersection(const RowSpan& a, const RowSpan& b) { return {std::max(a.begin, b.begin), std::min(a.end, b.end)}; }

}  // namespace

ShaderMask::ShaderMask(const Scene& scene, DeliberateError error)
    : kind_(scene.state.shaderSampleMask), shading_(sampleShading(scene)), all_((1U << scene.target.samples) - 1), error_(error) {}

std::span<const RowSpan> ShaderMask::kept(std::span<const RowSpan> covered) {
  kept_.assign(covered.begin(), covered.end());
  const uint32_t bits = mistaken(bits_);
  for (size_t s = 0; s < kept_.size(); ++s) {
    // [vk:fragops-covg] bits of samples that the invocation does not shade are ignored, so under sample shading its own
    // bit, moved by one, keeps nothing.
    const bool alone = shading_.perSample && error_ != DeliberateError::ShaderMaskOfOthers;
    if ((bits >> s & 1U) == 0 || (kind_ == ShaderSampleMask::INPUT_SHIFTED && (s == 0 || alone))) {
      kept_[s] = {};
    } else if (kind_ == ShaderSampleMask::INPUT_SHIFTED) {
      kept_[s] = intersection(covered[s], covered[s - 1]);
    }
  }
  if (error_ == DeliberateError::ShaderMaskOverrides) {
    // Where the fragment covers some sample, a bit is enough.
    RowSpan any = covered[0];
    for (const RowSpan& span : covered) {
      if (!span.empty()) any = any.empty() ? span : RowSpan{std::min(any.begin, span.begin), std::max(any.end, span.end)};
    }
    for (size_t s = 0; s < kept_.size() && kind_ == ShaderSampleMask::CONSTANT; ++s) kept_[s] = has(s) ? any : RowSpan{};
  }
  return kept_;
}

uint32_t ShaderMask::mistaken(uint32_t bits) const {
  switch (error_) {
    case DeliberateError::ShaderMaskIgnored: return all_;
    case DeliberateError::ShaderMaskShifted: return bits << 1;
    case DeliberateError::ShaderMaskOfPixel: return (bits & all_) != 0 ? all_ : 0;
    case DeliberateError::ShaderMaskBitZero: return shading_.perSample ? ((bits & 1U) != 0 ? all_ : 0) : bits;
    case DeliberateError::ShaderMaskIgnoredAtOne: return all_ == 1 ? all_ : bits;
    default: return bits;
  }
}

uint32_t ShaderMask::written(uint32_t sample, uint32_t covered) const {
  if (kind_ == ShaderSampleMask::CONSTANT) return bits_;
  return ((shading_.perSample ? 1U << sample : covered) << 1) & bits_;
}

bool ShaderMask::nominallyKeeps(uint32_t sample, uint32_t covered) const {
  return !writes() || (written(sample, covered & all_) >> sample & 1U) != 0;
}

Coverage ShaderMask::keeps(uint32_t sample, uint32_t certain, uint32_t possible) const {
  if (kind_ == ShaderSampleMask::NONE) return Coverage::In;
  if (!has(sample)) return Coverage::Out;
  if (kind_ == ShaderSampleMask::CONSTANT) return Coverage::In;
  const uint32_t before = sample == 0 ? 0 : 1U << (sample - 1);
  if ((possible & before) == 0 || (shading_.perSample && shading_.certain)) return Coverage::Out;
  return !isFree() && (certain & before) != 0 ? Coverage::In : Coverage::Either;
}

}  // namespace rasterdiff::rasterizer
