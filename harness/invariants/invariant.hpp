// What holds of a driver alone, without a reference: a few scenes, drawn one after the other, whose frames have to agree
// in a stated way. Each invariant is a property over random cases; what a case is made of is its own business.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/frame.hpp"
#include "scene/generators/prng.hpp"
#include "scene/limits.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::invariants {

/// Where the frames of a case do not agree.
struct Broken {
  uint32_t x = 0, y = 0, sample = 0;
  std::string what;  ///< "drawn 2 times"
};

struct Agreement {
  uint64_t samples = 0;  ///< samples that the property spoke about
  std::optional<Broken> broken;
};

struct Case {
  std::vector<Scene> scenes;  ///< drawn in this order
  std::function<Agreement(std::span<const Frame>)> agree;  ///< one frame a scene
};

struct Invariant {
  std::string_view name;    ///< "shared-edges-strip"
  std::string_view rule;    ///< "R15"
  std::string_view anchor;  ///< "vk:primsrast-polygons-basic"
  std::string_view what;    ///< one sentence: what holds
  Case (*make)(Prng& random, const Limits& limits);
};

/// All of them in a fixed order.
[[nodiscard]] std::span<const Invariant> invariants();

// By what they are about, each list in its own file.
[[nodiscard]] std::span<const Invariant> ownershipInvariants();     ///< every sample of a mesh has one owner
[[nodiscard]] std::span<const Invariant> equivalenceInvariants();   ///< two ways to say the same draw the same
[[nodiscard]] std::span<const Invariant> independenceInvariants();  ///< what must not matter does not

}  // namespace rasterdiff::harness::invariants
