#include "harness/bench/truth.hpp"

#include <algorithm>
#include <bit>

#include "harness/compare/ulp.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterizer::CoverageMask;
using rasterizer::SnappedTriangle;

/// Pixels [x0, x1] × [y0, y1] of a triangle's box inside the target; empty where x0 > x1 or y0 > y1.
struct Box {
  int32_t x0, y0, x1, y1;
};

Box boxOf(const SnappedTriangle& t, const Load& load) {
  const auto [left, right] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
  const auto [top, bottom] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  return {std::max(0, left >> kSubpixelBits), std::max(0, top >> kSubpixelBits),
          std::min(static_cast<int32_t>(load.width) - 1, right >> kSubpixelBits),
          std::min(static_cast<int32_t>(load.height) - 1, bottom >> kSubpixelBits)};
}

double samplesIn(const Box& box, uint32_t samples) {
  return box.x0 > box.x1 || box.y0 > box.y1 ? 0 : (double{1} * box.x1 - box.x0 + 1) * (double{1} * box.y1 - box.y0 + 1) * samples;
}

/// Which squares of 8 × 8 pixels a batch has used.
class Occupancy {
 public:
  Occupancy(uint32_t width, uint32_t height) : columns_(width / 8 + 1), used_(size_t{columns_} * (height / 8 + 1)) {}
  /// Marks the box's squares if none of them is used.
  bool take(const Box& box) {
    for (int32_t y = box.y0 / 8; y <= box.y1 / 8; ++y)
      for (int32_t x = box.x0 / 8; x <= box.x1 / 8; ++x)
        if (used_[at(x, y)]) return false;
    for (int32_t y = box.y0 / 8; y <= box.y1 / 8; ++y)
      for (int32_t x = box.x0 / 8; x <= box.x1 / 8; ++x) used_[at(x, y)] = true;
    return true;
  }

 private:
  [[nodiscard]] size_t at(int32_t x, int32_t y) const { return static_cast<size_t>(y) * columns_ + static_cast<size_t>(x); }
  uint32_t columns_;
  std::vector<bool> used_;
};

}  // namespace

Truth::Truth(const Load& load, double boxSamples) : load_(load) {
  // A batch costs a mask; small triangles share one.
  const double perTriangle = double{1} * load.width * load.height * load.samples / 32 / 64;
  double sum = 0;
  while (triangles_ < load.triangles.size()) {
    sum += samplesIn(boxOf(load.triangles[triangles_], load), load.samples) + std::min(perTriangle, 100.0 * load.samples);
    if (triangles_ > 0 && sum > boxSamples) break;
    ++triangles_;
  }
}

std::vector<std::vector<SnappedTriangle>> Truth::batches() const {
  std::vector<SnappedTriangle> waiting(load_.triangles.begin(), load_.triangles.begin() + static_cast<ptrdiff_t>(triangles_));
  std::vector<std::vector<SnappedTriangle>> all;
  while (!waiting.empty()) {
    Occupancy occupancy(load_.width, load_.height);
    std::vector<SnappedTriangle> batch, later;
    for (const SnappedTriangle& t : waiting) (occupancy.take(boxOf(t, load_)) ? batch : later).push_back(t);
    all.push_back(std::move(batch));
    waiting = std::move(later);
  }
  return all;
}

Result<std::vector<ErrorCount>> Truth::masks(std::span<const DrawMask> methods) const {
  Result<CoverageMask> expected = CoverageMask::create(load_.width, load_.height, load_.samples);
  if (!expected) return tl::unexpected(expected.error());
  CoverageMask mask = *expected;
  std::vector<ErrorCount> errors(methods.size());
  for (const std::vector<SnappedTriangle>& batch : batches()) {
    expected->clear();
    rasterizer::drawCoverageOracle(batch, *expected);
    const uint64_t covered = expected->count();
    for (size_t i = 0; i < methods.size(); ++i) {
      mask.clear();
      methods[i](batch, mask);
      errors[i].wrong += mask.differing(*expected);
      errors[i].covered += covered;
      errors[i].triangles += batch.size();
    }
  }
  return errors;
}

void UlpSum::add(float expected, float actual) {
  const double ulp = std::bit_cast<uint32_t>(expected) == std::bit_cast<uint32_t>(actual) ? 0 : ulpDistance(expected, actual);
  ++count, sum += ulp, most = std::max(most, ulp);
}

void UlpSum::put(ErrorCount& error) const {
  error.values = count;
  error.maxUlp = most;
  error.meanUlp = count == 0 ? 0 : sum / static_cast<double>(count);
}

ErrorCount difference(const Frame& expected, const Frame& actual) {
  ErrorCount error;
  UlpSum ulps;
  for (size_t k = 0; k < expected.primitive.data.size(); ++k) {
    error.covered += expected.count.data[k];
    const bool same = expected.primitive.data[k] == actual.primitive.data[k];
    if (!same || expected.count.data[k] != actual.count.data[k]) ++error.wrong;
    if (!same || expected.primitive.data[k] == 0) continue;
    if (expected.depth && actual.depth) ulps.add(expected.depth->data[k], actual.depth->data[k]);
    for (size_t v = 0; v < std::min(expected.varyings.size(), actual.varyings.size()); ++v) {
      const Plane<float>& wanted = expected.varyings[v].values;
      for (size_t c = 0; c < wanted.components; ++c) {
        const size_t at = k * wanted.components + c;
        ulps.add(wanted.data[at], actual.varyings[v].values.data[at]);
      }
    }
  }
  ulps.put(error);
  return error;
}

}  // namespace rasterdiff::harness::bench
