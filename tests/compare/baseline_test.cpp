// Known differences: what an entry excuses, what it does not, and what happens when the driver is mended.
#include "harness/compare/baseline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/invariants/invariant.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::harness {
namespace {

SceneResult resultOf(Verdict verdict, uint64_t differing, std::vector<std::string> valuePlanes = {}) {
  SceneResult result;
  result.id = "family/scene";
  result.verdict = verdict;
  result.differing = differing;
  for (std::string& name : valuePlanes) {
    ValueStats stats;
    stats.name = std::move(name);
    stats.differing = 1;
    result.values.push_back(stats);
  }
  return result;
}

Baseline baselineFor(std::vector<std::string> planes) {
  BaselineEntry entry;
  entry.driver = "driver";
  entry.version = "Version 1";
  entry.scene = "family/*";
  entry.planes = std::move(planes);
  entry.rule = "R39";
  entry.anchor = "vk:fragops-scissor";
  entry.reason = "because";
  return {{entry}};
}

BaselineStatus statusOf(const Baseline& baseline, SceneResult result, std::string_view driver = "driver",
                        std::string_view info = "Version 1.2", std::string_view rules = "spec") {
  applyBaseline(baseline, driver, info, rules, result);
  return result.baseline;
}

TEST(Baseline, ExcusesJustThePlanesItNames) {
  const Baseline baseline = baselineFor({"depth", "coverage"});
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 3, {"depth"})), BaselineStatus::ExpectedDiff);
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 3)), BaselineStatus::None);
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 3, {"depth", "colour"})), BaselineStatus::None);
}

TEST(Baseline, RandomCasesThatShowNothingProveNothingMended) {
  Baseline baseline = baselineFor({"coverage"});
  baseline.entries.front().scene = "*";
  for (const char* id : {"random-lines/rect-4x", "invariant/repeated"}) {
    SceneResult result = resultOf(Verdict::Same, 0);
    result.id = id;
    EXPECT_EQ(statusOf(baseline, result), BaselineStatus::None) << id;
    result = resultOf(Verdict::Differs, 1);
    result.id = id;
    EXPECT_EQ(statusOf(baseline, result), BaselineStatus::ExpectedDiff) << id;
  }
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Same, 0)), BaselineStatus::Improved);
}

TEST(Baseline, ExcusesNoOtherDriverVersionOrScene) {
  const Baseline baseline = baselineFor({"coverage"});
  SceneResult result = resultOf(Verdict::Differs, 1);
  EXPECT_EQ(statusOf(baseline, result, "another"), BaselineStatus::None);
  EXPECT_EQ(statusOf(baseline, result, "driver", "Version 2.0"), BaselineStatus::None);
  result.id = "other/scene";
  EXPECT_EQ(statusOf(baseline, result), BaselineStatus::None);
}

TEST(Baseline, OfAnotherVersionSaysWhatIsOldButExcusesNothing) {
  const Baseline baseline = baselineFor({"coverage"});
  EXPECT_EQ(otherVersions(baseline, "driver", "Version 2.0"), std::vector<std::string>{"Version 1"});
  EXPECT_TRUE(otherVersions(baseline, "driver", "Version 1.2").empty());
  EXPECT_TRUE(otherVersions(baseline, "another", "Version 2.0").empty());
  EXPECT_TRUE(differsInSomeVersion(baseline, "driver", "spec", resultOf(Verdict::Differs, 3)));
  EXPECT_FALSE(differsInSomeVersion(baseline, "driver", "spec", resultOf(Verdict::Differs, 3, {"color"})));
  EXPECT_FALSE(differsInSomeVersion(baseline, "driver", "spec", resultOf(Verdict::Same, 0)));
  EXPECT_FALSE(differsInSomeVersion(baseline, "another", "spec", resultOf(Verdict::Differs, 3)));
}

TEST(Baseline, OfSomeRulesExcusesUnderNoOthers) {
  Baseline baseline = baselineFor({"coverage"});
  baseline.entries[0].rules = "spec";
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 1)), BaselineStatus::ExpectedDiff);
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 1), "driver", "Version 1.2", "lavapipe"), BaselineStatus::None);
}

