#include "rasterizer/drawing_region.hpp"

#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

constexpr int32_t kTile = 64;  // pixels
constexpr PixelArea kNoBorder{-(1 << 30), -(1 << 30), 1 << 30, 1 << 30};

PixelArea both(const PixelArea& a, const PixelArea& b) {
  const PixelArea area{std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
  return area.left < area.right && area.top < area.bottom ? area : PixelArea{};
}

// Borders are rounded in float32 such that a pixel is inside when its centre is, and cut to whole numbers toward zero.
PixelArea wholePixels(const Viewport& viewport) {
  const float halfWidth = viewport.width / 2, halfHeight = viewport.height / 2;
  const float left = (viewport.x + halfWidth) - halfWidth, top = (viewport.y + halfHeight) - std::fabs(halfHeight);
  const auto pixel = [](float v) { return static_cast<int32_t>(std::clamp(v, -0x1p24F, 0x1p24F)); };
  return {pixel(left + 0.499F), pixel(top + 0.499F), pixel(halfWidth * 2 + left - 0.501F) + 1,
          pixel(std::fabs(halfHeight) * 2 + top - 0.501F) + 1};
}

}  // namespace

SampleArea DrawingRegion::of(const PixelBox& box) const {
  SampleArea result{area};
  if (!leaky) return result;
  const bool meets = box.left < area.right && box.right >= area.left && box.top < area.bottom && box.bottom >= area.top;
  if (!meets) return {};
  const bool cutsLeft = std::max(box.left, 0) < area.left, cutsTop = std::max(box.top, 0) < area.top;
  if (!cutsLeft) result.area.left = kNoBorder.left;
  if (!cutsTop) result.area.top = kNoBorder.top;
  if (box.right < area.right) result.area.right = kNoBorder.right;
  if (box.bottom < area.bottom) result.area.bottom = kNoBorder.bottom;
  result.leaksLeft = cutsLeft && area.left % kTile != 0;
  result.leaksTop = cutsTop && area.top % kTile != 0;
  return result;
}

SampleArea DrawingRegion::of(const SubpixelBox& box) const {
  const auto pixel = [](int32_t v) { return v >> kSubpixelBits; };
  return of(PixelBox{pixel(box.low.x), pixel(box.low.y), pixel(box.high.x - 1), pixel(box.high.y - 1)});
}

SampleArea DrawingRegion::of(const Primitive& primitive, const SetupTriangle& piece) const {
  return of(primitive.folded ? SubpixelBox(primitive) : SubpixelBox(primitive, piece));
}

DrawingRegion drawingRegion(const Scene& scene, uint32_t index, const Rules& rules) {
  DrawingRegion region{targetArea(scene, index, rules.error)};
  if (rules.choices.drawingRegion == DrawingRegionRule::Scissor) return region;
  region.leaky = scene.target.samples > 1;
  if (index == 0) region.area = both(region.area, wholePixels(scene.viewport));
  return region;
}

}  // namespace rasterdiff::rasterizer
