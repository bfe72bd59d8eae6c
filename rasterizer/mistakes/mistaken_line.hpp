// Deliberate errors in which samples a line covers.
#pragma once

#include <memory>
#include <optional>

#include "rasterizer/lines/line_coverage.hpp"

namespace rasterdiff::rasterizer {

/// What a line with the mistake of `rules` covers (null: nothing); none if the mistake is not one of such lines.
[[nodiscard]] std::optional<std::unique_ptr<LineCoverage>> mistakenLine(const LineEnds& ends, const LineStyle& style,
                                                                        const Rules& rules);

}  // namespace rasterdiff::rasterizer
