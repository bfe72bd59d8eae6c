// Values that wait: where depth is only rounded and inputs are evaluated at the pixel's centre, a sample needs no values that
// a later triangle replaces. While drawing, a sample keeps the number of its piece; in the end the planes of that piece
// give its inputs and all bounds. The frame and all counts are those of drawing at once.
#pragma once

#include "rasterizer/interpolation.hpp"
#include "rasterizer/row_span.hpp"

namespace rasterdiff::rasterizer {

class LateValues {
 public:
  /// May the values of this scene wait?
  [[nodiscard]] static bool serve(const Scene& scene, const SceneNeeds& needs, const PieceValues& values);

  /// All of them must outlive this object; `pattern`: sample offsets in 1/256 pixel; `widen`: what a primitive's earlier
  /// pieces made legal at a sample stays legal.
  LateValues(const State& state, std::span<const SubpixelPosition> pattern, bool widen, Frame& frame, RuleCounts& counts);

  /// The rows that follow are those of one piece, for which `values` is set up.
  void begin(uint32_t primitive, const PieceValues& values);
  /// spans[s] are the pixels whose sample s is covered.
  void writeRow(int32_t y, std::span<const RowSpan> spans);
  void end(const PieceValues& values);

  /// Evaluates what waits. The frame's primitive plane holds primitives from here on.
  void settle(PieceValues& values);

 private:
  struct Hidden {
    size_t sample;
    uint32_t piece;
  };

  template <class Passes>
  void drawSpans(int32_t y, std::span<const RowSpan> spans, Passes passes);
  /// kStride: number of samples, 0 if it is not known when compiling.
  template <size_t kStride, class Passes>
  void drawSpan(int32_t y, uint32_t sample, RowSpan span, Passes passes);
  void drawSpanUndeep(int32_t y, uint32_t sample, RowSpan span);
  void rememberHidden(size_t first, int32_t length, size_t stride);
  void restore(PieceValues& values, uint32_t piece);
  void widenHidden(PieceValues& values);
  /// Calls write(value, bounds, input) for each component of the sample's varyings; the inputs are those evaluated last.
  template <class Write>
  void forEachInput(size_t sample, Write write);
  [[nodiscard]] bool writesDepth() const;
  [[nodiscard]] Bounds depthBounds(const PieceValues& values, size_t x, size_t y, size_t sample) const;

  const State& state_;
  const std::span<const SubpixelPosition> pattern_;
  const bool widen_;
  Frame& frame_;
  RuleCounts& counts_;
  std::vector<Interpolated> inputs_;
  std::vector<uint32_t> primitives_;    ///< of piece n, at n - 1
  std::vector<LinearFunction> planes_;  ///< of all pieces, piece by piece
  std::vector<float> constants_;
  std::vector<Hidden> hidden_;          ///< samples that another piece of the same primitive had before
  LinearFunction depth_;                ///< of the piece begun
  uint32_t piece_ = 0, restored_ = 0, firstOfPrimitive_ = 0;
  bool written_ = false;
};

}  // namespace rasterdiff::rasterizer
