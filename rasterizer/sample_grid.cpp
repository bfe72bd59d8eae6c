#include "rasterizer/sample_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kMostSubpixels = kSubpixelOne - 1;  // a location stays inside of its pixel

/// One coordinate in 1/256 pixel; `exact` is cleared where it had to be rounded.
uint8_t coordinate(float value, const Rules& rules, bool& exact) {
  const Limits& limits = rules.limits;
  const bool clamps = rules.error != DeliberateError::SampleLocationsUnclamped;
  const double low = clamps ? double{limits.sampleLocationCoordinateMin} : 0;
  const double high = clamps ? double{limits.sampleLocationCoordinateMax} : 1;
  const double clamped = std::clamp<double>(value, low, std::max(low, high));
  const double steps = std::ldexp(clamped, static_cast<int>(limits.sampleLocationSubPixelBits));
  const double nearest = std::nearbyint(steps);
  exact = exact && nearest == steps;
  const double subpixels = std::ldexp(nearest, kSubpixelBits - static_cast<int>(limits.sampleLocationSubPixelBits));
  return static_cast<uint8_t>(std::clamp(subpixels, 0.0, kMostSubpixels));  // Q0.8
}

/// Index of a place's first location, mistakes included.
size_t firstLocation(const SampleLocationsInfo& info, uint32_t column, uint32_t row, uint32_t samples, DeliberateError error) {
  size_t place = column + size_t{row} * info.gridWidth;
  if (error == DeliberateError::SampleLocationsTransposed) place = row + size_t{column} * info.gridHeight;
  if (error == DeliberateError::SampleLocationsOfFirstPixel) place = 0;
  return place * samples;
}

template <class T>
void copyPlace(Plane<T>& to, const Plane<T>& from, const SampleGrid& grid, uint32_t column, uint32_t row) {
  const size_t pixel = size_t{to.samples} * to.components;
  for (uint32_t y = row; y < to.height; y += grid.height()) {
    for (uint32_t x = column; x < to.width; x += grid.width()) {
      const auto at = static_cast<std::ptrdiff_t>(to.index(x, y, 0));
      std::copy_n(from.data.begin() + at, pixel, to.data.begin() + at);
    }
  }
}

void copyPlace(Frame& to, const Frame& from, const SampleGrid& grid, uint32_t column, uint32_t row) {
  const auto copy = [&](auto& plane, const auto& other) { copyPlace(plane, other, grid, column, row); };
  copy(to.primitive, from.primitive);
  copy(to.count, from.count);
  if (to.depth) copy(*to.depth, *from.depth);
  if (to.coverage) copy(*to.coverage, *from.coverage);
  if (to.depthBounds) copy(*to.depthBounds, *from.depthBounds);
  const auto copyAll = [&](std::vector<VaryingPlane>& planes, const std::vector<VaryingPlane>& others) {
    for (size_t i = 0; i < planes.size(); ++i) {
      copy(planes[i].values, others[i].values);
      if (planes[i].bounds) copy(*planes[i].bounds, *others[i].bounds);
    }
  };
  copyAll(to.varyings, from.varyings);
  copyAll(to.resolved, from.resolved);
}

}  // namespace

Result<SampleGrid> SampleGrid::of(const Scene& scene, const Rules& rules) {
  const SampleLocationsInfo& info = *scene.target.sampleLocations;
  const std::string where = "target.sampleLocations";
  if (rules.limits.sampleLocationSubPixelBits > kSubpixelBits) {
    return fail(ErrorCode::NotOffered, where,
                fmt::format("{} sub-pixel bits of sample locations are more than the reference keeps",
                            rules.limits.sampleLocationSubPixelBits),
                fmt::format("at most {}", kSubpixelBits));
  }
  SampleGrid grid;
  grid.width_ = info.gridWidth;
  grid.height_ = info.gridHeight;
  const uint32_t samples = scene.target.samples;
  for (uint32_t row = 0; row < grid.height_; ++row) {
    for (uint32_t column = 0; column < grid.width_; ++column) {
      GridPixel& place = grid.places_.emplace_back(GridPixel{scene, rules});
      place.scene.target.sampleLocations.reset();
      if (rules.error == DeliberateError::SampleLocationsIgnored) continue;
      const size_t first = firstLocation(info, column, row, samples, rules.error);
      const std::span<SampleTables::Offset> table = place.rules.choices.sampleLocations.emplace().of(samples);
      for (size_t s = 0; s < samples; ++s) {
        bool exact = true;
        const SampleLocationEXT& location = info.sampleLocations[first + s];
        table[s] = {coordinate(location.x, rules, exact), coordinate(location.y, rules, exact)};
        if (!exact && rules.open) {
          return fail(ErrorCode::NotOffered, fmt::format("{}.sampleLocations[{}]", where, first + s),
                      fmt::format("({}, {}) lies between steps of 1/{} pixel, and Vulkan does not say where it goes",
                                  location.x, location.y, 1U << rules.limits.sampleLocationSubPixelBits),
                      "use multiples of the step, or a profile");
        }
      }
    }
  }
  return grid;
}

Result<Frame> renderGrid(const Scene& scene, const Rules& rules, RuleCounts* counts) {
  const Result<SampleGrid> grid = SampleGrid::of(scene, rules);
  if (!grid) return tl::unexpected<Error>(grid.error());
  RuleCounts sum;
  Frame frame;
  for (uint32_t row = 0; row < grid->height(); ++row) {
    for (uint32_t column = 0; column < grid->width(); ++column) {
      const GridPixel& place = grid->at(column, row);
      Result<Frame> part = render(place.scene, place.rules, &sum);
      if (!part) return part;
      if (row == 0 && column == 0) {
        frame = std::move(*part);
      } else {
        copyPlace(frame, *part, *grid, column, row);
      }
    }
  }
  if (counts != nullptr) {
    for (uint64_t& decided : sum.decided) decided /= uint64_t{grid->width()} * grid->height();
    sum[Rule::CustomLocations] += sum[Rule::SamplePattern];
    *counts += sum;
  }
  return frame;
}

Result<std::vector<std::vector<Candidate>>> gridCandidates(const Scene& scene, const Rules& rules,
                                                           std::span<const SampleQuery> queries) {
  const Result<SampleGrid> grid = SampleGrid::of(scene, rules);
  if (!grid) return tl::unexpected<Error>(grid.error());
  std::vector<std::vector<Candidate>> found(queries.size());
  for (uint32_t row = 0; row < grid->height(); ++row) {
    for (uint32_t column = 0; column < grid->width(); ++column) {
      std::vector<SampleQuery> here;
      std::vector<size_t> numbers;
      for (size_t q = 0; q < queries.size(); ++q) {
        if (queries[q].x % grid->width() != column || queries[q].y % grid->height() != row) continue;
        here.push_back(queries[q]);
        numbers.push_back(q);
      }
      if (here.empty()) continue;
      const GridPixel& place = grid->at(column, row);
      auto part = candidates(place.scene, place.rules, here);
      if (!part) return part;
      for (size_t i = 0; i < numbers.size(); ++i) found[numbers[i]] = std::move((*part)[i]);
    }
  }
  return found;
}

}  // namespace rasterdiff::rasterizer
