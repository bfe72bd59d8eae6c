// The end of the pipeline: fragment samples into the frame's planes, through the depth test, in drawing order.
#pragma once

#include "rasterizer/interpolation.hpp"
#include "rasterizer/row_span.hpp"

namespace rasterdiff::rasterizer {

class FrameWriter {
 public:
  /// Allocates only the planes of `needs`.
  FrameWriter(const Scene& scene, const SceneNeeds& needs, const Rules& rules, std::vector<SubpixelPosition> pattern,
              RuleCounts& counts);

  /// One row of one piece: spans[s] are the pixels whose sample s is covered.
  void writeRow(uint32_t primitive, const PieceValues& values, int32_t y, std::span<const RowSpan> spans);

  /// One row of a primitive's three-valued coverage for one sample (open rules).
  void markCoverage(int32_t y, uint32_t sample, RowSpan certain);
  void markCoverage(int32_t x, int32_t y, uint32_t sample, Coverage coverage);

  [[nodiscard]] Frame take() { return std::move(frame_); }

 private:
  void fillCoverage(uint32_t primitive, int32_t y, std::span<const RowSpan> spans);
  void writeSample(uint32_t primitive, size_t index, const Interpolated* depth, const Interpolated* values);
  [[nodiscard]] bool passesDepth(size_t index, float fragment);

  const State state_;
  const DeliberateError error_;
  const std::vector<SubpixelPosition> pattern_;
  RuleCounts& counts_;
  Frame frame_;
  std::vector<Interpolated> values_;
};

}  // namespace rasterdiff::rasterizer
