#include "harness/hunt/random_scene.hpp"

#include <algorithm>

#include "harness/hunt/ingredients.hpp"
#include "harness/hunt/places.hpp"
#include "scene/camera/screen.hpp"

namespace rasterdiff::harness::hunt {
namespace {

const Ingredient* ingredientByName(std::string_view name) {
  for (const auto& list : {stateIngredients(), viewIngredients(), vertexIngredients()}) {
    const auto at = std::find_if(list.begin(), list.end(), [&](const Ingredient& i) { return i.name == name; });
    if (at != list.end()) return &*at;
  }
  return nullptr;
}

void add(std::string_view name, const Kitchen& kitchen) {
  Kitchen own = kitchen;
  if (const Ingredient* ingredient = ingredientByName(name)) ingredient->add(own);
}

uint32_t verticesOf(PrimitiveTopology topology, uint32_t primitives) {
  using enum PrimitiveTopology;
  switch (topology) {
    case POINT_LIST: return primitives;
    case LINE_LIST: return 2 * primitives;
    case LINE_STRIP: return primitives + 1;
    case TRIANGLE_LIST: return 3 * primitives;
    case TRIANGLE_STRIP:
    case TRIANGLE_FAN: return primitives + 2;
  }
  return primitives;
}

float randomDepth(Prng& random) {
  return random.chance(50) ? oneOf(random, {0.5F, 0.5F, 0.25F, 0.75F, 0.0F, 1.0F}) : static_cast<float>(random.between(0.0, 1.0));
}

void addDraw(Scene& scene, Prng& random) {
  constexpr uint32_t kMost[] = {1, 2, 4, 8, 16, 40};
  const uint32_t primitives = 1 + random.below(oneOf(random, kMost));
  Places places(random, scene.target, Places::randomSteps(random));
  const bool flat = random.chance(50);
  const float depth = randomDepth(random);
  Draw& draw = scene.draws.emplace_back();
  for (uint32_t v = 0; v < verticesOf(scene.state.topology, primitives); ++v) {
    const Place at = places.next();
    draw.positions.push_back(clipFromPixels(scene.viewport, {at.x, at.y, flat ? depth : randomDepth(random), 1}));
  }
}

/// Primitives of a list again, turned round or one vertex replaced: shared edges and overlaps.
void repeatVertices(Scene& scene, Prng& random) {
  Draw& draw = scene.draws[random.below(scene.draws.size())];
  constexpr size_t kMost = 150;
  if (draw.indices || draw.positions.size() > kMost) return;
  const size_t first = random.below(draw.positions.size()) / 3 * 3;
  std::vector<ClipPosition> again(draw.positions.begin() + static_cast<std::ptrdiff_t>(first),
                                  draw.positions.begin() + static_cast<std::ptrdiff_t>(std::min(first + 3, draw.positions.size())));
  if (random.chance(60)) std::reverse(again.begin(), again.end());
  draw.positions.insert(draw.positions.end(), again.begin(), again.end());
}

}  // namespace

Scene randomScene(const Family& family, const Limits& limits, Prng& random) {
  Scene scene;
  scene.name = "hunt";
  scene.state.topology = family.topologies[random.below(family.topologies.size())];
  const Kitchen kitchen{scene, random, limits};
  add("target", kitchen);
  if (random.chance(35)) add("samples", kitchen);
  const uint32_t draws = random.chance(75) ? 1 : 2 + random.below(2);
  for (uint32_t d = 0; d < draws; ++d) addDraw(scene, random);
  for (const std::string_view name : family.always) add(name, kitchen);
  const uint32_t further = random.below(5);
  for (uint32_t i = 0; i < further; ++i) add(family.ingredients[random.below(family.ingredients.size())], kitchen);
  repair(scene, random);
  return scene;
}

void moveVertex(Scene& scene, Prng& random) {
  Draw& draw = scene.draws[random.below(scene.draws.size())];
  ClipPosition& p = draw.positions[random.below(draw.positions.size())];
  if (random.chance(40)) {
    p = draw.positions[random.below(draw.positions.size())];
    return;
  }
  Places places(random, scene.target, Places::randomSteps(random));
  const Place at = places.next();
  const float z = p.z, w = p.w;
  p = clipFromPixels(scene.viewport, {at.x, at.y, 0, w});
  p.z = z;
}

Scene mutated(Scene scene, const Family& family, const Limits& limits, Prng& random) {
  const Kitchen kitchen{scene, random, limits};
  const uint32_t changes = 1 + random.below(3);
  for (uint32_t i = 0; i < changes; ++i) {
    const uint32_t kind = random.below(10);
    if (kind < 4) {
      moveVertex(scene, random);
    } else if (kind < 6) {
      repeatVertices(scene, random);
    } else {
      add(family.ingredients[random.below(family.ingredients.size())], kitchen);
    }
    repair(scene, random);
  }
  return scene;
}

Scene crossed(const Scene& shape, const Scene& state, Prng& random) {
  Scene scene = state;
  scene.state.topology = shape.state.topology;
  const size_t like = state.draws.size();
  scene.draws.clear();
  for (size_t d = 0; d < shape.draws.size(); ++d) {
    Draw draw = state.draws[d % like];
    draw.positions = shape.draws[d].positions;
    draw.indices = shape.draws[d].indices;
    scene.draws.push_back(std::move(draw));
  }
  repair(scene, random);
  return scene;
}

}  // namespace rasterdiff::harness::hunt
