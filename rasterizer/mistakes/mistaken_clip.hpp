// Deliberate errors in what clipping leaves of a triangle or a line.
#pragma once

#include "rasterizer/clip.hpp"

namespace rasterdiff::rasterizer {

/// Spoils what is left; `byDistance`: a user clip distance cut it.
void mistakeClipped(ClipPolygon& left, DeliberateError error, bool byDistance);

}  // namespace rasterdiff::rasterizer
