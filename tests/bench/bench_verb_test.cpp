// `rasterdiff bench` as its users run it. Nothing here asserts a time.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
// g++ 12 sees an overlapping copy in its own std::string::replace (GCC bug 105651).
#pragma GCC diagnostic ignored "-Wrestrict"
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

constexpr const char* kTriangle =
    R"({"target": {"width": 64, "height": 64}, "draws": [{"space": "pixels", "positions": [[2, 2, 0.5], [60, 4, 0.5], [4, 60, 0.5]]}]})";

/// Everything that the document breaks of the schema; empty = valid.
std::string complaintsAbout(const nlohmann::json& document) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  const auto text = nlohmann::json::parse(readAll(RASTERDIFF_SOURCE_DIR "/harness/report/bench.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(text), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, Adapter(document), &results);
  std::string complaints;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& part : error.context) complaints += part;
    complaints += ": " + error.description + "\n";
  }
  return complaints;
}

class Bench : public testing::Test {
 protected:
  /// Words that keep a run short.
  Outcome run(std::vector<std::string> words) {
    words.insert(words.begin(), "bench");
    words.insert(words.end(), {"--quick", "--rounds", "1"});
    return runProgram(words);
  }
  nlohmann::json json(std::vector<std::string> words) {
    words.insert(words.end(), {"--json", folder_.path("b.json")});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
    return nlohmann::json::parse(readAll(folder_.path("b.json")));
  }
  TemporaryFolder folder_;
};

TEST_F(Bench, VerifiesAndTimesEveryKernelOfAWorkload) {
  const nlohmann::json results = json({"--workload", "W1", "--tasks", "coverage", "--size", "256", "--driver", "none", "--kernels",
                                       "spans,edge-*,integer-spans,render"});
  EXPECT_EQ(complaintsAbout(results), "");
  const auto& rows = results.at("loads").at(0).at("rows");
  EXPECT_GE(rows.size(), 5U);
  for (const auto& row : rows) {
    EXPECT_GT(row.at("trianglesPerSecond").get<double>(), 0) << row;
    EXPECT_GT(row.at("error").at("covered").get<uint64_t>(), 1000U) << row;
    const bool right = row.at("error").at("wrong").get<uint64_t>() == 0;
    EXPECT_TRUE(right || !row.at("exact").get<bool>()) << row;
  }
  EXPECT_EQ(results.at("sampling").back().at("method"), "exact-area");
}

TEST_F(Bench, ASceneFileIsDrawnByKernelsReferenceAndDriver) {
  writeAll(folder_.path("one.scene.json"), kTriangle);
  const nlohmann::json results = json({folder_.path("one.scene.json"), "--kernels", "spans,render,driver*"});
  EXPECT_EQ(complaintsAbout(results), "");
  std::set<std::string> methods;
  for (const auto& row : results.at("loads").at(0).at("rows")) {
    methods.insert(row.at("method").get<std::string>());
    EXPECT_EQ(row.value("refused", ""), "");
    EXPECT_TRUE(!row.contains("error") || row.at("error").at("wrong") == 0) << row;
  }
  EXPECT_EQ(methods, (std::set<std::string>{"spans", "render", "driver", "driver-whole"}));
  EXPECT_NE(results.at("driver").get<std::string>(), "");
}

TEST_F(Bench, EveryInstructionSetIsARowOfItsOwn) {
  writeAll(folder_.path("one.scene.json"), kTriangle);
  const nlohmann::json results = json({folder_.path("one.scene.json"), "--kernels", "spans", "--driver", "none", "--targets"});
  std::vector<std::string> targets;
  for (const auto& row : results.at("loads").at(0).at("rows")) targets.push_back(row.at("target"));
  EXPECT_EQ(targets, results.at("machine").at("targets").get<std::vector<std::string>>());
}

