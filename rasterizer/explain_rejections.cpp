// Primitives that were rejected before rasterization: by a plane, a distance, their facing, or for want of an area.
#include <algorithm>
#include <bit>

#include "rasterizer/assembly.hpp"
#include "rasterizer/clip.hpp"
#include "rasterizer/explain.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr std::array<std::string_view, kVolumePlanes> kPlanes{
    "the right plane of the view volume", "the left plane of the view volume", "the bottom plane of the view volume",
    "the top plane of the view volume",   "the near plane",                    "the far plane"};

struct Reason {
  Rule rule;
  std::string_view by;
};

class DrawReasons {
 public:
  DrawReasons(const Scene& scene, const Rules& rules, const Draw& draw)
      : scene_(scene), rules_(rules), draw_(draw), volume_(clipVolume(scene.state, draw, rules.error)) {}

  [[nodiscard]] Reason of(const AssembledTriangle& primitive) const {
    if (culledByDistance(primitive)) return {Rule::UserDistance, "a cull distance that is negative at all its vertices"};
    unsigned all = ~0U, any = 0;
    bool behind = false;
    for (uint32_t k = 0; k < primitive.count; ++k) {
      const unsigned code = codeOf(primitive.vertices[k]);
      all &= code;
      any |= code;
      behind = behind || draw_.positions[primitive.vertices[k]].w <= 0;
    }
    if (all != 0) {
      const auto plane = static_cast<size_t>(std::countr_zero(all));
      if (plane >= kPlanes.size()) return {Rule::UserDistance, "a clip distance that is negative at all its vertices"};
      if (primitive.count == 1) return {Rule::PointClip, kPlanes[plane]};
      return {plane >= 4 ? Rule::DepthClip : Rule::ViewVolume, kPlanes[plane]};
    }
    const Reason facing{Rule::Culling, "its facing, or no area after snapping"};
    if (any != 0 && scene_.state.cullMode != CullMode::NONE && leavesSome(primitive)) return facing;
    if (any != 0) return {primitive.count == 2 ? Rule::LineClip : Rule::ViewVolume, "several planes that together leave nothing of it"};
    if (behind) return {Rule::ViewVolume, "a w that is not positive"};
    if (primitive.count == 2) return {Rule::LineBresenham, "a length that leaves no pixel"};
    if (scene_.state.cullMode != CullMode::NONE) return facing;
    return {Rule::SampleCoverage, "no area after snapping"};
  }

 private:
  [[nodiscard]] ClipInput inputOf(uint32_t vertex) const {
    return {draw_.positions[vertex], std::span(draw_.clipDistances).subspan(size_t{vertex} * draw_.clipDistanceCount, volume_.distances)};
  }
  [[nodiscard]] unsigned codeOf(uint32_t vertex) const { return outcode(inputOf(vertex), volume_); }
  /// Does clipping leave something of a triangle?
  [[nodiscard]] bool leavesSome(const AssembledTriangle& primitive) const {
    if (primitive.count != 3) return false;
    const std::array<ClipInput, 3> triangle{inputOf(primitive.vertices[0]), inputOf(primitive.vertices[1]), inputOf(primitive.vertices[2])};
    ClipPolygon polygon;
    return clipTriangle(triangle, rules_.choices.clipArithmetic, volume_, polygon) != ClipOutcome::Rejected && polygon.size >= 3;
  }
  [[nodiscard]] bool culledByDistance(const AssembledTriangle& primitive) const {
    for (uint32_t d = 0; d < draw_.cullDistanceCount; ++d) {
      bool all = true;
      for (uint32_t k = 0; k < primitive.count; ++k) {
        all = all && draw_.cullDistances[size_t{primitive.vertices[k]} * draw_.cullDistanceCount + d] < 0;
      }
      if (all) return true;
    }
    return false;
  }

  const Scene& scene_;
  const Rules& rules_;
  const Draw& draw_;
  const ClipVolume volume_;
};

}  // namespace

std::vector<Rejection> explainRejections(const Scene& scene, const Rules& rules, const std::vector<uint32_t>& reached) {
  std::vector<Rejection> rejections;
  uint32_t number = 0;
  for (const Draw& draw : scene.draws) {
    const DrawReasons reasons(scene, rules, draw);
    for (const AssembledTriangle& primitive : assemble(draw, scene.state, rules.error)) {
      if (std::ranges::binary_search(reached, ++number)) continue;
      const Reason reason = reasons.of(primitive);
      auto same = std::ranges::find(rejections, reason.by, &Rejection::by);
      if (same == rejections.end()) same = rejections.insert(same, {reason.rule, reason.by, number, 0});
      ++same->count;
    }
  }
  return rejections;
}

}  // namespace rasterdiff::rasterizer
