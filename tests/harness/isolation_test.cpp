// A driver that crashes, hangs or is lost costs its scene, never the run. The faults are planted subjects.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <map>

#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

struct Checked {
  Outcome outcome;
  nlohmann::json json;

  [[nodiscard]] std::string verdictOf(const std::string& id) const {
    for (const auto& scene : json.at("scenes")) {
      if (scene.at("id") == id) return scene.at("verdict");
    }
    return "absent";
  }
};

Checked check(std::vector<std::string> words) {
  const TemporaryFolder folder;
  const std::string path = folder.path("results.json");
  words.insert(words.begin(), "check");
  words.insert(words.end(), {"--json", path});
  Checked checked{runProgram(words), {}};
  checked.json = nlohmann::json::parse(readAll(path), nullptr, false);
  return checked;
}

TEST(Isolation, ACrashCostsItsSceneOnly) {
  const Checked run = check({"random/half-*", "--driver", "fault:crash=random/half-4x-w1", "--jobs", "2"});
  EXPECT_EQ(run.outcome.status, 4);
  EXPECT_EQ(run.verdictOf("random/half-4x-w1"), "Crashed");
  EXPECT_EQ(run.verdictOf("random/half-1x-w1"), "Same");
  EXPECT_EQ(run.verdictOf("random/half-1x-persp"), "Same");
  EXPECT_EQ(run.verdictOf("random/half-4x-persp"), "Same");
  EXPECT_TRUE(run.outcome.lastErrorLine().starts_with("rasterdiff check random/half-4x-w1 ")) << run.outcome.err;
}

TEST(Isolation, ACrashNamesItsSignalAndPhase) {
  const Checked run = check({"random/half-*", "--driver", "fault:crash=random/half-4x-w1"});
  const std::string& text = run.outcome.out;
  EXPECT_NE(text.find("in the driver phase"), std::string::npos) << text;
#if !defined(__SANITIZE_ADDRESS__)  // the sanitizer turns the signal into an exit status
  EXPECT_NE(text.find("signal 11"), std::string::npos) << text;
#endif
}

TEST(Isolation, AHangIsEndedAndCostsItsSceneOnly) {
  const Checked run = check({"random/half-*", "--driver", "fault:hang=random/half-1x-w1", "--timeout", "0.2"});
  EXPECT_EQ(run.outcome.status, 4);
  EXPECT_EQ(run.verdictOf("random/half-1x-w1"), "TimedOut");
  EXPECT_EQ(run.verdictOf("random/half-4x-w1"), "Same");
}

TEST(Isolation, ALostDeviceIsReplacedForTheOtherScenes) {
  for (const auto& [fault, verdict] : {std::pair{"lost", "Crashed"}, {"timeout", "TimedOut"}}) {
    const Checked run = check({"random/half-*", "--driver", std::string("fault:") + fault + "=random/half-1x-persp", "--jobs", "1"});
    EXPECT_EQ(run.outcome.status, 4) << fault;
    EXPECT_EQ(run.verdictOf("random/half-1x-persp"), verdict);
    EXPECT_EQ(run.verdictOf("random/half-4x-persp"), "Same") << fault;
  }
}

TEST(Isolation, AFloodOfCrashesStopsTheRun) {
  const Checked run = check({"random/*", "--driver", "fault:crash", "--jobs", "1"});
  EXPECT_EQ(run.outcome.status, 4);
  EXPECT_EQ(run.json.at("totals").at("crashed"), 5);
  EXPECT_GT(run.json.at("notRun"), 0);
  EXPECT_NE(run.outcome.out.find("5 times in a row"), std::string::npos) << run.outcome.out;
}

TEST(Isolation, WhatIsNotOfferedIsSkippedAndListed) {
  const Checked run = check({"random/half-*", "--driver", "fault:refuse=random/half-1x-w1"});
  EXPECT_EQ(run.outcome.status, 0);
  EXPECT_EQ(run.verdictOf("random/half-1x-w1"), "Skipped");
  EXPECT_EQ(run.json.at("totals").at("skipped"), 1);
  EXPECT_NE(run.outcome.out.find("Skipped   random/half-1x-w1: "), std::string::npos) << run.outcome.out;
  EXPECT_NE(run.outcome.out.find("1 scene skipped"), std::string::npos) << run.outcome.out;
}

TEST(Isolation, ARunThatSkipsEverythingIsNoPass) {
  const Checked run = check({"random/half-*", "--driver", "fault:refuse"});
  EXPECT_EQ(run.outcome.status, 3);
  EXPECT_NE(run.outcome.out.find("FAIL: 0 scenes compared"), std::string::npos) << run.outcome.out;
}

TEST(Isolation, ExplainSurvivesACrashWithTheReferenceAlone) {
  const Outcome outcome = runProgram({"explain", "random/half-1x-w1", "100", "100", "--driver", "fault:crash"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.out.find("reference   "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("the driver crashed"), std::string::npos) << outcome.err;
}

TEST(Isolation, BatchesOfOneFamilyAreOneEntry) {
  const Checked run = check({"random/half-1x-w1", "random/free-4x-persp", "--driver", "fault:crash=nothing", "--count", "4000"});
  EXPECT_EQ(run.outcome.status, 0) << run.outcome.err;
  ASSERT_EQ(run.json.at("scenes").size(), 2U);
  for (const auto& scene : run.json.at("scenes")) {
    EXPECT_EQ(scene.at("batches"), 4);
    EXPECT_EQ(scene.at("primitives"), 2000);
  }
  EXPECT_EQ(run.json.at("totals").at("primitives"), 4000);
}

TEST(Isolation, EveryKindOfRandomPrimitivesGetsTheCount) {
  const Checked run = check({"random/half-*", "random-points/1x", "random-points/4x", "random-strips/fan-1x-w1", "--driver",
                             "fault:crash=nothing", "--count", "1000"});
  EXPECT_EQ(run.outcome.status, 0) << run.outcome.err;
  std::map<std::string, uint64_t> primitives;
  for (const auto& scene : run.json.at("scenes")) {
    const std::string id = scene.at("id");
    primitives[id.substr(0, id.find('/'))] += scene.at("primitives").get<uint64_t>();
  }
  EXPECT_EQ(primitives["random"], 2000U);         // four families share it, in whole batches of 500
  EXPECT_EQ(primitives["random-points"], 1000U);  // two
  EXPECT_GE(primitives["random-strips"], 1000U);  // one; runs are not cut short
}

TEST(Isolation, ADifferenceInABatchIsExplainedByItsAddress) {
  const Checked run = check({"random/half-1x-w1", "--driver", "mutant:half-pixel-shift", "--count", "1500", "--seed", "9"});
  EXPECT_EQ(run.outcome.status, 1);
  EXPECT_TRUE(run.outcome.lastErrorLine().starts_with("rasterdiff explain random/half-1x-w1@9000000"))
      << run.outcome.err;
}

}  // namespace
}  // namespace rasterdiff::test
