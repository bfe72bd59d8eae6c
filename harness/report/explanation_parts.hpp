// Parts of `explain` as text: a triangle, a line or point, what became of the fragment. explanation.cpp puts them
// together.
#pragma once

#include <iterator>
#include <string>
#include <string_view>

#include "rasterizer/explain.hpp"

namespace rasterdiff::harness {

using TextOut = std::back_insert_iterator<std::string>;

void writeTriangle(TextOut out, const rasterizer::PrimitiveExplanation& triangle);
/// One that has no place on the screen.
void writeUnprojectable(TextOut out, const rasterizer::PrimitiveExplanation& triangle);
void writeFigure(TextOut out, const rasterizer::PrimitiveExplanation& figure);
/// "drawn over primitive 3", "dropped: depth 0.5 against the stored 0.25"; empty where it did not get that far.
[[nodiscard]] std::string fateText(const rasterizer::PrimitiveExplanation& primitive, bool depth);

/// "R15 tie-break [vk:primsrast-polygons-basic]".
[[nodiscard]] std::string ruleText(rasterizer::Rule rule);
[[nodiscard]] std::string_view ruleId(rasterizer::Rule rule);

}  // namespace rasterdiff::harness
