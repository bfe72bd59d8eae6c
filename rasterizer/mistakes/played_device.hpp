// The device that mutants play: everything that a deliberate error could show itself on is offered.
#pragma once

#include "rasterizer/deliberate_error.hpp"
#include "scene/limits.hpp"

namespace rasterdiff::rasterizer {

/// Wide lines and large points in fine steps, viewports honoured to 1/256 pixel; without strictLines for the mistakes
/// of lines that are not strict.
[[nodiscard]] Limits playedDevice(DeliberateError error);

}  // namespace rasterdiff::rasterizer