TEST_F(Bench, WritesATableAPlotAndAPageThatLoadsNothing) {
  writeAll(folder_.path("one.scene.json"), kTriangle);
  const Outcome outcome = run({folder_.path("one.scene.json"), "--driver", "none", "--csv", folder_.path("b.csv"), "--svg",
                               folder_.path("b.svg"), "--report", folder_.path("b.html")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string csv = readAll(folder_.path("b.csv")), svg = readAll(folder_.path("b.svg")), html = readAll(folder_.path("b.html"));
  EXPECT_TRUE(csv.starts_with("workload,width,height,samples,task,method,"));
  EXPECT_NE(csv.find("\"spans\",true"), std::string::npos) << csv;
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_NE(svg.find("class=\"pareto\""), std::string::npos);
  EXPECT_NE(html.find("<svg class=\"plot\""), std::string::npos);
  for (const char* loader : {"src=", "<link rel=\"style", "url(", "@import", "<script"}) EXPECT_EQ(html.find(loader), std::string::npos) << loader;
}

TEST_F(Bench, ACrashedDriverCostsItsRowsAndTheStatusNotTheRun) {
  writeAll(folder_.path("one.scene.json"), kTriangle);
  const Outcome outcome = run({folder_.path("one.scene.json"), "--kernels", "spans,driver", "--driver", "fault:crash", "--json", folder_.path("b.json")});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("crashed"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.lastErrorLine(), "rasterdiff devices");
  const nlohmann::json results = nlohmann::json::parse(readAll(folder_.path("b.json")));
  EXPECT_TRUE(results.at("loads").at(0).at("rows").at(0).contains("seconds"));
}

struct Refused {
  const char* why;
  std::vector<std::string> words;
  int status;
  const char* says;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.why; }

class RefusedBench : public testing::TestWithParam<Refused> {};

TEST_P(RefusedBench, SaysWhatIsWrong) {
  std::vector<std::string> words = GetParam().words;
  words.insert(words.begin(), "bench");
  const Outcome outcome = runProgram(words);
  EXPECT_EQ(outcome.status, GetParam().status) << outcome.err;
  EXPECT_NE(outcome.err.find(GetParam().says), std::string::npos) << outcome.err;
  EXPECT_TRUE(outcome.lastErrorLine().starts_with("rasterdiff ")) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(
    Bench, RefusedBench,
    testing::Values(Refused{"UnknownWorkload", {"--workload", "W9"}, 2, "no workload 'W9'"},
                    Refused{"BadSize", {"--size", "big"}, 2, "'big' is no size"},
                    Refused{"SizeZero", {"--size", "0x4"}, 2, "no size"},
                    Refused{"SizeTooSmallForSlivers", {"--workload", "W5", "--size", "300"}, 2, "does not fit"},
                    Refused{"ThreeSamples", {"--samples", "3"}, 2, "'3' is no number of samples"},
                    Refused{"NoSamples", {"--samples", ","}, 2, "is no number of samples"},
                    Refused{"UnknownTask", {"--tasks", "shadows"}, 2, "no task 'shadows'"},
                    Refused{"NoRounds", {"--rounds", "0"}, 2, "--rounds"},
                    Refused{"NoThreads", {"--threads", "0"}, 2, "--threads"},
                    Refused{"UnknownKernel", {"--workload", "W2", "--kernels", "magic", "--driver", "none", "--quick"}, 2, "magic"},
                    Refused{"UnknownDriver", {"--workload", "W2", "--driver", "none-such", "--quick"}, 3, "none-such"},
                    Refused{"UnknownScene", {"none/such"}, 2, "no scene is named"},
                    Refused{"UnwritableJson", {"--json", "/proc/none/x.json"}, 2, "cannot be written"},
                    Refused{"UnwritableSvg", {"--svg", "/proc/none/x.svg"}, 2, "cannot be written"}),
    [](const auto& each) { return std::string(each.param.why); });

}  // namespace
}  // namespace rasterdiff::test
