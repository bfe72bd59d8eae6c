// The parts of checkOffered that need a feature or an extension rather than a limit of size.
#pragma once

#include <string>

#include "vkref/plan.hpp"

namespace rasterdiff::vkref {

[[nodiscard]] tl::unexpected<Error> notOffered(std::string where, std::string what);

/// Fixed-function state: polygons, lines, points, depth, multisampling. Error: NotOffered.
[[nodiscard]] Result<void> checkState(const Scene& scene, const Capabilities& caps);

/// What shaders have to declare: distances, interpolations, built-ins. Error: NotOffered.
[[nodiscard]] Result<void> checkShaders(const Scene& scene, const RenderPlan& plan, const Capabilities& caps);

}  // namespace rasterdiff::vkref
