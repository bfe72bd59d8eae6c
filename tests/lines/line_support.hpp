// Lines for tests: ends on the grid of 1/256 pixel, and shapes drawn as text.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "rasterizer/lines/line_shape.hpp"
#include "rasterizer/sample_pattern.hpp"

namespace rasterdiff::rasterizer::testing {

inline Limits wideLimits() {
  Limits limits;
  limits.lineWidthMin = 1;
  limits.lineWidthMax = 255;
  limits.lineWidthGranularity = 1.0F / 128;
  limits.stippledRectangularLines = limits.stippledBresenhamLines = true;
  return limits;
}

inline Rules rulesOf(std::string_view profile, const Limits& limits = wideLimits()) {
  return profile == "spec" ? Rules::specification(limits) : *Rules::profile(profile, limits);
}

inline RasterVertex vertexAt(double x, double y) {
  RasterVertex vertex;
  vertex.position = {x, y, 0};
  const auto nearest = [](double pixels) { return static_cast<int32_t>(std::nearbyint(pixels * kSubpixelOne)); };
  vertex.snapped = vertex.lowest = vertex.highest = {nearest(x), nearest(y)};
  return vertex;
}

/// Pixels; ends that are multiples of 1/256 pixel are known exactly.
inline LineEnds endsOf(double ax, double ay, double bx, double by) {
  LineEnds ends;
  ends.a = vertexAt(ax, ay);
  ends.b = vertexAt(bx, by);
  ends.floatA = {static_cast<float>(ax), static_cast<float>(ay)};
  ends.floatB = {static_cast<float>(bx), static_cast<float>(by)};
  return ends;
}

inline LineEnds subpixelEnds(SubpixelPosition a, SubpixelPosition b) {
  return endsOf(a.x / 256.0, a.y / 256.0, b.x / 256.0, b.y / 256.0);
}

inline LineStyle styleOf(LineRasterizationMode mode, float width = 1, uint32_t samples = 1) {
  LineStyle style;
  style.mode = mode;
  style.width = width;
  style.samples = samples;
  style.area = {0, 0, 128, 128};
  return style;
}

/// '#' where the sample at `offset` of a pixel is covered; rows from the top.
inline std::string textOf(const Shape* shape, int32_t width, int32_t height, SubpixelPosition offset = {128, 128}) {
  std::string text;
  for (int32_t y = 0; y < height; ++y) {
    for (int32_t x = 0; x < width; ++x) {
      bool tie = false;
      const bool covered = shape != nullptr && shape->covers(x * 256 + offset.x, y * 256 + offset.y, tie);
      text += covered ? '#' : '.';
    }
    text += '\n';
  }
  return text;
}

/// As hexadecimal digits: bit s set where sample s is covered; '.' for none.
inline std::string sampleText(const Shape* shape, int32_t width, int32_t height, const Rules& rules) {
  const std::vector<SubpixelPosition> pattern = *samplePattern(4, rules);
  std::string text;
  for (int32_t y = 0; y < height; ++y) {
    for (int32_t x = 0; x < width; ++x) {
      unsigned mask = 0;
      for (size_t s = 0; s < 4; ++s) {
        bool tie = false;
        const bool covered = shape != nullptr && shape->covers(x * 256 + pattern[s].x, y * 256 + pattern[s].y, tie);
        mask |= covered ? 1U << s : 0U;
      }
      text += mask == 0 ? '.' : "0123456789abcdef"[mask];
    }
    text += '\n';
  }
  return text;
}

inline std::vector<SubpixelPosition> patternOf(uint32_t samples, const Rules& rules) {
  return *samplePattern(samples, rules);
}

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  int32_t below(int32_t bound) { return static_cast<int32_t>(engine_() % static_cast<uint32_t>(bound)); }
  /// A coordinate on a grid of `step` / 256 pixel.
  int32_t onGrid(int32_t step, int32_t extent) { return below(extent * 256 / step + 1) * step; }

 private:
  std::mt19937 engine_;
};

}  // namespace rasterdiff::rasterizer::testing
