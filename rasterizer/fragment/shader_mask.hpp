// The mask that a fragment shader writes to SampleMask: which of a fragment's samples it keeps, before alpha to coverage and
// the depth test. What the shader reads there is BuiltInValues' business. [vk:fragops-covg]
#pragma once

#include <span>
#include <vector>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/fragment/sample_shading.hpp"
#include "rasterizer/row_span.hpp"
#include "scene/frame.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

class ShaderMask {
 public:
  explicit ShaderMask(const Scene& scene, DeliberateError error = DeliberateError::None);

  /// The shader has such an output.
  [[nodiscard]] bool writes() const { return kind_ != ShaderSampleMask::NONE; }
  /// What the mask keeps depends on which samples share an invocation, and that is not stated.
  [[nodiscard]] bool isFree() const { return kind_ == ShaderSampleMask::INPUT_SHIFTED && !shading_.certain; }

  /// Fragments from here on are those of this draw.
  void begin(const Draw& draw) { bits_ = draw.shaderSampleMaskBits; }

  /// covered[s] are the pixels of one row whose sample s one primitive covers, scissor and pSampleMask done; the answer, good
  /// until the next call, is what the nominal mask leaves of them.
  [[nodiscard]] std::span<const RowSpan> kept(std::span<const RowSpan> covered);

  /// What the invocation that shades `sample` writes, of a fragment that covers the samples `covered`.
  [[nodiscard]] uint32_t written(uint32_t sample, uint32_t covered) const;
  /// Is `sample` kept, of a fragment that covers the samples `covered`?
  [[nodiscard]] bool nominallyKeeps(uint32_t sample, uint32_t covered) const;
  /// Must it be, may it be, of one that covers it, at least the samples `certain` and at most those of `possible`?
  [[nodiscard]] Coverage keeps(uint32_t sample, uint32_t certain, uint32_t possible) const;

 private:
  [[nodiscard]] bool has(size_t sample) const { return (bits_ >> sample & 1U) != 0; }
  /// What a deliberate error makes of the written bits.
  [[nodiscard]] uint32_t mistaken(uint32_t bits) const;

  const ShaderSampleMask kind_;
  const SampleShading shading_;
  const uint32_t all_;  ///< bits of the samples there are
  const DeliberateError error_;
  uint32_t bits_ = 0;
  std::vector<RowSpan> kept_;
};

}  // namespace rasterdiff::rasterizer
