// The reference's main loop: geometry → rows of covered samples → frame.
#include "rasterizer/render.hpp"

#include <algorithm>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/figure_rules.hpp"
#include "rasterizer/figure_verdict.hpp"
#include "rasterizer/frame_writer.hpp"
#include "rasterizer/freedom_band.hpp"
#include "rasterizer/kernel_frame.hpp"
#include "rasterizer/kept_fragments.hpp"
#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/mistakes/mistaken_scene.hpp"
#include "rasterizer/sample_grid.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/shape.hpp"
#include "rasterizer/target_area.hpp"

namespace rasterdiff::rasterizer {
namespace {

class Renderer {
 public:
  Renderer(const Scene& scene, const Rules& rules, std::vector<SubpixelPosition> pattern, RuleCounts& counts)
      : scene_(scene),
        rules_(rules),
        counts_(counts),
        pattern_(pattern),
        whole_(wholeTarget(scene)),
        values_(scene, needsOf(scene), rules, &counts),
        writer_(scene, needsOf(scene), rules, std::move(pattern), values_, counts),
        open_(rules.open),
        dropsFragments_(leavesDistancesToFragments(rules)),
        spans_(pattern_.size()) {
    for (uint32_t index = 0; index <= scene.furtherViewports.size(); ++index) {
      regions_.push_back(drawingRegion(scene, index, rules));
    }
  }

  void draw(const Primitive& primitive) {
    region_ = regions_[primitive.viewportIndex];
    area_ = region_.area;
    writer_.beginDraw(*primitive.draw);
    kept_.reset();
    const bool dropsFragments = dropsFragments_ && primitive.draw->clipDistanceCount > 0;
    if (dropsFragments) kept_.emplace(primitive, stageOf(primitive));
    if (primitive.folded) drawFolded(primitive);
    for (const SetupTriangle& piece : primitive.pieces) {
      if (piece.culled || primitive.folded) continue;
      const SubpixelBox box(primitive, piece);
      expect(box);
      values_.setUp(primitive, piece);
      writer_.beginPiece(primitive.number, values_);
      countInterpolation(primitive, drawPiece(primitive, piece, box));
      writer_.endPiece(values_);
    }
    for (const Figure& figure : primitive.figures) {
      if (dropsFragments) kept_.emplace(primitive, figure, stageOf(primitive));
      drawFigure(primitive, figure);
    }
    if (open_ && primitive.unprojectable) markEverything();
    if (open_ && !primitive.polygon.empty()) markBand(primitive);
  }

  Frame take() { return writer_.take(values_); }

 private:
  [[nodiscard]] VertexStage stageOf(const Primitive& primitive) const { return {rules_, primitive.viewport, scene_.target.samples}; }

  static constexpr int32_t kExpectedRows = 16;  // of taller pieces the processor fetches the rest by itself

  void expect(const SubpixelBox& box) {
    const int32_t first = std::max(box.low.y >> kSubpixelBits, whole_.top);
    const int32_t last = std::min(box.high.y >> kSubpixelBits, whole_.bottom - 1);
    if (last - first < kExpectedRows) writer_.expect(box.low.x >> kSubpixelBits, first, last);
  }

  // Returns the number of samples inside.
  uint64_t drawPiece(const Primitive& primitive, const SetupTriangle& piece, const SubpixelBox& box) {
    const auto pixel = [](int32_t v) { return v >> kSubpixelBits; };
    const SampleArea writable = region_.of(box);
    const int32_t first = std::max(pixel(box.low.y), whole_.top);
    const int32_t last = std::min(pixel(box.high.y), whole_.bottom - 1);
    uint64_t inside = 0, ties = 0;
    for (int32_t y = first; y <= last; ++y) {
      int64_t covered = 0;
      bool some = false, unequal = false;
      for (size_t s = 0; s < pattern_.size(); ++s) {
        const RowCoverage row = coverRow(piece.edges, pattern_[s].x, int64_t{y} * kSubpixelOne + pattern_[s].y,
                                         {whole_.left, whole_.right});
        ties += static_cast<uint64_t>(row.ties);
        covered += row.covered.length();
        RowSpan& span = spans_[s];
        const RowSpan columns = writable.columns(y, pattern_[s]);
        span = {std::max(row.covered.begin, columns.begin), std::min(row.covered.end, columns.end)};
        counts_[Rule::Scissor] += static_cast<uint64_t>(row.covered.length() - span.length());
        if (span.empty()) span = {};
        counts_[Rule::HelperInvocation] += static_cast<uint64_t>((span.begin & 1) + (span.end & 1));
        some = some || !span.empty();
        unequal = unequal || span.begin != spans_[0].begin || span.end != spans_[0].end;
      }
      inside += static_cast<uint64_t>(covered);
      if (unequal) ++counts_[Rule::SamplePattern];
      if (some && kept_) {
        writeKept(primitive, y);
      } else if (some) {
        writer_.writeRow(primitive.number, values_, y, spans_);
      }
    }
    counts_[Rule::SampleCoverage] += inside;
    counts_[Rule::TieBreak] += ties;
    if (primitive.cutByDistance) counts_[Rule::Partition] += ties;
    return inside;
  }

