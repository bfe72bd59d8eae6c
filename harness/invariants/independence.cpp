// What must not matter: repetition, the order of primitives that do not touch, values and depth that nothing tests.
// [vk:invariance]
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "harness/invariants/agreement.hpp"
#include "scene/camera/screen.hpp"

namespace rasterdiff::harness::invariants {
namespace {

Case repeated(Prng& random, const Limits& limits) {
  const Scene scene = validScene("any", random, limits);
  Case result;
  result.scenes = {scene, validScene("any", random, limits), scene};
  result.agree = [](std::span<const Frame> frames) { return sameBytes(frames[0], frames[2]); };
  return result;
}

/// One triangle a cell of 12 × 12 pixels, drawn in two orders.
Case order(Prng& random, const Limits& limits) {
  constexpr uint32_t kCells = 4, kCell = 12;
  Scene scene;
  scene.target.width = scene.target.height = kCells * kCell;
  scene.target.samples = (limits.framebufferSampleCounts & 4) != 0 && random.chance(60) ? 4 : 1;
  scene.viewport = {0, 0, kCells * kCell, kCells * kCell, 0, 1};
  std::vector<std::array<ClipPosition, 3>> triangles;
  for (uint32_t cell = 0; cell < kCells * kCells; ++cell) {
    std::array<ClipPosition, 3>& triangle = triangles.emplace_back();
    for (ClipPosition& p : triangle) {
      const auto inside = [&](uint32_t at) { return at * kCell + random.below((kCell - 2) * 16 + 1) / 16.0 + 1; };
      p = clipFromPixels(scene.viewport, {inside(cell % kCells), inside(cell / kCells), 0.5, 1});
    }
  }
  std::vector<uint32_t> permutation(triangles.size());
  std::iota(permutation.begin(), permutation.end(), 0U);
  for (size_t i = permutation.size(); i > 1; --i) std::swap(permutation[i - 1], permutation[random.below(i)]);
  Scene other = scene;
  Draw& draw = scene.draws.emplace_back();
  Draw& permuted = other.draws.emplace_back();
  for (const auto& t : triangles) draw.positions.insert(draw.positions.end(), t.begin(), t.end());
  for (const uint32_t i : permutation) permuted.positions.insert(permuted.positions.end(), triangles[i].begin(), triangles[i].end());
  Case result;
  result.scenes = {std::move(scene), std::move(other)};
  result.agree = [permutation](std::span<const Frame> frames) {
    return checkSamples(frames[0], [&](size_t i, uint32_t, uint32_t) -> std::string {
      const uint32_t first = frames[0].primitive.data[i], second = frames[1].primitive.data[i];
      const uint32_t original = second == 0 || second > permutation.size() ? second : permutation[second - 1] + 1;
      if (first == original && frames[0].count.data[i] == frames[1].count.data[i]) return {};
      return fmt::format("primitive {} in one order, {} in another", first, original);
    });
  };
  return result;
}

/// Coverage alone, then with values, then with a depth that always passes.
Case masks(Prng& random, const Limits& limits) {
  Scene plain = validScene("state", random, limits);
  plain.target.depthFormat.reset();
  plain.target.depthClearValue = 1;
  plain.target.resolve = false;
  State& state = plain.state;
  state.depthTestEnable = state.depthWriteEnable = state.depthBiasEnable = state.alphaToCoverageEnable = state.sampleShadingEnable = false;
  plain.builtIns.clear();
  for (Draw& draw : plain.draws) draw.varyings.clear();
  Scene valued = plain;
  for (Draw& draw : valued.draws) {
    draw.varyings = {{.name = "a", .interpolation = Interpolation::smooth, .components = 4}, {.name = "b", .interpolation = Interpolation::flat, .components = 1}};
    for (Varying& varying : draw.varyings) {
      for (size_t i = 0; i < draw.positions.size() * varying.components; ++i) varying.values.push_back(static_cast<float>(random.between(-4, 4)));
    }
  }
  Scene deep = plain;
  deep.target.depthFormat = DepthFormat::D32_SFLOAT;
  deep.state.depthTestEnable = deep.state.depthWriteEnable = true;
  deep.state.depthCompareOp = CompareOp::ALWAYS;
  Case result;
  result.scenes = {std::move(plain), std::move(valued), std::move(deep)};
  result.agree = [](std::span<const Frame> frames) {
    Agreement agreement = sameCoverage(frames[0], frames[1]);
    return agreement.broken ? agreement : sameCoverage(frames[0], frames[2]);
  };
  return result;
}

constexpr std::string_view kInvariance = "vk:invariance";
constexpr std::array kInvariants{
    Invariant{"repeated", "R49", kInvariance, "the same commands give the same bytes, whatever was drawn between", repeated},
    Invariant{"primitive-order", "R50", "vk:drawing-primitive-order", "the order of triangles that do not touch changes no sample", order},
    Invariant{"masks-independent", "R49", kInvariance, "coverage does not depend on values, nor on a depth that always passes", masks},
};

}  // namespace

std::span<const Invariant> independenceInvariants() { return kInvariants; }

}  // namespace rasterdiff::harness::invariants
