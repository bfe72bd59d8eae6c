// The table of methods: exact methods are exact in it, and the documentation shows the measured numbers.
#include "rasterizer/methods/method_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace rasterdiff::rasterizer {
namespace {

const std::vector<MethodRow>& table() {
  static const std::vector<MethodRow> kRows = methodTable();
  return kRows;
}

const MethodRow& row(std::string_view family, std::string_view method, std::string_view inputs) {
  const auto found = std::find_if(table().begin(), table().end(), [&](const MethodRow& r) {
    return r.family == family && r.method == method && r.inputs.find(inputs) != std::string::npos;
  });
  if (found == table().end()) ADD_FAILURE() << "no row " << family << ' ' << method << ' ' << inputs;
  return found == table().end() ? table().front() : *found;
}

TEST(MethodTable, EveryFamilyHasRowsWithCases) {
  std::set<std::string> families;
  for (const MethodRow& r : table()) {
    families.insert(r.family);
    EXPECT_GT(r.cases, 0u) << r.family << ' ' << r.method << ' ' << r.inputs;
    EXPECT_GE(r.maxError, r.rmsError);
    EXPECT_GE(r.rmsError * (1 + 1e-12), r.meanError);  // rounding of two sums of the same numbers
  }
  EXPECT_EQ(families.size(), methodFamilies().size());
}

TEST(MethodTable, ExactMethodsHaveNoWrongSample) {
  for (const MethodRow& r : table()) {
    const bool exact = r.method == "scanline" || r.method == "diamond-exit-vulkan" ||
                       (r.method == "triangulation" && r.inputs.find("self-crossing") == std::string::npos) ||
                       (r.method == "convex-fan" && !r.hard);
    if (!exact) continue;
    EXPECT_EQ(r.wrongSamples, 0u) << r.method << ' ' << r.inputs;
  }
}

TEST(MethodTable, HardInputsShowWhatFriendlyOnesHide) {
  EXPECT_GT(row("polygon", "convex-fan", "concave").wrongSamples, 0u);
  EXPECT_GT(row("line", "long-axis", "1/256").wrongSamples, 0u);
  for (const char* method : {"plane", "barycentric"}) {
    EXPECT_GT(row("interpolation", method, "16,000").maxError, 100 * row("interpolation", method, "8 to 40").maxError);
  }
  EXPECT_GT(row("interpolation", "affine", "10,000").meanError,
            row("interpolation", "perspective", "10,000").meanError);
}

TEST(MethodTable, SamplingErrorFallsAsSamplesGrow) {
  double before = 1;
  for (const char* method : {"grid-1x1", "grid-2x2", "grid-4x4", "grid-8x8", "grid-16x16", "grid-32x32"}) {
    const double rms = row("sampling", method, "borders").rmsError;
    EXPECT_LT(rms, before) << method;
    before = rms;
  }
}

TEST(MethodTable, DocumentationShowsTheMeasuredTable) {
  std::ifstream file(RASTERDIFF_SOURCE_DIR "/docs/methods.md");
  ASSERT_TRUE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find(methodTableMarkdown(table())), std::string::npos) << "docs/methods.md should contain:\n"
                                                                              << methodTableMarkdown(table());
}

}  // namespace
}  // namespace rasterdiff::rasterizer
