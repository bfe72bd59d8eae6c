// Lines as a float32 driver draws them: the outlines of float_corners.hpp as polygons, decided in integers.
// [choice:line-arithmetic] [vk:primsrast-polygons-basic]
#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/drawing_region.hpp"
#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/lines/tile_binning.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Outline {
  std::array<EdgeFunction, 4> edges;
  PixelArea seen;
  SampleArea writable;
};

class FloatCornerCoverage final : public LineCoverage {
 public:
  FloatCornerCoverage(std::vector<Outline> outlines, bool atSamples, float width)
      : outlines_(std::move(outlines)), atSamples_(atSamples), width_(width) {}

  bool covers(int64_t px, int64_t py, bool& tie) const override {
    tie = false;
    const int64_t x = px >> kSubpixelBits, y = py >> kSubpixelBits;
    const SubpixelPosition offset{static_cast<int32_t>(px & (kSubpixelOne - 1)), static_cast<int32_t>(py & (kSubpixelOne - 1))};
    if (!atSamples_) {
      px = x * kSubpixelOne + kSubpixelOne / 2;
      py = y * kSubpixelOne + kSubpixelOne / 2;
    }
    bool covered = false;
    for (const Outline& outline : outlines_) {
      if (!outline.writable.contains(static_cast<int32_t>(x), static_cast<int32_t>(y), offset)) continue;
      if (atSamples_ && !outline.seen.contains(static_cast<int32_t>(x), static_cast<int32_t>(y))) continue;
      bool inside = true, touched = true, onEdge = false;
      for (const EdgeFunction& edge : outline.edges) {
        const int64_t value = edge.at(px, py);
        inside = inside && (value > 0 || (value == 0 && edge.ownsTies));
        touched = touched && value >= 0;
        onEdge = onEdge || value == 0;
      }
      covered = covered || inside;
      tie = tie || (touched && onEdge);
    }
    return covered;
  }

  // One outline: a convex polygon. The dashes of a stippled line are several.
  std::optional<RowCoverage> coverRow(int32_t y, SubpixelPosition offset, RowSpan columns) const override {
    if (outlines_.size() != 1) return std::nullopt;
    const Outline& outline = outlines_[0];
    const RowSpan writable = outline.writable.columns(y, offset);
    columns = {std::max(columns.begin, writable.begin), std::min(columns.end, writable.end)};
    if (atSamples_) {
      if (y < outline.seen.top || y >= outline.seen.bottom) return RowCoverage{};
      columns = {std::max(columns.begin, outline.seen.left), std::min(columns.end, outline.seen.right)};
    } else {
      offset = {kSubpixelOne / 2, kSubpixelOne / 2};
    }
    if (columns.empty()) return RowCoverage{};
    return rasterizer::coverRow(outline.edges, offset.x, int64_t{y} * kSubpixelOne + offset.y, columns);
  }

  // Of the outline in which the sample lies deepest.
  ShapeFacts facts(int64_t px, int64_t py) const override {
    constexpr std::array<std::string_view, 4> kNames{"edge 1", "edge 2", "edge 3", "edge 4"};
    if (!atSamples_) {
      px = (px >> kSubpixelBits) * kSubpixelOne + kSubpixelOne / 2;
      py = (py >> kSubpixelBits) * kSubpixelOne + kSubpixelOne / 2;
    }
    ShapeFacts best;
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Outline& outline : outlines_) {
      ShapeFacts facts;
      double least = std::numeric_limits<double>::infinity();
      for (size_t i = 0; i < 4; ++i) {
        const EdgeFunction& edge = outline.edges[i];
        const double length = std::hypot(static_cast<double>(edge.dx), static_cast<double>(edge.dy));
        const int64_t value = edge.at(px, py);
        const double inside = length > 0 ? static_cast<double>(value) / length / kSubpixelOne : 0;
        facts.corners.push_back({static_cast<double>(edge.ax) / kSubpixelOne, static_cast<double>(edge.ay) / kSubpixelOne, 0});
        facts.sides.push_back({kNames[i], inside, value == 0, edge.ownsTies});
        least = std::min(least, inside);
      }
      if (least <= deepest) continue;
      deepest = least;
      best = std::move(facts);
    }
    return best;
  }

  // Corners lie within half the width and the moves along the line (a pixel) of the ends; centres stand for pixels.
  double reach() const override { return (static_cast<double>(width_) / 2 + 3) * kSubpixelOne; }

 private:
  std::vector<Outline> outlines_;
  bool atSamples_;  ///< each sample for itself; else the pixel's centre decides for all
  float width_;
};

}  // namespace

std::unique_ptr<LineCoverage> floatCornerCoverage(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const bool bresenham = style.mode == LineRasterizationMode::BRESENHAM;
  // Bresenham lines switch multisampling off, but only where the topology is one of lines.
  const bool multisampled = style.samples > 1 && (!bresenham || style.ofPolygon);
  const float origin = multisampled ? 0.0F : 0.5F;
  std::vector<FloatSegment> segments{{ends.floatA, ends.floatB}};
  if (style.stipple.enabled) segments = dashes(ends.floatA, ends.floatB, style.stipple, !bresenham);

  std::vector<Outline> outlines;
  for (const FloatSegment& segment : segments) {
    const std::optional<LineOutline> corners = bresenham
                                                   ? bresenhamOutline(segment.a, segment.b, style.width, origin)
                                                   : rectangularOutline(segment.a, segment.b, style.width, origin);
    if (!corners) continue;
    Outline outline;
    for (size_t i = 0; i < 4; ++i) {
      EdgeFunction& edge = outline.edges[i];
      edge = edgeFunction((*corners)[i], (*corners)[(i + 1) % 4], tieRule(rules.choices));
      edge.ownsTies = (edge.dx != 0 || edge.dy != 0) && ownsLineTies(rules, edge.dx, edge.dy);
    }
    if (multisampled) outline.seen = binnedArea(*corners, style.area);
    outline.writable = DrawingRegion{style.area, style.leaky && multisampled}.of(cornersInside(*corners));
    outlines.push_back(outline);
  }
  if (outlines.empty()) return nullptr;
  return std::make_unique<FloatCornerCoverage>(std::move(outlines), multisampled, std::max(1.0F, style.width));
}

}  // namespace rasterdiff::rasterizer
