// The inputs of a band's samples: planes of the pieces that are seen, made as PieceValues makes them, and evaluated run by run when
// the band is drawn. What of it waits so long, and why it may, says late_values.hpp.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rasterizer/geometry_parts.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/kernel_pieces.hpp"
#include "rasterizer/kernels/settle_inputs.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

class KernelInputs {
 public:
  /// All that is given must outlive this object; the planes of `frame` are zero where nothing is drawn.
  KernelInputs(const Scene& scene, const SceneNeeds& needs, const Rules& rules, const KernelGeometry& geometry, Frame& frame);

  /// Forgets all pieces.
  void clear();
  /// Appends the planes of one piece of a primitive: depth first, where there is one.
  void add(uint32_t primitive, uint8_t place);
  [[nodiscard]] std::span<const LinearFunction> planes() const { return planes_; }
  [[nodiscard]] size_t planesEach() const { return planesEach_; }

  /// Writes row y of all inputs of one sample: runs without a plane are left as they are. `numbers` of this sample and of the first one
  /// say where both are drawn by one piece: there the values are those of the first sample, which has been settled.
  void settle(std::span<const SettledRun> runs, uint32_t y, uint32_t sample, const uint32_t* numbers, const uint32_t* firstNumbers);

 private:
  /// Of the runs, the parts that the first sample has not; the others are copied.
  void copyFromFirst(std::span<const SettledRun> runs, uint32_t y, uint32_t sample, const uint32_t* numbers, const uint32_t* firstNumbers);

  const KernelGeometry& geometry_;
  Frame& frame_;
  PieceValues values_;
  RuleCounts ignored_;  // geometry counted already
  std::vector<std::unique_ptr<PrimitiveMaker>> makers_;  // a draw each
  uint8_t place_ = 0;  // of the piece being made
  std::vector<ValueKind> kinds_;
  const bool anywhere_;
  size_t planesEach_ = 0, reciprocalW_ = 0;
  std::vector<LinearFunction> planes_;
  std::vector<float> constants_;
  std::vector<InputRow> rows_;
  std::vector<SettledRun> own_;
};

}  // namespace rasterdiff::rasterizer
