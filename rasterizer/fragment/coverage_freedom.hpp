// Which bits a fragment's coverage mask must and may have: the three-valued coverage of one primitive, one pixel at a
// time, for the values that depend on masks. [vk:primsrast-multisampling-coverage-mask]
#pragma once

#include <optional>

#include "rasterizer/fragment/place.hpp"
#include "rasterizer/freedom_band.hpp"
#include "rasterizer/geometry.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

class CoverageFreedom {
 public:
  struct Masks {
    uint32_t certain = 0, possible = 0;
  };

  explicit CoverageFreedom(const State& state) : cullMode_(state.cullMode), frontFace_(state.frontFace) {}

  /// `figure` is null for a filled triangle. Both have to live until the next call.
  void setUp(const Primitive& primitive, const Figure* figure);

  /// At the pixel of `place`. A cut triangle's pieces may be fragments of their own: none of its bits is certain.
  [[nodiscard]] Masks masks(const FragmentPlace& place, std::span<const SubpixelPosition> pattern);

 private:
  const CullMode cullMode_;
  const FrontFace frontFace_;
  const Primitive* primitive_ = nullptr;
  const Figure* figure_ = nullptr;
  std::optional<FreedomBand> band_;  // made when first asked for
};

}  // namespace rasterdiff::rasterizer
