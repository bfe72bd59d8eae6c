// Words and statuses: what is refused, how it says so, and what it tells the user to type next.
#include <gtest/gtest.h>

#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

TEST(CommandLine, HelpOfEveryVerbSucceedsAndShowsExamples) {
  for (const char* verb : {"check", "render", "explain", "bench", "devices", "list", "methods", "hunt", "bless", "infer"}) {
    const Outcome help = runProgram({verb, "--help"});
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_NE(help.out.find("Examples:"), std::string::npos) << verb;
    EXPECT_NE(help.out.find(std::string("rasterdiff ") + verb), std::string::npos) << verb;
    EXPECT_EQ(help.err, "") << verb;
  }
}

struct Refused {
  const char* why;
  std::vector<std::string> words;
  int status;
  const char* says;
  const char* next;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.why; }

class RefusedWords : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWords, SayWhatIsWrongAndWhatToTypeNext) {
  const Refused& refused = GetParam();
  const Outcome outcome = runProgram(refused.words);
  EXPECT_EQ(outcome.status, refused.status) << outcome.err;
  EXPECT_NE(outcome.err.find(refused.says), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.lastErrorLine(), refused.next) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, RefusedWords,
    testing::Values(
        Refused{"NoVerb", {}, 2, "required", "rasterdiff --help"},
        Refused{"UnknownVerb", {"draw"}, 2, "no verb 'draw'", "rasterdiff --help"},
        Refused{"UnknownOption", {"check", "--fast"}, 2, "--fast", "rasterdiff check --help"},
        Refused{"UnknownScene", {"check", "fill/shard"}, 2, "no scene is named 'fill/shard'", "rasterdiff list"},
        Refused{"UnknownRules", {"check", "--rules", "opengl"}, 2, "opengl", "rasterdiff check --help"},
        Refused{"UnknownMutant", {"check", "fill/*", "--driver", "mutant:none-such"}, 2, "none-such", "rasterdiff list --mutants"},
        Refused{"UnknownFault", {"check", "fill/*", "--driver", "fault:none-such"}, 2, "none-such", "rasterdiff check --help"},
        Refused{"UnknownDriver", {"check", "fill/*", "--driver", "none-such"}, 3, "none-such", "rasterdiff devices"},
        Refused{"MissingProfileFile", {"check", "--rules", "none-such.json"}, 2, "none-such.json", "rasterdiff check --help"},
        Refused{"BadSeedOfSyntheticRules", {"infer", "--driver", "synthetic:x"}, 2, "'x' is no seed", "rasterdiff infer --help"},
        Refused{"InferUnknownDriver", {"infer", "--driver", "none-such"}, 3, "none-such", "rasterdiff devices"},
        Refused{"ShardOutOfRange", {"check", "--shard", "3/2"}, 2, "K/N", "rasterdiff check --help"},
        Refused{"ShardOfZero", {"check", "--shard", "0/2"}, 2, "K/N", "rasterdiff check --help"},
        Refused{"ShardNegative", {"check", "--shard", "-1/2"}, 2, "--shard", "rasterdiff check --help"},
        Refused{"ShardNoNumber", {"check", "--shard", "a/b"}, 2, "K/N", "rasterdiff check --help"},
        Refused{"ShardHuge", {"check", "--shard", "1/99999999999999999999"}, 2, "K/N", "rasterdiff check --help"},
        Refused{"TimeoutNotPositive", {"check", "--timeout", "0"}, 2, "--timeout", "rasterdiff check --help"},
        Refused{"TimeoutNoNumber", {"check", "--timeout", "soon"}, 2, "--timeout", "rasterdiff check --help"},
        Refused{"JobsNegative", {"check", "--jobs", "-1"}, 2, "--jobs", "rasterdiff check --help"},
        Refused{"RoundsZero", {"check", "--rounds", "0"}, 2, "--rounds", "rasterdiff check --help"},
        Refused{"CountWithoutFamily", {"check", "fill/*", "--count", "10"}, 2, "no random family",
                "rasterdiff check 'random/*' --count 1000000"},
        Refused{"CountZero", {"check", "random/*", "--count", "0"}, 2, "--count", "rasterdiff check --help"},
        Refused{"CountTooLarge", {"check", "random/*", "--count", "999999999999"}, 2, "--seed", "rasterdiff check --help"},
        Refused{"SeedWithoutCount", {"check", "random/*", "--seed", "3"}, 2, "--count", "rasterdiff check --help"},
        Refused{"MissingSceneFile", {"check", "none/such.scene.json"}, 2, "none/such.scene.json", "rasterdiff check --help"},
        Refused{"BadBatch", {"explain", "random/half-1x-w1@x", "0", "0"}, 2, "no batch", "rasterdiff list 'random*/*'"},
        Refused{"UnwritableJson", {"check", "fill/*", "--json", "/proc/none/x.json"}, 2, "cannot be written", "rasterdiff check --help"},
        Refused{"UnwritableReport", {"check", "fill/*", "--report", "/proc/none/x.html"}, 2, "cannot be written", "rasterdiff check --help"},
        Refused{"UnwritableFolder", {"render", "fill/*", "--with", "reference", "-o", "/proc/none"}, 2, "names", "rasterdiff list 'fill/*'"},
        Refused{"RenderWithoutSide", {"render", "fill/*", "-o", "x"}, 2, "--with", "rasterdiff render --help"},
        Refused{"RenderWithUnknownSide", {"render", "fill/*", "--with", "both", "-o", "x"}, 2, "--with", "rasterdiff render --help"},
        Refused{"ExplainWithoutPixel", {"explain", "fill/*"}, 2, "X", "rasterdiff explain --help"},
        Refused{"ExplainNegativePixel", {"explain", "random/half-1x-w1", "-1", "0"}, 2, "-1", "rasterdiff explain --help"},
        Refused{"ExplainOutsideTarget", {"explain", "random/half-1x-w1", "9999", "0"}, 2, "outside the target", "rasterdiff explain --help"},
        Refused{"ExplainOutsidePattern", {"explain", "random/half-1x-w1", "1", "1", "--sample", "4"}, 2, "outside the target",
                "rasterdiff explain --help"},
        Refused{"UnknownMethod", {"check", "fill/*", "--driver", "method:magic"}, 2, "magic", "rasterdiff methods coverage"},
        Refused{"UnknownMethodFamily", {"methods", "magic"}, 2, "no family 'magic'", "rasterdiff methods --help"},
        Refused{"MethodsWithoutCases", {"methods", "--cases", "0"}, 2, "--cases", "rasterdiff methods --help"},
        Refused{"ListUnknownGlob", {"list", "none-such/*"}, 2, "none-such/*", "rasterdiff list"},
        Refused{"ListTwoThings", {"list", "--rules", "--mutants"}, 2, "", "rasterdiff list --help"}),
    [](const auto& each) { return std::string(each.param.why); });

