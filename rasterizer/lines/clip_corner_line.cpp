#include "rasterizer/lines/clip_corner_line.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/cut_polygon.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Corners = std::array<ClipPosition, 4>;

ClipPosition moved(ClipPosition p, float dx, float dy) {
  p.x += dx;
  p.y += dy;
  return p;
}

struct Screen {
  float halfWidth, halfHeight;  ///< of the viewport, pixels
  float dx, dy;                 ///< from the first end to the second, pixels
};

Corners rectangle(const std::array<ClipPosition, 2>& ends, const Screen& screen, float width) {
  const float scale = width * 0.5F / std::sqrt(screen.dx * screen.dx + screen.dy * screen.dy);
  const float nx = screen.dx * scale, ny = screen.dy * scale;
  const auto corner = [&](const ClipPosition& p, float side) {
    const float along = nx * p.w / screen.halfHeight, across = ny * p.w / screen.halfWidth;
    return moved(p, side * -across, side * along);
  };
  return {corner(ends[0], 1), corner(ends[1], 1), corner(ends[1], -1), corner(ends[0], -1)};
}

// Opposite corners of the diamonds: above and below for lines that go sideways, else to the left and to the right.
Corners parallelogram(const std::array<ClipPosition, 2>& ends, const Screen& screen, float width) {
  const bool towardRight = screen.dx > -screen.dy, towardTop = screen.dx > screen.dy;
  const float side = towardRight == towardTop ? (towardRight ? 1.0F : -1.0F) : (towardRight ? -1.0F : 1.0F);
  const bool sideways = towardRight == towardTop;
  const auto corner = [&](const ClipPosition& p, float direction) {
    const float half = width * 0.5F * p.w;
    return sideways ? moved(p, 0, direction * (half / screen.halfHeight)) : moved(p, direction * (half / screen.halfWidth), 0);
  };
  return {corner(ends[0], side), corner(ends[1], side), corner(ends[1], -side), corner(ends[0], -side)};
}

class ClipCornerLine final : public Shape {
 public:
  ClipCornerLine(std::vector<SubpixelPosition> corners, TieRule rule, bool wholePixels)
      : corners_(std::move(corners)), fill_(corners_, true, rule), wholePixels_(wholePixels) {
    low_ = high_ = corners_.front();
    for (const SubpixelPosition& p : corners_) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  [[nodiscard]] Rows rows() const override { return {low_.y >> kSubpixelBits, high_.y >> kSubpixelBits}; }
  [[nodiscard]] RowSpan columns(int32_t) const override { return {low_.x >> kSubpixelBits, (high_.x >> kSubpixelBits) + 1}; }
  [[nodiscard]] bool covers(int64_t px, int64_t py, bool& tie) const override {
    if (wholePixels_) {
      px = (px >> kSubpixelBits) * kSubpixelOne + kSubpixelOne / 2;
      py = (py >> kSubpixelBits) * kSubpixelOne + kSubpixelOne / 2;
    }
    return fill_.covers(px, py, tie);
  }
  [[nodiscard]] BandVerdict classify(int64_t px, int64_t py) const override {
    bool tie = false;
    return {covers(px, py, tie) ? Coverage::In : Coverage::Out, Freedom::None, std::nullopt};
  }
  [[nodiscard]] ShapeFacts facts(int64_t, int64_t) const override {
    ShapeFacts facts;
    for (const SubpixelPosition& p : corners_) {
      facts.corners.push_back({static_cast<double>(p.x) / kSubpixelOne, static_cast<double>(p.y) / kSubpixelOne, 0});
    }
    return facts;
  }

 private:
  std::vector<SubpixelPosition> corners_;
  SpanFill fill_;
  SubpixelPosition low_, high_;
  bool wholePixels_;
};

}  // namespace

std::unique_ptr<Shape> makeClipCornerLine(const std::array<ClipPosition, 2>& ends, const LineStyle& style,
                                          const VertexStage& stage, const ClipVolume& volume) {
  const auto& [a, b] = ends;
  if (a.w <= 0 && b.w <= 0) return nullptr;
  Screen screen{static_cast<float>(stage.viewport.x.scale), static_cast<float>(stage.viewport.y.scale), 0, 0};
  screen.dx = screen.halfWidth * (b.x / b.w - a.x / a.w);
  screen.dy = screen.halfHeight * (b.y / b.w - a.y / a.w);
  if (screen.dx == 0 && screen.dy == 0) return nullptr;
  const bool bresenham = style.mode == LineRasterizationMode::BRESENHAM;
  const Corners corners = bresenham ? parallelogram(ends, screen, style.width) : rectangle(ends, screen, style.width);

  ClipPolygon polygon;
  clipPolygon(corners, stage.rules.choices.clipArithmetic, volume, polygon);
  if (polygon.size < 3) return nullptr;
  std::vector<SubpixelPosition> snapped;
  for (int i = 0; i < polygon.size; ++i) {
    const std::array<double, 4>& p = polygon.vertices[static_cast<size_t>(i)].position;
    const float w = p[3] == 0 ? 1.0F : static_cast<float>(p[3]);
    snapped.push_back({snapUnder(stage.rules, stage.samples, static_cast<float>(p[0]), w, stage.viewport.x),
                       snapUnder(stage.rules, stage.samples, static_cast<float>(p[1]), w, stage.viewport.y)});
  }
  return std::make_unique<ClipCornerLine>(std::move(snapped), tieRule(stage.rules.choices), bresenham);
}

}  // namespace rasterdiff::rasterizer
