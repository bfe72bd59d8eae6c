// Custom sample locations: a scene with a table of them for each pixel of a grid is, at the pixels of one place of the
// grid, a scene without any under rules that have that place's table. [vk:primsrast-samplelocations]
#pragma once

#include <vector>

#include "rasterizer/render.hpp"

namespace rasterdiff::rasterizer {

/// The scene and the rules as they are at every pixel (x, y) with x mod grid width = column, y mod grid height = row.
struct GridPixel {
  Scene scene;  ///< without sampleLocations
  Rules rules;
};

class SampleGrid {
 public:
  /// Of a valid scene with sampleLocations. Locations are clamped to the advertised range and rounded to the nearest
  /// advertised step, ties to even. Error: NotOffered under open rules if one lies between two steps, as Vulkan does
  /// not say to which of them it goes, or if the advertised steps are finer than 1/256 pixel.
  [[nodiscard]] static Result<SampleGrid> of(const Scene& scene, const Rules& rules);

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  [[nodiscard]] const GridPixel& at(uint32_t column, uint32_t row) const { return places_[row * width_ + column]; }
  /// Of the place of the grid that pixel (x, y) has.
  [[nodiscard]] const GridPixel& ofPixel(uint32_t x, uint32_t y) const { return at(x % width_, y % height_); }

 private:
  uint32_t width_ = 1, height_ = 1;
  std::vector<GridPixel> places_;  // row by row
};

/// render() of such a scene: once for each place of the grid. The counters go up by the mean of the places.
[[nodiscard]] Result<Frame> renderGrid(const Scene& scene, const Rules& rules, RuleCounts* counts);

/// candidates() of such a scene.
[[nodiscard]] Result<std::vector<std::vector<Candidate>>> gridCandidates(const Scene& scene, const Rules& rules,
                                                                         std::span<const SampleQuery> queries);

}  // namespace rasterdiff::rasterizer
