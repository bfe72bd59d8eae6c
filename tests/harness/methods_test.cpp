// `methods`, and a method as the driver under test.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/compare/compare.hpp"
#include "harness/method_subject.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

uint64_t wrongSamples(const std::string& method, const std::string& scenes) {
  const auto subject = *harness::openSubject({"method:" + method, false, 20, "reference"});
  const rasterizer::Rules rules = *rasterizer::Rules::profile("reference", subject->limits());
  uint64_t wrong = 0;
  for (const CatalogueEntry* entry : matchCatalogue(scenes)) {
    const Scene scene = *entry->make();
    const Result<Frame> frame = subject->render(scene);
    if (!frame) continue;
    wrong += harness::compare(scene, rules, *rasterizer::render(scene, rules), *frame)->differing;
  }
  return wrong;
}

TEST(MethodSubject, ExactMethodsDrawWholeScenesExactly) {
  for (const rasterizer::CoverageMethod& method : rasterizer::coverageMethods()) {
    if (method.exact) {
      EXPECT_EQ(wrongSamples(method.name, "fill/*"), 0U) << method.name;
    }
  }
  EXPECT_EQ(wrongSamples("spans", "scissor/*"), 0U);
  EXPECT_EQ(wrongSamples("spans", "viewports/*"), 0U);
  EXPECT_EQ(wrongSamples("spans", "clip/*"), 0U);
}

TEST(MethodSubject, TextbookMethodsShowWhatTheyCost) {
  EXPECT_GT(wrongSamples("cross-products", "shared-edge/*"), 0U);
  EXPECT_GT(wrongSamples("incremental-fixed", "sliver/*"), 0U);
}

TEST(MethodSubject, RefusesWhatIsMoreThanCoverageOfTriangles) {
  const auto subject = *harness::openSubject({"method:spans", false, 20, "reference"});
  for (const char* name : {"depth/less", "point/default-size", "line-rect/default-mode", "polygon-mode/line-1x"}) {
    const Result<Frame> frame = subject->render(*matchCatalogue(name).at(0)->make());
    ASSERT_FALSE(frame) << name;
    EXPECT_EQ(frame.error().code, ErrorCode::NotOffered) << name;
  }
}

TEST(Methods, WritesTheRowsOfOneFamily) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"methods", "coverage", "--cases", "5", "--json", folder.path("m.json"), "--csv", folder.path("m.csv")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("edge-walking"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("bilinear"), std::string::npos) << outcome.out;
  const nlohmann::json rows = nlohmann::json::parse(readAll(folder.path("m.json"))).at("rows");
  EXPECT_GT(rows.size(), 30U);
  for (const nlohmann::json& row : rows) {
    EXPECT_EQ(row.at("family"), "coverage");
    EXPECT_EQ(row.at("cases"), 5);
    if (row.at("method") == "spans") {
      EXPECT_EQ(row.at("wrong"), 0);
    }
  }
  EXPECT_EQ(readAll(folder.path("m.csv")).substr(0, 13), "family,method");
}

TEST(Methods, TheSameSeedGivesTheSameTable) {
  const std::vector<std::string> words{"methods", "line", "--cases", "7", "--seed", "3"};
  EXPECT_EQ(runProgram(words).out, runProgram(words).out);
}

}  // namespace
}  // namespace rasterdiff::test
