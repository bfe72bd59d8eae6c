// Two ways to say the same: indices or none, a list or a strip, one scissor or two halves, one viewport or another index.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/invariants/agreement.hpp"

namespace rasterdiff::harness::invariants {
namespace {

using enum PrimitiveTopology;

/// Vertices stored in another order, and indices that bring them back.
Draw shuffled(const Draw& draw, Prng& random) {
  const size_t count = draw.positions.size();
  std::vector<uint32_t> stored(count);  // stored[i]: where vertex i goes
  for (uint32_t i = 0; i < count; ++i) stored[i] = i;
  for (size_t i = count; i > 1; --i) std::swap(stored[i - 1], stored[random.below(i)]);
  Draw result = draw;
  result.indices = stored;
  const auto move = [&](const std::vector<float>& from, std::vector<float>& to, size_t each) {
    for (size_t i = 0; i < from.size(); ++i) to[stored[i / each] * each + i % each] = from[i];
  };
  for (size_t i = 0; i < count; ++i) result.positions[stored[i]] = draw.positions[i];
  move(draw.pointSizes, result.pointSizes, 1);
  if (draw.clipDistanceCount > 0) move(draw.clipDistances, result.clipDistances, draw.clipDistanceCount);
  if (draw.cullDistanceCount > 0) move(draw.cullDistances, result.cullDistances, draw.cullDistanceCount);
  for (size_t v = 0; v < draw.varyings.size(); ++v) move(draw.varyings[v].values, result.varyings[v].values, draw.varyings[v].components);
  return result;
}

Case indexed(Prng& random, const Limits& limits) {
  Scene scene = validScene("any", random, limits);
  scene.state.primitiveRestartEnable = false;
  for (Draw& draw : scene.draws) draw.indices.reset();
  Scene other = scene;
  for (Draw& draw : other.draws) draw = shuffled(draw, random);
  return pairOf(std::move(scene), std::move(other), sameBytes);
}

/// [vk:drawing-primitive-topologies] with the provoking vertex first.
std::vector<ClipPosition> asList(PrimitiveTopology topology, const std::vector<ClipPosition>& p) {
  std::vector<ClipPosition> result;
  for (size_t i = 0; i + 2 < p.size(); ++i) {
    if (topology == TRIANGLE_FAN) {
      result.insert(result.end(), {p[i + 1], p[i + 2], p[0]});
    } else if (i % 2 == 0) {
      result.insert(result.end(), {p[i], p[i + 1], p[i + 2]});
    } else {
      result.insert(result.end(), {p[i], p[i + 2], p[i + 1]});
    }
  }
  return result;
}

Case listAgainst(PrimitiveTopology topology, Prng& random, const Limits& limits) {
  Scene scene = validScene("fill", random, limits);
  if (random.chance(60)) scene.state.cullMode = random.chance(50) ? CullMode::FRONT : CullMode::BACK;
  scene.state.topology = topology;
  scene.state.primitiveRestartEnable = false;
  Scene other = scene;
  other.state.topology = TRIANGLE_LIST;
  for (size_t d = 0; d < scene.draws.size(); ++d) {
    scene.draws[d] = Draw{.positions = scene.draws[d].positions};
    while (scene.draws[d].positions.size() < 3) scene.draws[d].positions.push_back(scene.draws[d].positions.front());
    other.draws[d] = Draw{.positions = asList(topology, scene.draws[d].positions)};
  }
  scene.builtIns.clear();
  other.builtIns.clear();
  return pairOf(std::move(scene), std::move(other), sameCoverage);
}

Case listStrip(Prng& random, const Limits& limits) { return listAgainst(TRIANGLE_STRIP, random, limits); }
Case listFan(Prng& random, const Limits& limits) { return listAgainst(TRIANGLE_FAN, random, limits); }

/// The whole target, then its left and its right part through a scissor each.
Case scissorSplit(Prng& random, const Limits& limits) {
  Scene whole = validScene("any", random, limits);
  whole.scissor.reset();
  whole.furtherViewports.clear();
  for (Draw& draw : whole.draws) draw.viewportIndex = 0;
  whole.target.width = std::max(whole.target.width, 2U);
  const uint32_t split = 1 + random.below(whole.target.width - 1);
  Scene left = whole, right = whole;
  left.scissor = Rect2D{0, 0, split, whole.target.height};
  right.scissor = Rect2D{static_cast<int32_t>(split), 0, whole.target.width - split, whole.target.height};
  Case result;
  result.scenes = {std::move(whole), std::move(left), std::move(right)};
  result.agree = [split](std::span<const Frame> frames) {
    return checkSamples(frames[0], [&](size_t i, uint32_t x, uint32_t) -> std::string {
      const bool isLeft = x < split;
      const uint32_t all = frames[0].count.data[i], inside = frames[isLeft ? 1 : 2].count.data[i], outside = frames[isLeft ? 2 : 1].count.data[i];
      if (outside != 0) return fmt::format("drawn {} times outside the scissor that begins or ends at x = {}", outside, split);
      if (inside != all) return fmt::format("drawn {} times without a scissor, {} times inside one", all, inside);
      return {};
    });
  };
  return result;
}

/// The same viewport as number 0, and as number 1 beside another one.
Case viewportIndex(Prng& random, const Limits& limits) {
  Scene scene = validScene("any", random, limits);
  scene.furtherViewports.clear();
  for (Draw& draw : scene.draws) draw.viewportIndex = 0;
  Scene other = scene;
  other.furtherViewports = {{scene.viewport, scene.scissor}};
  other.viewport.x += 3;
  other.viewport.y -= 2;
  for (Draw& draw : other.draws) draw.viewportIndex = 1;
  return pairOf(std::move(scene), std::move(other), sameBytes);
}

constexpr std::array kInvariants{
    Invariant{"indexed", "R49", "vk:drawing-primitive-order", "shuffled vertices and the indices that undo it give the same bytes", indexed},
    Invariant{"list-strip", "R15", "vk:drawing-triangle-strips", "a strip covers what the list of its triangles covers", listStrip},
    Invariant{"list-fan", "R15", "vk:drawing-triangle-fans", "a fan covers what the list of its triangles covers", listFan},
    Invariant{"scissor-split", "R39", "vk:fragops-scissor", "the two halves of a scissor share out what is drawn without one", scissorSplit},
    Invariant{"viewport-index", "R2", "vk:vertexpostproc-viewport", "the number of a viewport does not matter: the same bytes", viewportIndex},
};

}  // namespace

std::span<const Invariant> equivalenceInvariants() { return kInvariants; }

}  // namespace rasterdiff::harness::invariants
