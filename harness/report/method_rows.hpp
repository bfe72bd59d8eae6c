// The table of the lectures' methods as text, Markdown, JSON and CSV.
#pragma once

#include <span>
#include <string>

#include "rasterizer/methods/method_table.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string methodsText(std::span<const rasterizer::MethodRow> rows);
[[nodiscard]] std::string methodsJson(std::span<const rasterizer::MethodRow> rows,
                                      const rasterizer::MethodTableOptions& options);
[[nodiscard]] std::string methodsCsv(std::span<const rasterizer::MethodRow> rows);

}  // namespace rasterdiff::harness
