// `infer` writes a profile that `check --rules` demands of the driver it came from, and of no other.
#include <gtest/gtest.h>

#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

TEST(InferCommand, WritesAProfileThatItsDriverFollowsAndAnotherDoesNot) {
  TemporaryFolder folder;
  const std::string file = folder.path("profile.json");
  const Outcome found = runProgram({"infer", "--driver", "synthetic:3", "-o", file});
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("subpixel bits in use"), std::string::npos) << found.out;
  EXPECT_NE(found.out.find("--rules " + file), std::string::npos) << found.out;
  const Outcome own = runProgram({"check", "random/*", "--rules", file, "--driver", "synthetic:3"});
  EXPECT_EQ(own.status, 0) << own.out;
  EXPECT_NE(own.out.find(" 0 allowed, 0 differ"), std::string::npos) << own.out;
  const Outcome other = runProgram({"check", "random/*", "--rules", file, "--driver", "synthetic:4"});
  EXPECT_EQ(other.status, 1) << other.out;
}

TEST(InferCommand, PrintsJson) {
  const Outcome found = runProgram({"infer", "--driver", "synthetic:3", "--json"});
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_EQ(found.out.substr(0, 1), "{");
  EXPECT_NE(found.out.find("rasterdiff-inference-1"), std::string::npos);
}

TEST(InferCommand, RefusesAFolderAsOutputBeforeTheWork) {
  TemporaryFolder folder;
  const Outcome refused = runProgram({"infer", "--driver", "synthetic:3", "-o", folder.path("no/such/folder.json")});
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_EQ(refused.out, "");
}

}  // namespace
}  // namespace rasterdiff::test