TEST(CommandLine, ShardsPartitionTheWork) {
  const std::string driver = "mutant:depth-off-by-one-step";
  const auto scenesOf = [&](const std::string& shard) {
    const TemporaryFolder folder;
    const std::string json = folder.path("r.json");
    EXPECT_LE(runProgram({"check", "fill/*", "--driver", driver, "--shard", shard, "--json", json}).status, 1);
    const std::string text = readAll(json);
    size_t scenes = 0;
    for (size_t at = text.find("\"id\""); at != std::string::npos; at = text.find("\"id\"", at + 1)) ++scenes;
    return scenes;
  };
  EXPECT_EQ(scenesOf("1/3") + scenesOf("2/3") + scenesOf("3/3"), scenesOf("1/1"));
}

constexpr const char* kTriangle =
    R"({"target": {"width": 16, "height": 16}, "draws": [{"space": "pixels", "positions": [[2, 2, 0.5], [14, 4, 0.5], [4, 14, 0.5]]}]})";

TEST(CommandLine, FilesAndFoldersOfThemAreScenes) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("sub"));
  writeAll(folder.path("one.scene.json"), kTriangle);
  writeAll(folder.path("sub/with space.scene.json"), kTriangle);
  writeAll(folder.path("sub/other.json"), "not a scene");
  for (const std::string& word : {folder.path("one.scene.json"), folder.path("sub")}) {
    const Outcome outcome = runProgram({"check", word, "--driver", "fault:crash=nothing"});
    EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
    EXPECT_NE(outcome.out.find("PASS: 1 scene compared"), std::string::npos) << outcome.out;
  }
}

