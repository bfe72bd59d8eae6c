// What Amber's language has no words for, so that no script says something else than its scene.
#pragma once

#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

/// Error: BadInput; `where` is the scene's field, the hint says what to change where that may help.
[[nodiscard]] Result<void> sayableInAmber(const Scene& scene);

}  // namespace rasterdiff::harness
