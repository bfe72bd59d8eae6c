// What vertices carry: w, ways out of the view volume, distances, varyings, indices; and what is observed of them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/hunt/ingredients.hpp"
#include "scene/file/enum_names.hpp"

namespace rasterdiff::harness::hunt {
namespace {

void scale(ClipPosition& p, float factor) { p = {p.x * factor, p.y * factor, p.z * factor, p.w * factor}; }

/// The same places on the screen, with other w: powers of two keep them exact.
void perspective(Kitchen& k) {
  const bool exact = k.random.chance(60);
  for (Draw& draw : k.scene.draws) {
    for (ClipPosition& p : draw.positions) {
      scale(p, static_cast<float>(std::ldexp(exact ? 1.0 : 1 + k.random.unit(), k.random.between(-3, 3))));
    }
  }
}

/// Some vertices leave the view volume, touch its planes, or lie behind the eye.
void leave(Kitchen& k) {
  for (Draw& draw : k.scene.draws) {
    for (ClipPosition& p : draw.positions) {
      if (!k.random.chance(35)) continue;
      switch (k.random.below(9)) {
        case 0: p.x = k.random.chance(50) ? p.w : -p.w; break;
        case 1: p.y = k.random.chance(50) ? p.w : -p.w; break;
        case 2: p.x *= oneOf(k.random, {2.0F, 3.0F, -5.0F, 40.0F}); break;
        case 3: p.y *= oneOf(k.random, {2.0F, 3.0F, -5.0F, 40.0F}); break;
        case 4: p.z = oneOf(k.random, {-1.0F, -0.25F, 2.0F, 1.5F}) * p.w; break;
        case 5: p.z = oneOf(k.random, {0.0F, 1.0F, -0.0F}) * p.w; break;
        case 6: p.x = std::nextafterf(k.random.chance(50) ? p.w : -p.w, k.random.chance(50) ? 9e9F : 0.0F); break;
        case 7: p.w = -p.w; break;
        default: p.w = k.random.chance(50) ? p.w * 0.125F : p.w * 4; break;
      }
    }
  }
}

std::vector<float> distancesOf(Kitchen& k, size_t count) {
  std::vector<float> distances(count);
  const bool coarse = k.random.chance(70);
  for (float& d : distances) {
    d = coarse ? oneOf(k.random, {1.0F, 1.0F, -1.0F, 0.0F, 0.5F, -0.5F, -3.0F, 8.0F}) : static_cast<float>(k.random.between(-2.0, 2.0));
  }
  return distances;
}

void clipDistances(Kitchen& k) {
  const uint32_t count = oneOf(k.random, {0U, 1U, 1U, 1U, 2U, 3U});
  for (Draw& draw : k.scene.draws) {
    draw.clipDistanceCount = count;
    draw.clipDistances = distancesOf(k, count * draw.positions.size());
  }
}

void cullDistances(Kitchen& k) {
  const uint32_t count = oneOf(k.random, {0U, 1U, 1U, 2U});
  for (Draw& draw : k.scene.draws) {
    draw.cullDistanceCount = count;
    draw.cullDistances = distancesOf(k, count * draw.positions.size());
  }
}

void varyings(Kitchen& k) {
  const uint32_t count = 1 + k.random.below(3);
  std::vector<Varying> chosen;
  for (uint32_t i = 0; i < count; ++i) {
    Varying varying;
    varying.interpolation = static_cast<Interpolation>(k.random.below(6));
    varying.name = fmt::format("{}{}", enumName(varying.interpolation), i);
    varying.components = i == 0 && k.random.chance(50) ? 4 : 1 + k.random.below(4);
    if (varying.interpolation == Interpolation::offset) {
      varying.offsetX = static_cast<float>(k.random.between(-8, 7)) / 16;
      varying.offsetY = static_cast<float>(k.random.between(-8, 7)) / 16;
    }
    chosen.push_back(std::move(varying));
  }
  const bool constant = k.random.chance(10);
  for (Draw& draw : k.scene.draws) {
    draw.varyings = chosen;
    for (Varying& varying : draw.varyings) {
      varying.values.resize(draw.positions.size() * varying.components);
      const float same = randomValue(k.random);
      for (float& value : varying.values) value = constant ? same : randomValue(k.random);
    }
  }
}

void builtIns(Kitchen& k) {
  k.scene.builtIns.clear();
  const uint32_t count = 1 + k.random.below(2);
  for (uint32_t i = 0; i < count; ++i) {
    const auto builtIn = static_cast<BuiltIn>(k.random.below(6));
    const auto& chosen = k.scene.builtIns;
    if (std::find(chosen.begin(), chosen.end(), builtIn) == chosen.end()) k.scene.builtIns.push_back(builtIn);
  }
}

/// A permutation, some vertices again, some left out, with restarts where strips and fans can have them.
void indices(Kitchen& k) {
  using enum PrimitiveTopology;
  const PrimitiveTopology topology = k.scene.state.topology;
  const bool joined = topology == LINE_STRIP || topology == TRIANGLE_STRIP || topology == TRIANGLE_FAN;
  k.scene.state.primitiveRestartEnable = joined && k.random.chance(50);
  for (Draw& draw : k.scene.draws) {
    draw.indices.reset();
    if (k.random.chance(15)) continue;
    std::vector<uint32_t>& list = draw.indices.emplace();
    for (size_t i = 0; i < draw.positions.size(); ++i) {
      if (k.scene.state.primitiveRestartEnable && k.random.chance(12)) list.push_back(kRestartIndex);
      list.push_back(k.random.chance(75) ? static_cast<uint32_t>(i) : k.random.below(draw.positions.size()));
    }
  }
}

void topology(Kitchen& k) {
  using enum PrimitiveTopology;
  k.scene.state.topology = oneOf(k.random, {TRIANGLE_LIST, TRIANGLE_LIST, TRIANGLE_STRIP, TRIANGLE_FAN, LINE_LIST, LINE_STRIP, POINT_LIST});
}

constexpr std::array kIngredients{
    Ingredient{"perspective", perspective},      Ingredient{"leave", leave},
    Ingredient{"clip-distances", clipDistances}, Ingredient{"cull-distances", cullDistances},
    Ingredient{"varyings", varyings},            Ingredient{"built-ins", builtIns},
    Ingredient{"indices", indices},              Ingredient{"topology", topology},
};

}  // namespace

std::span<const Ingredient> vertexIngredients() { return kIngredients; }

float randomValue(Prng& random) {
  const uint32_t kind = random.below(20);
  if (kind < 12) return static_cast<float>(random.between(-16, 16)) / 4;
  if (kind < 19) return static_cast<float>(random.between(-8.0, 8.0));
  return static_cast<float>(std::ldexp(random.between(-1.0, 1.0), random.between(-60, 60)));
}

}  // namespace rasterdiff::harness::hunt
