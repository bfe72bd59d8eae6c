// Words that nobody would type: every command line is an order, help, or a usage error with the next command.
#include <gtest/gtest.h>

#include <array>

#include "harness/cli/parse.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::test {
namespace {

constexpr std::array kVerbs{"check", "render", "explain", "bench", "stability", "infer", "devices", "list", "hunt", "bless", "methods", "invariants", "export", "chekc", ""};
constexpr std::array kWords{"fill/*",   "a.json",  "--driver", "lavapipe", "--rules", "spec",     "--timeout", "0",        "-1",      "1e999",   "nan",
                            "--count",  "--seed",  "--jobs",   "--shard",  "2/8",     "8/2",      "0/0",       "1/",       "--json",  "--help",  "--with",
                            "driver",   "-o",      "out",      "--report", "--",      "--x",      "-",         "=",        "--seed=", "--jobs=99999999999999999999",
                            "--rounds", "5.5",     "--size",   "1920x",    "--quick", "--family", "any",       "--amber",  "\xff",    "--sample",
                            "--rules=", "--known", "12",       "4294967296"};

TEST(CommandLine, IsAnOrderHelpOrAUsageError) {
  Prng random(1);
  int orders = 0, mistakes = 0;
  for (int i = 0; i < 5000; ++i) {
    std::vector<const char*> words{"rasterdiff", kVerbs[random.below(kVerbs.size())]};
    for (uint32_t n = random.below(6); n > 0; --n) words.push_back(kWords[random.below(kWords.size())]);
    std::string line;
    for (const char* word : words) line += std::string(word) + " ";
    const auto verb = harness::cli::parse(static_cast<int>(words.size()), words.data());
    if (verb) {
      ++orders;
      continue;
    }
    ASSERT_FALSE(verb.error().text.empty()) << line;
    if (verb.error().exitStatus == 0) continue;
    ++mistakes;
    ASSERT_EQ(verb.error().exitStatus, 2) << line;
    ASSERT_TRUE(verb.error().next.starts_with("rasterdiff ")) << line;
  }
  EXPECT_GT(orders, 100);
  EXPECT_GT(mistakes, 1000);
}

}  // namespace
}  // namespace rasterdiff::test
