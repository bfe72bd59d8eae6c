// A few pixels from near, as a drawing: edges and vertices after snapping, every sample where it lies, what the driver
// covered and what the verdict is.
#pragma once

#include <optional>
#include <string>

#include "harness/compare/verdict.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness {

/// The sample that a result would be explained at: its first difference, else its first differing value; none if nothing differs and
/// no coverage is only allowed.
[[nodiscard]] std::optional<rasterizer::SampleQuery> focusOf(const SceneResult& result);

/// An <svg> element that also is a file of its own: the pixels around `focus`. `actual` is the reference's frame where there is no driver.
[[nodiscard]] std::string closeUp(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual,
                                  const SceneResult& result, const rasterizer::SampleQuery& focus);

}  // namespace rasterdiff::harness
