// Random scenes of a family, and scenes made of other scenes: where a search starts and how it goes on.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/generators/prng.hpp"
#include "scene/limits.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::hunt {

/// What a hunt is about: which primitives, and which ingredients may be added to them.
struct Family {
  std::string_view name;  ///< as for `--family`
  std::string_view what;  ///< one line
  std::vector<PrimitiveTopology> topologies;
  std::vector<std::string_view> ingredients;
  std::vector<std::string_view> always;  ///< ingredients that every scene of it has
};

[[nodiscard]] std::span<const Family> families();
[[nodiscard]] const Family* familyByName(std::string_view name);

/// A scene of a few to a few dozen primitives; what the limits do not offer is mostly left out. Not always valid.
[[nodiscard]] Scene randomScene(const Family& family, const Limits& limits, Prng& random);

/// `scene` with one to three changes: vertices moved, primitives repeated or turned round, an ingredient anew.
[[nodiscard]] Scene mutated(Scene scene, const Family& family, const Limits& limits, Prng& random);

/// Moves one vertex, to an adversarial place or on another vertex.
void moveVertex(Scene& scene, Prng& random);

/// The vertices of `shape` under the state, target and views of `state`.
[[nodiscard]] Scene crossed(const Scene& shape, const Scene& state, Prng& random);

}  // namespace rasterdiff::harness::hunt
