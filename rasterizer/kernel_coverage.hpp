// Scenes that need nothing but who covers what: their pieces are drawn by the fast kernel, all at once when the last one is
// known. What does not pay or is not the kernel's rule stays with FrameWriter.
#pragma once

#include <optional>
#include <vector>

#include "rasterizer/geometry.hpp"
#include "rasterizer/kernels/value_target.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

class KernelCoverage {
 public:
  /// None where the frame has other planes, a rule is open, mistaken or not the kernel's (ties: top-left; samples: the
  /// standard ones), something else than the target's border cuts, cut polygons are not drawn as fans, or there are too few triangles for it to pay.
  [[nodiscard]] static std::optional<KernelCoverage> of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern);

  void add(const Primitive& primitive, const SetupTriangle& piece);

  /// Fills the primitive and count planes, which have to be clear.
  void drawInto(Frame& frame, RuleCounts& counts);

 private:
  explicit KernelCoverage(ValueTarget target) : target_(std::move(target)) {}

  ValueTarget target_;
  std::vector<SnappedTriangle> pieces_;
  std::vector<uint32_t> primitives_;  ///< of each piece
};

}  // namespace rasterdiff::rasterizer
