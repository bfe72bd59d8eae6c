// From results to a baseline.
#include "harness/compare/blessing.hpp"

#include <gtest/gtest.h>

namespace rasterdiff::harness {
namespace {

constexpr const char* kResults = R"JSON({"format": "rasterdiff-results-1", "driver": {"name": "llvmpipe", "info": "Mesa 22.3.6 (LLVM 15.0.6)"},
  "rules": "spec", "scenes": [
  {"id": "a/same", "verdict": "Same", "differing": 0, "values": {}},
  {"id": "a/wrong", "verdict": "Differs", "differing": 3, "values": {"depth": {"differing": 0}, "color": {"differing": 2}}},
  {"id": "b/crash", "verdict": "Crashed", "differing": 0, "values": {}},
  {"id": "b/known", "verdict": "Differs", "baseline": "ExpectedDiff", "differing": 1, "values": {}},
  {"id": "b/skipped", "verdict": "Skipped", "differing": 0, "values": {}}]})JSON";

BaselineEntry entry(const std::string& scene, const std::string& version = "Mesa 22.3") {
  return {"llvmpipe", version, "", scene, {"coverage"}, "", "", "an old reason", {}};
}

TEST(Bless, WhatDiffersGetsAnEntryWithItsPlanesAndTheReason) {
  const Blessing blessing = *bless(kResults, "r.json", {}, {{}, "known since today", "R9", "vk:somewhere"});
  ASSERT_EQ(blessing.added, (std::vector<std::string>{"a/wrong", "b/crash"}));
  const BaselineEntry& wrong = blessing.baseline.entries[0];
  EXPECT_EQ(wrong.driver, "llvmpipe");
  EXPECT_EQ(wrong.version, "Mesa 22.3.6");
  EXPECT_EQ(wrong.rules, "spec");
  EXPECT_EQ(wrong.planes, (std::vector<std::string>{"coverage", "color"}));
  EXPECT_EQ(wrong.rule, "R9");
  EXPECT_EQ(wrong.reason, "known since today");
  EXPECT_EQ(blessing.baseline.entries[1].planes, std::vector<std::string>{"crash"});
  EXPECT_TRUE(parseBaseline(writeBaseline(blessing.baseline), "b.json"));
}

TEST(Bless, OldEntriesGoWhereTheDriverIsBetterAndStayElsewhere) {
  const Baseline old{{entry("a/same"), entry("b/known"), entry("b/skipped"), entry("a/same", "Mesa 26")}};
  const Blessing blessing = *bless(kResults, "r.json", old, {{"[a]/*", "b/known", "b/skipped"}, "because", "", ""});
  EXPECT_EQ(blessing.gone, std::vector<std::string>{"a/same"});
  EXPECT_EQ(blessing.added, std::vector<std::string>{"a/wrong"});
  ASSERT_EQ(blessing.baseline.entries.size(), 4U);
  EXPECT_EQ(blessing.baseline.entries[0].scene, "b/known");
  EXPECT_EQ(blessing.baseline.entries[1].scene, "b/skipped");
  EXPECT_EQ(blessing.baseline.entries[2].version, "Mesa 26");
}

TEST(Bless, OtherFilesAreRefused) {
  for (const char* text : {"", "{}", "[1]", R"({"format": "other"})", R"({"format": "rasterdiff-results-1", "driver": 3})"}) {
    const Result<Blessing> blessing = bless(text, "r.json", {}, {{}, "because", "", ""});
    ASSERT_FALSE(blessing) << text;
    EXPECT_EQ(blessing.error().where, "r.json");
    EXPECT_EQ(blessing.error().code, ErrorCode::BadInput);
  }
}

}  // namespace
}  // namespace rasterdiff::harness
