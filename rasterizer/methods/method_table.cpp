#include "rasterizer/methods/method_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rasterdiff::rasterizer {

std::span<const MethodFamily> methodFamilies() {
  static constexpr MethodFamily kFamilies[] = {
      {"coverage", "a triangle within 48 × 48 pixels", "samples that differ", "wrong samples a triangle"},
      {"polygon", "a polygon on 32 × 32 pixels", "pixels that differ", "wrong pixels a polygon"},
      {"line", "a line within 32 × 32 pixels", "pixels missing or too many", "wrong pixels a line"},
      {"interpolation", "a value", "values that are not correctly rounded", "ULP of float32"},
      {"depth", "a distance, one of 16,384 evenly spread by their logarithm", "distances that have another one's depth",
       "how many others have the same depth"},
      {"sampling", "a partly covered pixel", "pixels that differ in 8 bits", "fraction of a pixel's area"},
      {"jaggies", "a pixel column", "columns off by more than 1/16 pixel", "pixels between seen and true edge"},
      {"aliasing", "a pixel", "pixels that differ in 8 bits", "brightness, 0..1"},
      {"moire", "a block of 8 × 8 pixels", "blocks off by more than half a step of 8 bits", "mean brightness, 0..1"},
  };
  return kFamilies;
}

std::vector<MethodRow> methodTable(const MethodTableOptions& options) {
  std::vector<MethodRow> rows;
  measureCoverage(options, rows);
  measurePolygons(options, rows);
  measureLines(options, rows);
  measureInterpolation(options, rows);
  measureDepth(rows);
  measureSampling(options, rows);
  measureAliasing(options, rows);
  return rows;
}

std::string methodTableMarkdown(std::span<const MethodRow> rows) {
  std::string text;
  for (const MethodFamily& family : methodFamilies()) {
    if (std::ranges::find(rows, family.name, &MethodRow::family) == rows.end()) continue;
    fmt::format_to(std::back_inserter(text),
                   "### {}\n\nA case is {}; wrong: {}; error: {}.\n\n"
                   "| method | inputs | cases | wrong | max error | mean | RMS |\n|---|---|--:|--:|--:|--:|--:|\n",
                   family.name, family.caseIs, family.wrongIs, family.errorIs);
    for (const MethodRow& row : rows) {
      if (row.family != family.name) continue;
      fmt::format_to(std::back_inserter(text), "| {} | {}: {} | {} | {} | {:.3g} | {:.3g} | {:.3g} |\n", row.method,
                     row.hard ? "hard" : "friendly", row.inputs, row.cases, row.wrongSamples, row.maxError,
                     row.meanError, row.rmsError);
    }
    text += '\n';
  }
  return text;
}

}  // namespace rasterdiff::rasterizer
