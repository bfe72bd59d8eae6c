// The words a random scene is put together from: each sets one part of a scene anew, at random, and keeps the rest.
#pragma once

#include <span>
#include <string_view>

#include "scene/generators/prng.hpp"
#include "scene/limits.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::hunt {

/// What an ingredient works on; choices stay within the limits where those say what is offered.
struct Kitchen {
  Scene& scene;
  Prng& random;
  const Limits& limits;
};

struct Ingredient {
  std::string_view name;  ///< "clip-distances"
  void (*add)(Kitchen&);
};

/// Those that are state of the pipeline, those of the target and its views, those that vertices carry.
[[nodiscard]] std::span<const Ingredient> stateIngredients();
[[nodiscard]] std::span<const Ingredient> viewIngredients();
[[nodiscard]] std::span<const Ingredient> vertexIngredients();

/// One element of a list.
template <class T, size_t N>
[[nodiscard]] T oneOf(Prng& random, const T (&list)[N]) {
  return list[random.below(N)];
}

/// A number to interpolate: often a small dyadic one, seldom a huge or tiny one.
[[nodiscard]] float randomValue(Prng& random);

/// Makes what other parts have made impossible possible again: arrays as long as there are vertices, state only where
/// there is what it acts on. What validate() says counts; the result usually is valid.
void repair(Scene& scene, Prng& random);

}  // namespace rasterdiff::harness::hunt
