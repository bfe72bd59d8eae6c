#include "rasterizer/kernel_coverage.hpp"

#include <algorithm>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "scene/needs.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint64_t kFewTriangles = 1000;  // drawn one by one sooner than a second pair of planes is made and read

bool ownsTopLeft(const Choices& choices) {
  return choices.tieOwner == TieOwner::TopLeft && choices.slantedTies == SlantedTies::LikeVertical && choices.tieWinding == TieWinding::Same;
}

bool needsCoverageOnly(const Scene& scene) {
  const SceneNeeds needs = needsOf(scene);
  const uint32_t all = (1U << scene.target.samples) - 1;
  return !needs.depth && needs.varyings == 0 && needs.builtIns == 0 &&
         (scene.state.sampleMask & all) == all && scene.state.shaderSampleMask == ShaderSampleMask::NONE;
}

bool drawsManyTriangles(const Scene& scene) {
  return fillsTriangles(scene.state) && primitiveCount(scene) > kFewTriangles;
}

bool onlyTargetCuts(const Scene& scene, const Rules& rules) {
  const PixelArea whole = wholeTarget(scene);
  for (uint32_t index = 0; index <= scene.furtherViewports.size(); ++index) {
    const PixelArea area = drawingRegion(scene, index, rules).area;
    if (area.left != whole.left || area.top != whole.top || area.right != whole.right || area.bottom != whole.bottom) return false;
  }
  return true;
}

bool sameLocations(std::span<const SampleLocation> locations, std::span<const SubpixelPosition> pattern) {
  return std::ranges::equal(locations, pattern, [](const SampleLocation& location, const SubpixelPosition& offset) {
    return location.x * kSampleUnit == offset.x && location.y * kSampleUnit == offset.y;
  });
}

}  // namespace

std::optional<KernelCoverage> KernelCoverage::of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern) {
  const bool ruled = !rules.open && rules.error == DeliberateError::None && !rules.variation && ownsTopLeft(rules.choices);
  if (!ruled || !needsCoverageOnly(scene) || !drawsManyTriangles(scene) || !onlyTargetCuts(scene, rules)) return std::nullopt;
  if (rules.choices.cutFill != CutFill::Fan && mayClip(scene)) return std::nullopt;  // a cut polygon may be folded
  ValueNeeds needs;
  needs.primitive = needs.count = true;
  Result<ValueTarget> target = ValueTarget::create(scene.target.width, scene.target.height, scene.target.samples, needs);
  if (!target || !sameLocations(target->locations(), pattern)) return std::nullopt;
  return KernelCoverage(std::move(*target));
}

void KernelCoverage::add(const Primitive& primitive, const SetupTriangle& piece) {
  const auto corner = [&](size_t i) { return primitive.polygon[piece.corner[i]].snapped; };
  pieces_.push_back({{corner(0), corner(1), corner(2)}});
  primitives_.push_back(primitive.number);
}

void KernelCoverage::drawInto(Frame& frame, RuleCounts& counts) {
  ValueTriangles triangles;
  triangles.positions = pieces_;
  drawValues(triangles, target_);
  uint64_t drawn = 0, covered = 0;
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t s = 0; s < frame.samples; ++s) {
      const uint32_t* const pieces = target_.primitive.data() + target_.index(0, y, s);
      const uint32_t* const count = target_.count.data() + target_.index(0, y, s);
      const size_t to = frame.primitive.index(0, y, s);
      for (uint32_t x = 0; x < frame.width; ++x) {
        if (pieces[x] == 0) continue;
        const size_t i = to + size_t{x} * frame.samples;
        frame.primitive.data[i] = primitives_[pieces[x] - 1];
        frame.count.data[i] = count[x];
        drawn += count[x];
        ++covered;
      }
    }
  }
  counts[Rule::Order] += drawn - covered;
}

}  // namespace rasterdiff::rasterizer