  // [choice:clip-distances] Fragments: only those that are kept, pixel by pixel.
  void writeKept(const Primitive& primitive, int32_t y) {
    const std::vector<RowSpan> row = spans_;
    RowSpan all{whole_.right, whole_.left};
    for (const RowSpan& span : row) {
      if (!span.empty()) all = {std::min(all.begin, span.begin), std::max(all.end, span.end)};
    }
    for (int32_t x = all.begin; x < all.end; ++x) {
      bool some = false;
      for (size_t s = 0; s < row.size(); ++s) {
        const bool covered = x >= row[s].begin && x < row[s].end;
        spans_[s] = covered ? keptOf(x, y) : RowSpan{};
        some = some || !spans_[s].empty();
      }
      if (some) writer_.writeRow(primitive.number, values_, y, spans_);
    }
  }

  [[nodiscard]] RowSpan keptOf(int32_t x, int32_t y) {
    if (!kept_ || kept_->keeps(x, y)) return {x, x + 1};
    ++counts_[Rule::UserDistance];
    return {};
  }

  // Few and small: every sample of the box is decided on its own, and drawn with the piece that it belongs to.
  void drawFolded(const Primitive& primitive) {
    const CutPolygon polygon(primitive, rules_);
    for (size_t i = 0; i < primitive.pieces.size(); ++i) {
      if (primitive.pieces[i].culled) continue;
      values_.setUp(primitive, primitive.pieces[i]);
      writer_.beginPiece(primitive.number, values_);
      countInterpolation(primitive, drawPart(primitive, polygon, i));
      writer_.endPiece(values_);
    }
  }

  // Returns the number of samples inside.
  uint64_t drawPart(const Primitive& primitive, const CutPolygon& polygon, size_t piece) {
    const auto pixel = [](int32_t v) { return v >> kSubpixelBits; };
    const SubpixelBox box(primitive);
    const SampleArea writable = region_.of(box);
    uint64_t inside = 0;
    for (int32_t y = std::max(pixel(box.low.y), whole_.top); y <= std::min(pixel(box.high.y), whole_.bottom - 1); ++y) {
      for (int32_t x = std::max(pixel(box.low.x), whole_.left); x <= std::min(pixel(box.high.x), whole_.right - 1); ++x) {
        bool some = false;
        for (size_t s = 0; s < pattern_.size(); ++s) {
          const int64_t px = int64_t{x} * kSubpixelOne + pattern_[s].x, py = int64_t{y} * kSubpixelOne + pattern_[s].y;
          const bool covered = polygon.pieceAt(px, py) == piece;
          spans_[s] = covered && writable.contains(x, y, pattern_[s]) ? keptOf(x, y) : RowSpan{};
          inside += covered ? 1 : 0;
          some = some || !spans_[s].empty();
        }
        if (some) writer_.writeRow(primitive.number, values_, y, spans_);
      }
    }
    counts_[Rule::SampleCoverage] += inside;
    return inside;
  }

