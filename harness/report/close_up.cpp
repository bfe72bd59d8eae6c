#include "harness/report/close_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "harness/report/picture.hpp"
#include "harness/report/sample_mark.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/sample_grid.hpp"
#include "rasterizer/sample_pattern.hpp"

namespace rasterdiff::harness {
namespace {

constexpr int32_t kAround = 4;              // pixels on each side of the focus
constexpr size_t kMostPrimitives = 60;      // near the focus; a crowd would hide the samples
constexpr std::string_view kInk = "#1b1d22", kGrid = "#cfcec8", kPaper = "#fbfbf9";

struct Window {
  double left = 0, top = 0, right = 0, bottom = 0;  // pixels
};

struct Line {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The part of a line inside of the window (Liang and Barsky 1984); none where there is none. Edges may be a million pixels long.
std::optional<Line> clipped(const Line& line, const Window& w) {
  for (const double end : {line.x0, line.y0, line.x1, line.y1}) {
    if (!std::isfinite(end)) return std::nullopt;
  }
  const double dx = line.x1 - line.x0, dy = line.y1 - line.y0;
  double from = 0, to = 1;
  const double p[4] = {-dx, dx, -dy, dy};
  const double q[4] = {line.x0 - w.left, w.right - line.x0, line.y0 - w.top, w.bottom - line.y0};
  for (int i = 0; i < 4; ++i) {
    if (p[i] == 0 && q[i] < 0) return std::nullopt;
    if (p[i] < 0) from = std::max(from, q[i] / p[i]);
    if (p[i] > 0) to = std::min(to, q[i] / p[i]);
  }
  if (!(from <= to)) return std::nullopt;
  return Line{line.x0 + from * dx, line.y0 + from * dy, line.x0 + to * dx, line.y0 + to * dy};
}

double pixels(int32_t snapped) { return snapped / double{kSubpixelOne}; }

class CloseUp {
 public:
  CloseUp(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual, const SceneResult& result,
          const rasterizer::SampleQuery& focus)
      : scene_(scene), rules_(rules), reference_(reference), actual_(actual), marker_(reference, actual, result), focus_(focus) {
    const auto side = [](uint32_t at, uint32_t size, double& low, double& high) {
      const int32_t first = std::max(0, static_cast<int32_t>(at) - kAround);
      const int32_t last = std::min(static_cast<int32_t>(size), first + 2 * kAround + 1);
      low = std::max(0, last - 2 * kAround - 1);
      high = last;
    };
    if (scene.target.sampleLocations) {
      if (Result<rasterizer::SampleGrid> grid = rasterizer::SampleGrid::of(scene, rules)) grid_ = std::move(*grid);
    }
    side(focus.x, reference.width, window_.left, window_.right);
    side(focus.y, reference.height, window_.top, window_.bottom);
  }

  [[nodiscard]] std::string draw() {
    const double width = window_.right - window_.left, height = window_.bottom - window_.top;
    fmt::format_to(out(), "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"close-up\" viewBox=\"{} {} {} {}\" width=\"{}\" height=\"{}\">", window_.left - 0.5,
                   window_.top - 0.6, width + 0.75, height + 0.85, std::lround(44 * (width + 0.75)), std::lround(44 * (height + 0.85)));
    fmt::format_to(out(), "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>", window_.left - 0.5, window_.top - 0.6, width + 0.75, height + 0.85, kPaper);
    drawGrid();
    drawGeometry();
    drawSamples();
    text_ += "</svg>";
    return text_;
  }

 private:
  std::back_insert_iterator<std::string> out() { return std::back_inserter(text_); }

  void put(const Line& l, std::string_view colour, double width, std::string_view more = "") {
    fmt::format_to(out(), "<line x1=\"{:.5g}\" y1=\"{:.5g}\" x2=\"{:.5g}\" y2=\"{:.5g}\" stroke=\"{}\" stroke-width=\"{}\"{}/>", l.x0, l.y0, l.x1, l.y1, colour, width, more);
  }

  void drawGrid() {
    fmt::format_to(out(), "<rect x=\"{}\" y=\"{}\" width=\"1\" height=\"1\" fill=\"#ecebe2\"/>", focus_.x, focus_.y);
    for (double x = window_.left; x <= window_.right; ++x) put({x, window_.top, x, window_.bottom}, kGrid, 0.02);
    for (double y = window_.top; y <= window_.bottom; ++y) put({window_.left, y, window_.right, y}, kGrid, 0.02);
    for (const double x : {window_.left, double(focus_.x), window_.right - 1}) {
      fmt::format_to(out(), "<text x=\"{}\" y=\"{}\" font-size=\"0.3\" font-family=\"sans-serif\" text-anchor=\"middle\" fill=\"#666b76\">{}</text>", x + 0.5,
                     window_.top - 0.2, x);
    }
    for (const double y : {window_.top, double(focus_.y), window_.bottom - 1}) {
      fmt::format_to(out(), "<text x=\"{}\" y=\"{}\" font-size=\"0.22\" font-family=\"sans-serif\" text-anchor=\"end\" fill=\"#666b76\">{}</text>", window_.left - 0.06,
                     y + 0.58, y);
    }
  }

