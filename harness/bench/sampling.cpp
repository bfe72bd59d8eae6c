#include "harness/bench/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/bench/statistics.hpp"
#include "rasterizer/methods/exact_area.hpp"
#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/method_table.hpp"
#include "rasterizer/methods/sampling_methods.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterizer::PixelIndex;
using rasterizer::SnappedTriangle;

struct Border {
  SnappedTriangle triangle;
  PixelIndex pixel;
};

/// Partly covered pixels.
std::vector<Border> borders(size_t wanted) {
  std::vector<Border> all;
  Prng prng(1);
  while (all.size() < wanted) {
    const SnappedTriangle t = rasterizer::mediumTriangle(prng);
    const auto [left, right] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
    const auto [top, bottom] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
    for (int32_t y = top >> kSubpixelBits; y <= bottom >> kSubpixelBits; ++y) {
      for (int32_t x = left >> kSubpixelBits; x <= right >> kSubpixelBits; ++x) {
        const double area = rasterizer::coveredArea(t, {x, y}).pixels();
        if (area > 0 && area < 1) all.push_back({t, {x, y}});
      }
    }
  }
  return all;
}

/// Seconds of one pixel; `cover` returns something that depends on all of its work.
template <class Cover>
double secondsOfPixel(const std::vector<Border>& pixels, size_t count, const Cover& cover) {
  double sum = 0;
  const double seconds = secondsOf([&] {
    for (size_t i = 0; i < count; ++i) sum += cover(pixels[i]);
  });
  return sum < 0 ? 0 : seconds / static_cast<double>(count);  // never below 0: the sum is needed
}

}  // namespace

std::vector<SamplingRow> measureSampling(const Settings& settings, const Progress& progress) {
  progress("sampling: errors");
  std::vector<rasterizer::MethodRow> errors;
  rasterizer::measureSampling({}, errors);
  const std::vector<Border> pixels = borders(2000);
  std::vector<SamplingRow> rows;
  std::vector<std::function<double()>> clocks;
  for (const rasterizer::SamplingMethod& method : rasterizer::samplingMethods()) {
    SamplingRow row;
    row.method = method.name;
    row.samples = static_cast<uint32_t>(method.points.offsets.size());
    for (const rasterizer::MethodRow& error : errors) {
      if (error.family != "sampling" || error.method != method.name || error.hard) continue;
      row.pixels = error.cases, row.wrong = error.wrongSamples, row.maxError = error.maxError, row.rmsError = error.rmsError;
    }
    rows.push_back(row);
    const size_t count = std::max<size_t>(100, pixels.size() / row.samples);
    clocks.push_back([&pixels, &method, count] {
      return secondsOfPixel(pixels, count, [&](const Border& b) {
        return static_cast<double>(rasterizer::coveredSamples(b.triangle, method.points, b.pixel));
      });
    });
  }
  SamplingRow exact;
  exact.method = "exact-area";
  exact.pixels = rows.empty() ? 0 : rows.front().pixels;
  rows.push_back(exact);
  clocks.push_back([&pixels] {
    return secondsOfPixel(pixels, pixels.size(), [](const Border& b) { return rasterizer::coveredArea(b.triangle, b.pixel).pixels(); });
  });
  std::vector<std::vector<double>> seconds(rows.size());
  for (uint32_t round = 0; round < settings.rounds + 1; ++round) {
    progress(fmt::format("sampling: round {} of {}", round, settings.rounds));
    for (size_t i = 0; i < rows.size(); ++i) {
      const double one = clocks[i]();
      if (round > 0) seconds[i].push_back(one);  // the first one warms up
    }
  }
  for (size_t i = 0; i < rows.size(); ++i) rows[i].timing = timingOf(seconds[i], 1);
  return rows;
}

}  // namespace rasterdiff::harness::bench
