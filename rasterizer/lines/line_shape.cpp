#include "rasterizer/lines/line_shape.hpp"

#include "rasterizer/lines/line_band.hpp"
#include "rasterizer/lines/line_coverage.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// A band with the place where it can be anything but Out.
struct PlacedBand {
  std::unique_ptr<LineBand> band;
  std::optional<LineReach> reach;

  PlacedBand() = default;
  PlacedBand(const RasterVertex& a, const RasterVertex& b, const LineStyle& style, const Rules& rules)
      : band(lineBand(a, b, style, rules)) {
    if (band) reach.emplace(a.snapped, b.snapped, band->reach());
  }
  [[nodiscard]] Shape::Rows rows() const { return reach ? reach->rows() : Shape::Rows{}; }
  [[nodiscard]] RowSpan columns(int32_t y) const { return reach ? reach->columns(y) : RowSpan{}; }
  [[nodiscard]] BandVerdict classify(int64_t px, int64_t py) const {
    const RowSpan span = columns(static_cast<int32_t>(py >> kSubpixelBits));
    const auto x = static_cast<int32_t>(px >> kSubpixelBits);
    return x >= span.begin && x < span.end ? band->classify(px, py) : BandVerdict{};
  }
};

class LineShape final : public Shape {
 public:
  LineShape(const LineEnds& ends, std::unique_ptr<LineCoverage> nominal, PlacedBand cut,
            std::optional<PlacedBand> uncut)
      : nominal_(std::move(nominal)), cut_(std::move(cut)), uncut_(std::move(uncut)) {
    if (nominal_) reach_.emplace(ends.a.snapped, ends.b.snapped, nominal_->reach());
  }

  Rows rows() const override {
    Rows rows = cut_.rows();
    if (reach_) rows = both(rows, reach_->rows());
    if (uncut_) rows = both(rows, uncut_->rows());
    return rows;
  }

  RowSpan columns(int32_t y) const override {
    RowSpan span = cut_.columns(y);
    if (reach_) span = both(span, reach_->columns(y));
    if (uncut_) span = both(span, uncut_->columns(y));
    return span;
  }

  bool covers(int64_t px, int64_t py, bool& tie) const override {
    tie = false;
    return nominal_ && nominal_->covers(px, py, tie);
  }

  std::optional<RowCoverage> coverRow(int32_t y, SubpixelPosition offset, RowSpan columns) const override {
    return nominal_ ? nominal_->coverRow(y, offset, columns) : RowCoverage{};
  }

  bool classifiesPixels() const override {
    return (cut_.band || uncut_) && (!cut_.band || cut_.band->classifiesPixels()) && (!uncut_ || uncut_->band->classifiesPixels());
  }

  ShapeFacts facts(int64_t px, int64_t py) const override { return nominal_ ? nominal_->facts(px, py) : ShapeFacts{}; }

  BandVerdict classify(int64_t px, int64_t py) const override {
    if (!cut_.band && !uncut_) {
      bool tie = false;
      return {covers(px, py, tie) ? Coverage::In : Coverage::Out, Freedom::None, std::nullopt};
    }
    const BandVerdict verdict = cut_.classify(px, py);
    return uncut_ ? eitherOf(verdict, uncut_->classify(px, py), Freedom::LineClip) : verdict;
  }

 private:
  std::unique_ptr<LineCoverage> nominal_;
  std::optional<LineReach> reach_;  ///< of the nominal coverage
  PlacedBand cut_;                  ///< no band under closed rules
  std::optional<PlacedBand> uncut_;
};

}  // namespace

FloatPosition floatPosition(const VertexStage& stage, const ClipVertex& vertex) {
  const Choices& choices = stage.rules.choices;
  const bool exact = choices.viewportArithmetic == ViewportArithmetic::Exact;
  // A vertex that clipping made is mapped outside the vertex stage, without fused operations.
  const ViewportArithmetic arithmetic = vertex.made ? ViewportArithmetic::Float32 : choices.viewportArithmetic;
  const auto w = static_cast<float>(vertex.position[3]);
  const auto map = [&](size_t i, const ViewportAxis& axis) {
    if (exact) return static_cast<float>(vertex.position[i] * axis.scale / vertex.position[3] + axis.offset());
    return toFramebufferFloat(static_cast<float>(vertex.position[i]), w, axis, arithmetic);
  };
  return {map(0, stage.viewport.x), map(1, stage.viewport.y)};
}

std::unique_ptr<Shape> makeLineShape(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  std::unique_ptr<LineCoverage> nominal = lineCoverage(ends, style, rules);
  PlacedBand cut;
  std::optional<PlacedBand> uncut;
  if (rules.open) {
    LineStyle legal = style;
    // [vk:primsrast-lines-stipple] tells of strips and lists where s begins, and nothing of the edges of a polygon.
    legal.stipple.start.free = style.stipple.start.free || style.ofPolygon;
    if (!ends.removed) cut = PlacedBand(ends.a, ends.b, legal, rules);
    if (ends.uncut) uncut = PlacedBand((*ends.uncut)[0], (*ends.uncut)[1], legal, rules);
    if (uncut && !uncut->band) uncut.reset();
  }
  if (!nominal && !cut.band && !uncut) return nullptr;
  return std::make_unique<LineShape>(ends, std::move(nominal), std::move(cut), std::move(uncut));
}

}  // namespace rasterdiff::rasterizer
