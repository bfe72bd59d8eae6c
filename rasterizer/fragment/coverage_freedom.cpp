#include "rasterizer/fragment/coverage_freedom.hpp"

#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

void CoverageFreedom::setUp(const Primitive& primitive, const Figure* figure) {
  primitive_ = &primitive;
  figure_ = figure;
  band_.reset();
}

CoverageFreedom::Masks CoverageFreedom::masks(const FragmentPlace& place, std::span<const SubpixelPosition> pattern) {
  if (figure_ == nullptr && !band_) band_.emplace(*primitive_, cullMode_, frontFace_);
  Masks masks;
  for (uint32_t s = 0; s < pattern.size(); ++s) {
    const int64_t px = int64_t{place.x} * kSubpixelOne + pattern[s].x, py = int64_t{place.y} * kSubpixelOne + pattern[s].y;
    const Coverage coverage = (figure_ != nullptr ? figure_->shape->classify(px, py) : band_->classify(px, py)).coverage;
    if (coverage != Coverage::Out) masks.possible |= 1U << s;
    if (coverage == Coverage::In) masks.certain |= 1U << s;
  }
  if (primitive_->cut) masks.certain = 0;
  return masks;
}

}  // namespace rasterdiff::rasterizer