TEST(Baseline, OfAProfileExcusesUnderEveryProfileOfADriver) {
  Baseline baseline = baselineFor({"coverage"});
  baseline.entries[0].rules = "profile";
  for (const char* rules : {"lavapipe", "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"}) {
    EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 1), "driver", "Version 1.2", rules), BaselineStatus::ExpectedDiff) << rules;
  }
  for (const char* rules : {"spec", "d3d11", "reference"}) {
    EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Differs, 1), "driver", "Version 1.2", rules), BaselineStatus::None) << rules;
  }
}

TEST(Baseline, ProfileFromAFileMayDescribeTheDifferenceSoThatNothingIsMended) {
  const Baseline baseline = baselineFor({"coverage"});
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Same, 0), "driver", "Version 1.2", "driver (inferred)"), BaselineStatus::None);
  EXPECT_EQ(statusOf(baseline, resultOf(Verdict::Same, 0), "driver", "Version 1.2", "lavapipe"), BaselineStatus::Improved);
}

TEST(Baseline, ExcusesACrashOnlyByName) {
  EXPECT_EQ(statusOf(baselineFor({"crash"}), resultOf(Verdict::Crashed, 0)), BaselineStatus::ExpectedDiff);
  EXPECT_EQ(statusOf(baselineFor({"crash"}), resultOf(Verdict::Differs, 1)), BaselineStatus::None);
  EXPECT_EQ(statusOf(baselineFor({"coverage"}), resultOf(Verdict::Crashed, 0)), BaselineStatus::None);
}

TEST(Baseline, EntryOfAMendedDriverIsUnexpected) {
  for (const Verdict verdict : {Verdict::Same, Verdict::Allowed}) {
    SceneResult result = resultOf(verdict, 0);
    applyBaseline(baselineFor({"coverage"}), "driver", "Version 1.2", "spec", result);
    EXPECT_EQ(result.baseline, BaselineStatus::Improved);
    EXPECT_TRUE(isUnexpected(result));
  }
}

TEST(Baseline, SurvivesItsFile) {
  const std::string text = writeBaseline(baselineFor({"coverage", "depth"}));
  const Result<Baseline> read = parseBaseline(text, "file.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(writeBaseline(*read), text);
}

TEST(Baseline, BadFilesAreRefusedWithTheirPlace) {
  const auto whereOf = [](std::string_view text) { return parseBaseline(text, "f.json").error().where; };
  EXPECT_EQ(whereOf("{\n \"entries\": [,]}").substr(0, 9), "f.json:2:");
  EXPECT_EQ(whereOf("[]"), "f.json");
  EXPECT_EQ(whereOf("{\"entries\": [{\"driver\": 3}]}"), "f.json: entries[0]");
  EXPECT_EQ(whereOf("{\"entries\": [{\"driver\": \"a\", \"scene\": \"b\", \"planes\": [\"depth\"]}]}"), "f.json: entries[0]");
  EXPECT_EQ(whereOf("{\"entries\": [{\"colour\": \"a\"}]}"), "f.json: entries[0]");
}

TEST(BuiltInBaseline, NamesScenesOfTheCatalogueAndGivesReasons) {
  for (const BaselineEntry& entry : builtInBaseline().entries) {
    // What hunt knows by its traits is no scene of the catalogue.
    const bool ofHunt = entry.scene.starts_with("hunt/") && !entry.when.empty();
    const bool ofInvariant = std::ranges::any_of(invariants::invariants(), [&](const invariants::Invariant& invariant) {
      return entry.scene == std::string(kInvariantPrefix) + std::string(invariant.name);
    });
    EXPECT_TRUE(ofHunt || ofInvariant || !matchCatalogue(entry.scene).empty()) << entry.scene;
    EXPECT_TRUE(entry.anchor.starts_with("vk:")) << entry.scene;
    EXPECT_FALSE(entry.reason.empty());
    EXPECT_FALSE(entry.rule.empty());
  }
}

}  // namespace
}  // namespace rasterdiff::harness
