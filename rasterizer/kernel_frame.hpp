// Scenes of filled triangles that need who covers what, how deep, and inputs that may wait: they go to the fast kernels, band by band
// when the last triangle is known, by several threads. What is not the kernels' rule stays with FrameWriter.
#pragma once

#include <optional>

#include "rasterizer/kernel_band.hpp"
#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::rasterizer {

class KernelFrame {
 public:
  /// None where the frame has other planes, a rule is open, mistaken or not the kernels' (ties: top-left; samples: the standard
  /// ones; depth: float32, tested by LESS and written), something else than the target's border cuts, or cut polygons are not
  /// drawn as fans. `pattern`: sample offsets in 1/256 pixel.
  [[nodiscard]] static std::optional<KernelFrame> of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern);

  /// All planes, on `threads` threads (at least 1): the same for any number. Adds to `counts`, if given, what drawing row by row
  /// counts. None where pieces of one cut polygon overlap, so that a sample may have the values of either.
  [[nodiscard]] std::optional<Frame> draw(unsigned threads, RuleCounts* counts) const;

 private:
  KernelFrame(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern)
      : scene_(scene), rules_(rules), pattern_(pattern.begin(), pattern.end()) {}

  const Scene& scene_;
  const Rules& rules_;
  std::vector<SubpixelPosition> pattern_;
};

}  // namespace rasterdiff::rasterizer
