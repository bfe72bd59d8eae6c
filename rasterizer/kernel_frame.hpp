// Scenes of filled triangles that need who covers what, how deep, and inputs that may wait: they go to the fast kernels, band by band
// when the last triangle is known, by several threads. What is not the kernels' rule stays with FrameWriter.
#pragma once

#include <optional>

#include "rasterizer/kernel_band.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::rasterizer {

class KernelFrame {
 public:
  /// None where the frame has other planes, a rule is open, mistaken or not the kernels' (ties: top-left; samples: the standard
  /// ones; depth: float32, tested by LESS and written), or something else than the target's border cuts. `pattern`: sample offsets in 1/256 pixel.
  [[nodiscard]] static std::optional<KernelFrame> of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern);

  /// All planes, on `threads` threads (at least 1): the same for any number. Adds to `counts`, if given, what drawing row by row
  /// counts. None where snapping folded a cut polygon that is not drawn as a fan, or whose overlapping pieces leave open which values a
  /// sample has. `drawn` may be empty.
  [[nodiscard]] std::optional<Frame> draw(unsigned threads, RuleCounts* counts, const RowsDrawn& drawn) const;

 private:
  KernelFrame(const Scene& scene, const SceneNeeds& needs, const Rules& rules, std::span<const SubpixelPosition> pattern)
      : scene_(scene), needs_(needs), rules_(rules), pattern_(pattern.begin(), pattern.end()) {}

  const Scene& scene_;
  const SceneNeeds needs_;
  const Rules& rules_;
  std::vector<SubpixelPosition> pattern_;
};

}  // namespace rasterdiff::rasterizer
