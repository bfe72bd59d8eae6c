#include "rasterizer/fragment_replay.hpp"

#include "rasterizer/depth_test.hpp"
#include "rasterizer/fragment/alpha_to_coverage.hpp"

namespace rasterdiff::rasterizer {

FragmentReplay::FragmentReplay(const Scene& scene, const Rules& rules, SampleQuery query, SubpixelPosition position)
    : scene_(scene), query_(query), x_(position.x / double{kSubpixelOne}), y_(position.y / double{kSubpixelOne}),
      values_(scene, needsOf(scene), rules), shaderMask_(scene), buffer_(values_.componentCount()) {
  if (scene.target.depthFormat) stored_ = clearedDepth(scene.target.depthClearValue, *scene.target.depthFormat).value;
}

FragmentFate FragmentReplay::pass(uint32_t primitive) {
  const State& state = scene_.state;
  FragmentFate fate;
  fate.replaced = owner_;
  const bool alpha = state.alphaToCoverageEnable && buffer_.size() > 3;
  const auto x = static_cast<int32_t>(query_.x), y = static_cast<int32_t>(query_.y);
  const uint32_t covered = alpha || shaderMask_.writes() ? values_.coveredSamples(x, y) & state.sampleMask : 0;
  if (shaderMask_.writes()) fate.shaderMask = shaderMask_.written(query_.sample, covered);
  if (alpha) {
    values_.fragment({x, y, query_.sample, covered}, buffer_.data());
    fate.alpha = buffer_[3].value;
  }
  if (scene_.target.depthFormat) {
    fate.depth = values_.depth(x_, y_).value;
    fate.stored = stored_;
  }
  if ((state.sampleMask & (1U << query_.sample)) == 0) {
    fate.end = FragmentFate::End::Masked;
  } else if (!shaderMask_.nominallyKeeps(query_.sample, covered)) {
    fate.end = FragmentFate::End::ShaderMasked;
  } else if (alpha && !alphaCovers(fate.alpha, query_.sample, scene_.target.samples)) {
    fate.end = FragmentFate::End::AlphaDropped;
  } else if (state.depthTestEnable && scene_.target.depthFormat &&
             !depthTestPasses(state.depthCompareOp, fate.depth, stored_)) {
    fate.end = FragmentFate::End::DepthFailed;
  } else {
    fate.end = FragmentFate::End::Written;
    owner_ = primitive;
    if (state.depthTestEnable && state.depthWriteEnable && scene_.target.depthFormat) stored_ = fate.depth;
  }
  return fate;
}

}  // namespace rasterdiff::rasterizer
