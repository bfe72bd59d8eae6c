// Measures every method of the lectures (coverage of triangles, polygons, lines, interpolation, sampling, aliasing) against the exact answer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterdiff::rasterizer {

/// One method on one set of inputs. The unit of the errors is the family's (`methodFamilies`).
struct MethodRow {
  std::string family, method;
  bool hard = false;   ///< friendly or hard
  std::string inputs;  ///< what the cases are
  uint64_t cases = 0;  ///< polygons, lines, interpolated values, pixels or columns
  uint64_t wrongSamples = 0;
  double maxError = 0, meanError = 0, rmsError = 0;  ///< over the cases
};

struct MethodFamily {
  std::string_view name;
  std::string_view caseIs;   ///< what one case is
  std::string_view wrongIs;  ///< what is counted as a wrong sample
  std::string_view errorIs;  ///< the error of a case and its unit
};

/// "coverage", "polygon", "line", "interpolation", "depth", "sampling", "jaggies", "aliasing", "moire", in the order of the table.
[[nodiscard]] std::span<const MethodFamily> methodFamilies();

struct MethodTableOptions {
  uint64_t seed = 1;
  uint32_t cases = 300;  ///< inputs a set
};

/// All rows, grouped by family; the same options give the same rows.
[[nodiscard]] std::vector<MethodRow> methodTable(const MethodTableOptions& options = {});

/// One Markdown table a family, as in docs/methods.md.
[[nodiscard]] std::string methodTableMarkdown(std::span<const MethodRow> rows);

// One function a family, each in its own file.
void measureCoverage(const MethodTableOptions& options, std::vector<MethodRow>& rows);
void measurePolygons(const MethodTableOptions& options, std::vector<MethodRow>& rows);
void measureLines(const MethodTableOptions& options, std::vector<MethodRow>& rows);
void measureInterpolation(const MethodTableOptions& options, std::vector<MethodRow>& rows);
void measureDepth(std::vector<MethodRow>& rows);  ///< has no random inputs
void measureSampling(const MethodTableOptions& options, std::vector<MethodRow>& rows);
void measureAliasing(const MethodTableOptions& options, std::vector<MethodRow>& rows);

}  // namespace rasterdiff::rasterizer
