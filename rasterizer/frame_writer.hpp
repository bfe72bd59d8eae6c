// The end of the pipeline: fragment samples through sample mask, the shader's own, alpha to coverage and depth test into the frame's
// planes, in drawing order, and the resolve. What the values are is PieceValues' business.
#pragma once

#include <string_view>

#include "rasterizer/fragment/shader_mask.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/late_values.hpp"
#include "rasterizer/row_span.hpp"

namespace rasterdiff::rasterizer {

class FrameWriter {
 public:
  /// Allocates only the planes of `needs`. `values`: what the pieces and figures will be set up in.
  FrameWriter(const Scene& scene, const SceneNeeds& needs, const Rules& rules, std::vector<SubpixelPosition> pattern,
              const PieceValues& values, RuleCounts& counts);
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// What is written and marked from here on is of this draw.
  void beginDraw(const Draw& draw) { shaderMask_.begin(draw); }

  /// The rows between them are those of one filled triangle.
  void beginPiece(uint32_t primitive, const PieceValues& values);
  void endPiece(const PieceValues& values);

  /// Fetches what the next piece will write, from pixel x of its rows [firstRow, lastRow]; meshes are drawn in no order
  /// that memory would like. Rows have to be inside the target.
  void expect(int32_t x, int32_t firstRow, int32_t lastRow) const;

  /// One row of one piece: spans[s] are the pixels whose sample s is covered.
  void writeRow(uint32_t primitive, PieceValues& values, int32_t y, std::span<const RowSpan> spans);

  /// One row of a primitive's three-valued coverage for one sample (open rules).
  void markCoverage(int32_t y, uint32_t sample, RowSpan certain);
  void markCoverage(int32_t x, int32_t y, uint32_t sample, Coverage coverage);

  /// Resolves, where the scene asks for it, and gives the frame away.
  [[nodiscard]] Frame take(PieceValues& values);

 private:
  void addPlane(std::string_view name, uint32_t components);
  [[nodiscard]] std::span<const RowSpan> masked(std::span<const RowSpan> spans);
  [[nodiscard]] std::span<const RowSpan> keptByShader(int32_t y, std::span<const RowSpan> spans);
  /// Deliberate errors that spoil what a row is not even to write.
  void mistakeRow(const PieceValues& values, int32_t y, std::span<const RowSpan> rasterized, std::span<const RowSpan> kept);
  /// `covered` is what the shader sees, `kept` what its mask leaves of that.
  void writePixel(uint32_t primitive, PieceValues& values, int32_t x, int32_t y, std::span<const RowSpan> covered,
                  std::span<const RowSpan> kept);
  [[nodiscard]] bool alphaKeeps(const FragmentPlace& place);
  void fillCoverage(uint32_t primitive, int32_t y, std::span<const RowSpan> spans);
  void writeSample(uint32_t primitive, size_t index, const Interpolated* depth, const Interpolated* values);
  [[nodiscard]] bool passesDepth(size_t index, float fragment);

  const State state_;
  const Rules& rules_;
  const DeliberateError error_;
  const std::vector<SubpixelPosition> pattern_;
  std::vector<SubpixelPosition> depthPattern_;  ///< where depth is evaluated: at the samples
  size_t alphaComponent_ = 3;
  bool ditheredAlpha_ = false;
  RuleCounts& counts_;
  Frame frame_;
  std::optional<LateValues> late_;
  std::vector<Interpolated> values_;
  std::vector<RowSpan> masked_;
  ShaderMask shaderMask_;
  uint32_t sampleMask_ = 0;    ///< bits of the samples there are
  bool masks_ = false;         ///< some sample is masked out
  bool alpha_ = false, open_ = false, openValues_ = false, resolve_ = false;
  std::optional<ResolveMode> depthResolveMode_;
  DepthFormat depthFormat_ = DepthFormat::D32_SFLOAT;
  size_t varyings_ = 0;        ///< planes that are varyings; built-ins follow
};

}  // namespace rasterdiff::rasterizer
