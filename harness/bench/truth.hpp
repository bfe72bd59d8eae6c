// The exact answer that contenders are held against before a clock starts: coverage by definition (integer edge functions at
// every sample), on as many of a load's first triangles as can be afforded.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "harness/bench/load.hpp"
#include "rasterizer/kernels/coverage_mask.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::harness::bench {

/// Adds the coverage of triangles to a mask.
using DrawMask = std::function<void(std::span<const rasterizer::SnappedTriangle>, rasterizer::CoverageMask&)>;

class Truth {
 public:
  /// Takes the first triangles whose boxes together hold up to `boxSamples` samples (at least one triangle).
  Truth(const Load& load, double boxSamples);

  /// How many triangles are looked at.
  [[nodiscard]] size_t triangles() const { return triangles_; }

  /// Each method draws the triangles in batches that do not touch one another: in one mask, later triangles would hide
  /// the mistakes of earlier ones. Error: a mask of this size cannot be made.
  [[nodiscard]] Result<std::vector<ErrorCount>> masks(std::span<const DrawMask> methods) const;

 private:
  [[nodiscard]] std::vector<std::vector<rasterizer::SnappedTriangle>> batches() const;

  const Load& load_;
  size_t triangles_ = 0;
};

/// Adds up how far values are off.
struct UlpSum {
  uint64_t count = 0;
  double sum = 0, most = 0;
  void add(float expected, float actual);
  void put(ErrorCount& error) const;
};

/// Samples and values of `actual` that differ from `expected`, both of one scene: coverage, count and primitive, then
/// depth and varyings in ULPs where the primitive is the same.
[[nodiscard]] ErrorCount difference(const Frame& expected, const Frame& actual);

}  // namespace rasterdiff::harness::bench
