// Several drivers in one command: ranges of legal renderers and hidden rules, globs over deliberate errors.
#include "harness/report/panel.hpp"

#include <gtest/gtest.h>

#include "harness/cli/driver_range.hpp"
#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

using harness::cli::driversNamed;
using harness::cli::namesSeveral;

TEST(DriverRange, NamesEachDriver) {
  EXPECT_EQ(*driversNamed("legal:9..11"), (std::vector<std::string>{"legal:9", "legal:10", "legal:11"}));
  EXPECT_EQ(*driversNamed("mutant:*-snap*"), *driversNamed("mutant:*-snap*"));
  EXPECT_EQ(*driversNamed("lavapipe"), std::vector<std::string>{"lavapipe"});
  EXPECT_TRUE(namesSeveral("synthetic:1..2"));
  EXPECT_TRUE(namesSeveral("mutant:half*"));
  EXPECT_FALSE(namesSeveral("legal:7"));
  EXPECT_FALSE(namesSeveral("../icd.json"));
}

TEST(DriverRange, RefusesWhatIsNoRange) {
  for (const char* text : {"legal:3..1", "legal:..3", "legal:1..", "legal:1..2..3", "legal:-1..4", "legal:0..99999", "mutant:nothing-like-it*"}) {
    EXPECT_FALSE(driversNamed(text).has_value()) << text;
  }
}

TEST(CheckOfSeveral, LetsLegalRenderersThrough) {
  const Outcome outcome = runProgram({"check", "fill/*", "--driver", "legal:1..3", "--rules", "spec"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("PASS: 3 of 3 renderers let through"), std::string::npos) << outcome.out;
}

TEST(CheckOfSeveral, SaysWhichScenesCatchADeliberateError) {
  const Outcome outcome = runProgram({"check", "fill/*", "--driver", "mutant:half-pixel-shif*"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 of 1 deliberate error caught"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("fill "), std::string::npos) << outcome.out;
}

TEST(CheckOfSeveral, FailsWhereADeliberateErrorIsNotCaught) {
  const Outcome outcome = runProgram({"check", "fill/*", "--driver", "mutant:truncating-sna*", "--rules", "spec"});
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("not caught"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("rasterdiff check --driver mutant:truncating-snap --rules spec"), std::string::npos) << outcome.err;
}

TEST(CheckOfSeveral, RefusesWhatIsAboutOneDriver) {
  TemporaryFolder folder;
  const Outcome outcome = runProgram({"check", "fill/*", "--driver", "legal:1..3", "--report", folder.path("report.html")});
  EXPECT_EQ(outcome.status, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("--report"), std::string::npos) << outcome.err;
}

TEST(InferOfSeveral, RecoversHiddenRules) {
  const Outcome outcome = runProgram({"infer", "--driver", "synthetic:1..2"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("PASS: 2 of 2 hidden rule sets recovered exactly"), std::string::npos) << outcome.out;
  EXPECT_EQ(runProgram({"infer", "--driver", "legal:1..2"}).status, 2);
}

}  // namespace
}  // namespace rasterdiff::test