  // Lines and points.
  void drawFigure(const Primitive& primitive, const Figure& figure) {
    values_.setUp(primitive, figure);
    const Shape::Rows rows = figure.shape->rows();
    const int32_t first = std::max(rows.first, whole_.top), last = std::min(rows.last, whole_.bottom - 1);
    uint64_t inside = 0;
    for (int32_t y = first; y <= last; ++y) {
      RowSpan columns = figure.shape->columns(y);
      columns = {std::max(columns.begin, whole_.left), std::min(columns.end, whole_.right)};
      if (columns.empty()) continue;
      if (open_) markFigureRow(figure, y, columns);
      if (figure.nominal || figure.solid) inside += drawFigureRow(primitive, figure, y, columns);
    }
    const FigureRules atWork(scene_, rules_, primitive, figure);
    for (const Rule rule : atWork.all()) counts_[rule] += inside;
    countInterpolation(primitive, inside);
  }

  // Returns the number of samples inside. What has no rows of its own is decided sample by sample.
  uint64_t drawFigureRow(const Primitive& primitive, const Figure& figure, int32_t y, RowSpan columns) {
    uint64_t samples = 0;
    const bool whole = figure.nominal && !figure.solid && !kept_ && rules_.error == DeliberateError::None;
    if (whole && coverFigureRow(figure, y, columns, samples)) {
      if (samples > 0) writer_.writeRow(primitive.number, values_, y, spans_);
      return samples;
    }
    for (int32_t x = columns.begin; x < columns.end; ++x) samples += drawFigurePixel(primitive, figure, x, y);
    return samples;
  }

  bool coverFigureRow(const Figure& figure, int32_t y, RowSpan columns, uint64_t& samples) {
    RowSpan writable = columns;
    if (!figure.cutsItself) writable = area_.contains(area_.left, y) ? RowSpan{area_.left, area_.right} : RowSpan{};
    for (size_t s = 0; s < pattern_.size(); ++s) {
      const std::optional<RowCoverage> row = figure.shape->coverRow(y, pattern_[s], columns);
      if (!row) return false;
      const RowSpan inside{std::max(row->covered.begin, writable.begin), std::min(row->covered.end, writable.end)};
      spans_[s] = inside.empty() ? RowSpan{} : inside;
      counts_[Rule::TieBreak] += static_cast<uint64_t>(row->ties);
      counts_[Rule::Scissor] += static_cast<uint64_t>(row->covered.length() - inside.length());
      samples += static_cast<uint64_t>(inside.length());
    }
    return true;
  }

  void markFigureRow(const Figure& figure, int32_t y, RowSpan columns) {
    const bool pixels = figure.shape->classifiesPixels();
    for (int32_t x = columns.begin; x < columns.end; ++x) {
      if (!region_.allows(figure, x, y)) continue;
      Coverage coverage = Coverage::Out;
      for (uint32_t s = 0; s < pattern_.size(); ++s) {
        const int64_t px = int64_t{x} * kSubpixelOne + pattern_[s].x, py = int64_t{y} * kSubpixelOne + pattern_[s].y;
        if (s == 0 || !pixels) coverage = legalVerdict(figure, px, py).coverage;
        writer_.markCoverage(x, y, s, coverage);
      }
    }
  }

  // Returns the number of samples inside.
  uint64_t drawFigurePixel(const Primitive& primitive, const Figure& figure, int32_t x, int32_t y) {
    const bool inside = region_.allows(figure, x, y);
    uint64_t samples = 0;
    for (uint32_t s = 0; s < pattern_.size(); ++s) {
      const int64_t px = int64_t{x} * kSubpixelOne + pattern_[s].x, py = int64_t{y} * kSubpixelOne + pattern_[s].y;
      bool tie = false;
      const bool covered = figure.nominal && figure.shape->covers(px, py, tie);
      if (tie) ++counts_[Rule::TieBreak];
      if (covered && !inside) ++counts_[Rule::Scissor];
      if (figure.solid) countStipple(figure, px, py, covered);
      spans_[s] = covered && inside ? keptOf(x, y) : RowSpan{};
      if (!spans_[s].empty()) ++samples;
    }
    if (samples > 0) writer_.writeRow(primitive.number, values_, y, spans_);
    return samples;
  }

  void countStipple(const Figure& line, int64_t px, int64_t py, bool kept) {
    bool tie = false;
    if (kept || line.solid->covers(px, py, tie)) ++counts_[Rule::LineStipple];
  }