TEST(CommandLine, ABrokenSceneFileIsRefusedWithItsPlace) {
  const TemporaryFolder folder;
  const std::string path = folder.path("broken.scene.json");
  writeAll(path, "{\n  \"target\": {\"width\": }\n}\n");
  for (const char* verb : {"check", "explain"}) {
    std::vector<std::string> words{verb, path};
    if (words[0] == "explain") words.insert(words.end(), {"0", "0"});
    const Outcome outcome = runProgram(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_TRUE(outcome.err.starts_with(path + ":2:")) << outcome.err;
  }
}

TEST(CommandLine, WhatIsNoSceneIsRefused) {
  const TemporaryFolder folder;
  writeAll(folder.path("mesh.obj"), "v 0 0 0\n");
  EXPECT_EQ(runProgram({"check", folder.path("mesh.obj")}).status, 2);
  std::filesystem::create_directories(folder.path("empty"));
  EXPECT_EQ(runProgram({"check", folder.path("empty")}).status, 2);
  const Outcome two = runProgram({"render", "random/*", "--with", "reference", "-o", folder.path("out")});
  EXPECT_EQ(two.status, 2);
  EXPECT_EQ(two.lastErrorLine(), "rasterdiff list 'random/*'");
}

TEST(CommandLine, SummaryEndsWithTheVerdictWhereNothingDiffers) {
  const Outcome outcome = runProgram({"check", "fill/*", "--driver", "fault:crash=nothing"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nPASS: "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST(CommandLine, InvariantsArePartOfACheckAndABrokenOneFails) {
  const Outcome holds = runProgram({"check", "invariant/*", "--driver", "fault:crash=nothing"});
  EXPECT_EQ(holds.status, 0) << holds.out;
  EXPECT_NE(holds.out.find("PASS: 14 scenes compared"), std::string::npos) << holds.out;
  const Outcome broken = runProgram({"check", "fill/triangle-1x", "invariant/shared-edges-*", "--driver", "mutant:ties-covered-by-both"});
  EXPECT_EQ(broken.status, 1) << broken.out;
  EXPECT_NE(broken.out.find("Differs   invariant/shared-edges-list: broken in "), std::string::npos) << broken.out;
  EXPECT_EQ(broken.lastErrorLine(), "rasterdiff invariants shared-edges-list --driver mutant:ties-covered-by-both --count 8");
  EXPECT_EQ(runProgram({"check", "invariant/nothing"}).status, 2);
}

TEST(CommandLine, ADifferenceEndsWithTheCommandThatExplainsIt) {
  const Outcome check = runProgram({"check", "fill/*", "--driver", "mutant:half-pixel-shift"});
  EXPECT_EQ(check.status, 1) << check.out;
  const std::string command = check.lastErrorLine();
  ASSERT_TRUE(command.starts_with("rasterdiff explain fill/")) << check.err;
  std::vector<std::string> words;
  for (size_t at = 11; at != std::string::npos && at < command.size();) {
    const size_t space = command.find(' ', at);
    words.push_back(command.substr(at, space == std::string::npos ? space : space - at));
    at = space == std::string::npos ? space : space + 1;
  }
  const Outcome explain = runProgram(words);
  EXPECT_EQ(explain.status, 1) << explain.err;
  EXPECT_NE(explain.out.find("verdict     Differs"), std::string::npos) << explain.out;
}

}  // namespace
}  // namespace rasterdiff::test