  void drawGeometry() {
    rasterizer::RuleCounts unread;
    rasterizer::forEachPrimitive(scene_, rules_, unread, [this](const rasterizer::Primitive& primitive) {
      if (drawn_ < kMostPrimitives) drawPrimitive(primitive);
    });
  }

  void drawPrimitive(const rasterizer::Primitive& primitive) {
    const std::string colour = primitiveColourText(primitive.number);
    bool near = false;
    const auto edge = [&](const Line& line, std::string_view more) {
      const std::optional<Line> inside = clipped(line, window_);
      if (!inside) return;
      put(*inside, colour, 0.07, more);
      near = true;
    };
    const size_t corners = primitive.polygon.size();
    for (size_t i = 0; i < corners && primitive.figures.empty(); ++i) {
      const SubpixelPosition &a = primitive.polygon[i].snapped, &b = primitive.polygon[(i + 1) % corners].snapped;
      edge({pixels(a.x), pixels(a.y), pixels(b.x), pixels(b.y)}, " stroke-linecap=\"round\"");
      vertex(a);
    }
    for (const rasterizer::Figure& figure : primitive.figures) {
      const bool line = figure.kind == rasterizer::Figure::Kind::Line;
      const rasterizer::RasterVertex& end = line ? figure.b : figure.a;
      edge({figure.a.position.x, figure.a.position.y, end.position.x, end.position.y}, " stroke-dasharray=\"0.2 0.1\"");
      vertex(figure.a.snapped);
      if (line) vertex(end.snapped);
    }
    drawn_ += near ? 1U : 0U;
  }

  void vertex(const SubpixelPosition& at) {
    const double x = pixels(at.x), y = pixels(at.y);
    if (x < window_.left || x > window_.right || y < window_.top || y > window_.bottom) return;
    fmt::format_to(out(), "<rect x=\"{:.5g}\" y=\"{:.5g}\" width=\"0.16\" height=\"0.16\" fill=\"{}\"/>", x - 0.08, y - 0.08, kInk);
  }

  /// Of the samples of a pixel, in 1/256 pixel from its corner.
  [[nodiscard]] std::vector<SubpixelPosition> patternOf(uint32_t x, uint32_t y) const {
    const rasterizer::Rules& rules = grid_ ? grid_->ofPixel(x, y).rules : rules_;
    return rasterizer::samplePattern(reference_.samples, rules).value_or(std::vector<SubpixelPosition>(reference_.samples));
  }

  void drawSamples() {
    const double radius = reference_.samples > 4 ? 0.06 : 0.1;
    for (auto y = static_cast<uint32_t>(window_.top); y < static_cast<uint32_t>(window_.bottom); ++y) {
      for (auto x = static_cast<uint32_t>(window_.left); x < static_cast<uint32_t>(window_.right); ++x) {
        const std::vector<SubpixelPosition> pattern = patternOf(x, y);
        for (uint32_t s = 0; s < reference_.samples; ++s) drawSample(x, y, s, pattern[s], radius);
      }
    }
  }

  /// Filled: the driver covered it, in the colour of the primitive. Its ring tells the verdict.
  void drawSample(uint32_t x, uint32_t y, uint32_t sample, const SubpixelPosition& at, double radius) {
    const size_t index = reference_.primitive.index(x, y, sample);
    const uint32_t winner = actual_.primitive.data[index];
    std::string_view ring = "#9a9ea8";
    double width = 0.025;
    switch (marker_.markOf(index)) {
      case SampleMark::Differs: ring = "#e22030", width = 0.07; break;
      case SampleMark::Allowed: ring = "#f0b010", width = 0.07; break;
      default: break;
    }
    fmt::format_to(out(), "<circle cx=\"{:.5g}\" cy=\"{:.5g}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>", x + pixels(at.x), y + pixels(at.y), radius,
                   winner == 0 ? std::string(kPaper) : primitiveColourText(winner), ring, width);
    if (x == focus_.x && y == focus_.y && sample == focus_.sample) {
      fmt::format_to(out(), "<circle cx=\"{:.5g}\" cy=\"{:.5g}\" r=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.03\"/>", x + pixels(at.x), y + pixels(at.y), radius + 0.1, kInk);
    }
  }

  const Scene& scene_;
  const rasterizer::Rules& rules_;
  const Frame &reference_, &actual_;
  const SampleMarker marker_;
  const rasterizer::SampleQuery focus_;
  Window window_;
  std::optional<rasterizer::SampleGrid> grid_;  // of custom sample locations
  std::string text_;
  size_t drawn_ = 0;
};

}  // namespace

std::optional<rasterizer::SampleQuery> focusOf(const SceneResult& result) {
  if (!result.differences.empty()) {
    const SampleDifference& first = result.differences.front();
    return rasterizer::SampleQuery{first.x, first.y, first.sample};
  }
  for (const ValueStats& value : result.values) {
    if (value.firstDiffering) return rasterizer::SampleQuery{value.firstDiffering->x, value.firstDiffering->y, value.firstDiffering->sample};
  }
  return std::nullopt;
}

std::string closeUp(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual, const SceneResult& result,
                    const rasterizer::SampleQuery& focus) {
  return CloseUp(scene, rules, reference, actual, result, focus).draw();
}

}  // namespace rasterdiff::harness