  void countInterpolation(const Primitive& primitive, uint64_t samples) {
    if (scene_.target.depthFormat) counts_[Rule::LinearDepth] += samples;
    if (primitive.draw->varyings.empty()) return;
    if (primitive.cut) counts_[Rule::ClipAttribute] += samples;
    if (primitive.polygon.size() > 3) counts_[Rule::CutPolygon] += samples;
    const std::array<ClipPosition, 3>& v = primitive.clip;
    if (v[0].w != v[1].w || v[0].w != v[2].w) ++counts_[Rule::Perspective];
    for (const Varying& varying : primitive.draw->varyings) {
      if (varying.interpolation == Interpolation::flat) {
        ++counts_[Rule::ProvokingVertex];
        break;
      }
    }
  }

  void markEverything() {
    for (int32_t y = area_.top; y < area_.bottom; ++y) {
      for (int32_t x = area_.left; x < area_.right; ++x) {
        for (uint32_t s = 0; s < pattern_.size(); ++s) writer_.markCoverage(x, y, s, Coverage::Either);
      }
    }
  }

  void markBand(const Primitive& primitive) {
    const FreedomBand band(primitive, scene_.state.cullMode, scene_.state.frontFace);
    const int32_t first = std::max(band.firstRow(), area_.top), last = std::min(band.lastRow(), area_.bottom - 1);
    for (int32_t y = first; y <= last; ++y) {
      for (uint32_t s = 0; s < pattern_.size(); ++s) {
        const int64_t sampleY = int64_t{y} * kSubpixelOne + pattern_[s].y;
        const FreedomBand::Row row = band.row(pattern_[s].x, sampleY, {area_.left, area_.right});
        writer_.markCoverage(y, s, row.certain);
        const auto classify = [&](int32_t from, int32_t to) {
          for (int32_t x = from; x < to; ++x) {
            writer_.markCoverage(x, y, s, band.classify(int64_t{x} * kSubpixelOne + pattern_[s].x, sampleY).coverage);
          }
        };
        if (row.certain.empty()) {
          classify(row.possible.begin, row.possible.end);
        } else {
          classify(row.possible.begin, row.certain.begin);
          classify(row.certain.end, row.possible.end);
        }
      }
    }
  }

  const Scene& scene_;
  const Rules& rules_;
  RuleCounts& counts_;
  const std::vector<SubpixelPosition> pattern_;
  const PixelArea whole_;
  std::vector<DrawingRegion> regions_;  // by viewport
  DrawingRegion region_;                // of the primitive being drawn
  PixelArea area_;
  PieceValues values_;
  FrameWriter writer_;
  const bool open_;
  const bool dropsFragments_;
  std::optional<KeptFragments> kept_;  // of the primitive or figure being drawn
  std::vector<RowSpan> spans_;
};

}  // namespace

Result<Frame> renderRowByRow(const Scene& scene, const Rules& profile, RuleCounts* counts) {
  const Rules rules = rulesFor(scene, profile);
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected<Error>(valid.error());
  if (scene.target.sampleLocations) return renderGrid(scene, rules, counts);
  Result<std::vector<SubpixelPosition>> pattern = samplePattern(scene.target.samples, rules);
  if (!pattern) return tl::unexpected<Error>(pattern.error());
  RuleCounts own;
  RuleCounts& counting = counts != nullptr ? *counts : own;
  const std::optional<Scene> mistaken = mistakenScene(scene, rules.error);
  const Scene& drawn = mistaken ? *mistaken : scene;
  Renderer renderer(drawn, rules, std::move(*pattern), counting);
  forEachPrimitive(drawn, rules, counting, [&](const Primitive& primitive) { renderer.draw(primitive); });
  return renderer.take();
}

Result<Frame> render(const Scene& scene, const Rules& profile, RuleCounts* counts, unsigned threads, const RowsDrawn& drawn) {
  const Rules rules = rulesFor(scene, profile);
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected<Error>(valid.error());
  const auto pattern = samplePattern(scene.target.samples, rules);
  if (pattern && !scene.target.sampleLocations) {
    if (const auto kernel = KernelFrame::of(scene, rules, *pattern)) {
      if (std::optional<Frame> frame = kernel->draw(std::max(1U, threads), counts, drawn)) return std::move(*frame);
    }
  }
  return renderRowByRow(scene, profile, counts);
}

}  // namespace rasterdiff::rasterizer
