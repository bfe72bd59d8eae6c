#include "scene/generators/random_state.hpp"

#include <algorithm>

#include "scene/generators/prng.hpp"

namespace rasterdiff {
namespace {

template <class Make>
void giveDistances(Scene& scene, uint32_t count, uint32_t Draw::*number, std::vector<float> Draw::*values, Make make) {
  for (Draw& draw : scene.draws) {
    draw.*number = count;
    (draw.*values).resize(draw.positions.size() * count);
    for (float& d : draw.*values) d = make();
  }
}

}  // namespace

void spreadOut(Scene& scene, float factor) {
  for (Draw& draw : scene.draws) {
    for (ClipPosition& p : draw.positions) {
      p.x *= factor;
      p.y *= factor;
    }
  }
}

void leaveDepthRange(Scene& scene, uint64_t seed) {
  Prng random(seed);
  for (Draw& draw : scene.draws) {
    for (ClipPosition& p : draw.positions) {
      const double depth = random.chance(3) ? random.below(2) : random.between(-0.5, 1.5);
      p.z = static_cast<float>(depth) * p.w;
    }
  }
}

void giveClipDistances(Scene& scene, uint64_t seed, uint32_t count) {
  Prng random(seed);
  const uint32_t negative = std::max(8u, 40 / std::max(1u, count));
  giveDistances(scene, count, &Draw::clipDistanceCount, &Draw::clipDistances, [&] {
    if (random.chance(10)) return 0.0f;
    const float size = static_cast<float>(random.between(1, 16)) / 16;
    return random.chance(negative) ? -size : size;
  });
}

void giveCullDistances(Scene& scene, uint64_t seed, uint32_t count) {
  Prng random(seed);
  giveDistances(scene, count, &Draw::cullDistanceCount, &Draw::cullDistances,
                [&] { return random.chance(10) ? 0.0f : random.chance(70) ? -0.5f : 1.0f; });
}

void giveCulling(Scene& scene, uint64_t seed) {
  Prng random(seed);
  const uint32_t kind = random.below(9);
  scene.state.cullMode = kind < 4 ? CullMode::FRONT : kind < 8 ? CullMode::BACK : CullMode::FRONT_AND_BACK;
  scene.state.frontFace = random.chance(50) ? FrontFace::CLOCKWISE : FrontFace::COUNTER_CLOCKWISE;
}

void giveScissor(Scene& scene, uint64_t seed) {
  Prng random(seed);
  Rect2D rect;
  rect.x = static_cast<int32_t>(random.below(scene.target.width));
  rect.y = static_cast<int32_t>(random.below(scene.target.height));
  const auto extent = [&](int32_t from, uint32_t whole) {
    return random.chance(6) ? 1 : 1 + random.below(whole - static_cast<uint32_t>(from));
  };
  rect.width = extent(rect.x, scene.target.width);
  rect.height = extent(rect.y, scene.target.height);
  scene.scissor = rect;
}

void giveMasks(Scene& scene, uint64_t seed) {
  Prng random(seed);
  const uint32_t all = (1U << scene.target.samples) - 1;
  scene.state.shaderSampleMask = random.chance(50) ? ShaderSampleMask::CONSTANT : ShaderSampleMask::INPUT_SHIFTED;
  for (Draw& draw : scene.draws) draw.shaderSampleMaskBits = 1 + random.below(all);
  if (random.chance(50)) scene.state.sampleMask = 1 + random.below(all);
}

void giveViewport(Scene& scene, uint64_t seed) {
  Prng random(seed);
  const double width = scene.target.width, height = scene.target.height;
  const auto at = [&](double lo, double hi) {  // half of them on the subpixel grid
    const double v = random.between(lo, hi);
    return static_cast<float>(random.chance(50) ? v : static_cast<double>(static_cast<int64_t>(v * 256)) / 256);
  };
  Viewport& v = scene.viewport;
  v.x = at(-width / 4, width / 2);
  v.y = at(-height / 4, height / 2);
  v.width = at(width / 8, width);
  v.height = at(height / 8, height);
  if (random.chance(50)) {
    v.y += v.height;
    v.height = -v.height;
  }
  if (random.chance(33)) {
    v.minDepth = static_cast<float>(random.between(0.0, 1.0));
    v.maxDepth = static_cast<float>(random.between(0.0, 1.0));
  }
}

void giveDepth(Scene& scene, uint64_t seed, DepthFormat format) {
  Prng random(seed);
  constexpr CompareOp kOps[]{CompareOp::LESS, CompareOp::LESS_OR_EQUAL, CompareOp::GREATER, CompareOp::GREATER_OR_EQUAL,
                             CompareOp::ALWAYS};
  scene.target.depthFormat = format;
  scene.target.depthClearValue = 0.5f;
  scene.state.depthTestEnable = true;
  scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = kOps[random.below(std::size(kOps))];
}

void giveDepthBias(Scene& scene, uint64_t seed) {
  Prng random(seed);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = static_cast<float>(random.between(-64, 64));
  scene.state.depthBiasSlopeFactor = static_cast<float>(random.between(-8, 8)) / 4;
  if (random.chance(33)) scene.state.depthBiasClamp = static_cast<float>(random.between(-0.01, 0.01));
}

void giveStipple(Scene& scene, uint64_t seed) {
  Prng random(seed);
  scene.state.stippledLineEnable = true;
  uint64_t bits = random.bits();
  if (random.chance(25)) bits &= random.bits() & random.bits();
  scene.state.lineStipplePattern = static_cast<uint16_t>(bits & 0xFFFF);
  scene.state.lineStippleFactor = random.chance(30) ? 1 + random.below(8) : 1;
}

}  // namespace rasterdiff
