// Target, scissors and viewports.
#include <algorithm>
#include <array>

#include "harness/hunt/ingredients.hpp"

namespace rasterdiff::harness::hunt {
namespace {

Rect2D scissorIn(const Target& target, Prng& random) {
  const auto x = random.below(target.width), y = random.below(target.height);
  return {static_cast<int32_t>(x), static_cast<int32_t>(y), 1 + random.below(target.width), 1 + random.below(target.height)};
}

Viewport viewportNear(const Target& target, Prng& random) {
  const auto width = static_cast<float>(target.width), height = static_cast<float>(target.height);
  Viewport v{0, 0, width, height, 0, 1};
  switch (random.below(6)) {
    case 0: v.x = static_cast<float>(random.between(-8, 8)); v.y = static_cast<float>(random.between(-8, 8)); break;
    case 1: v.x = static_cast<float>(random.between(-32, 32)) / 8; v.y = static_cast<float>(random.between(-512, 512)) / 256; break;
    case 2: v.width *= 2; v.height *= 0.5F; break;
    case 3: v.width = width - 3; v.height = height + 5.5F; break;
    case 4: v.width *= 8; v.height *= 8; v.x = -3 * width; v.y = -3 * height; break;
    default: break;
  }
  if (random.chance(25)) {
    v.y += v.height;
    v.height = -v.height;
  }
  switch (random.below(6)) {
    case 0: std::swap(v.minDepth, v.maxDepth); break;
    case 1: v.minDepth = 0.25F; v.maxDepth = 0.75F; break;
    case 2: v.minDepth = v.maxDepth = 0.5F; break;
    default: break;
  }
  return v;
}

void scissor(Kitchen& k) {
  k.scene.scissor.reset();
  if (k.random.chance(85)) k.scene.scissor = scissorIn(k.scene.target, k.random);
}

void viewport(Kitchen& k) { k.scene.viewport = viewportNear(k.scene.target, k.random); }

void viewports(Kitchen& k) {
  k.scene.furtherViewports.clear();
  const uint32_t further = k.random.below(3);
  for (uint32_t i = 0; i < further; ++i) {
    ViewportAndScissor& added = k.scene.furtherViewports.emplace_back();
    added.viewport = viewportNear(k.scene.target, k.random);
    if (k.random.chance(40)) added.scissor = scissorIn(k.scene.target, k.random);
  }
  for (Draw& draw : k.scene.draws) draw.viewportIndex = k.random.below(further + 1);
}

void target(Kitchen& k) {
  Target& t = k.scene.target;
  constexpr std::array<uint32_t, 12> kExtents{1, 4, 8, 8, 16, 16, 24, 32, 37, 64, 80, 130};
  t.width = kExtents[k.random.below(kExtents.size())];
  t.height = k.random.chance(60) ? std::min(t.width, 64U) : kExtents[k.random.below(kExtents.size() - 1)];
  k.scene.viewport = {0, 0, static_cast<float>(t.width), static_cast<float>(t.height), 0, 1};
}

constexpr std::array kIngredients{
    Ingredient{"scissor", scissor},
    Ingredient{"viewport", viewport},
    Ingredient{"viewports", viewports},
    Ingredient{"target", target},
};

}  // namespace

std::span<const Ingredient> viewIngredients() { return kIngredients; }

}  // namespace rasterdiff::harness::hunt
