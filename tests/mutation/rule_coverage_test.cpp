// Every rule of docs/rules.md is counted, and decides often enough in the catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "rasterizer/mistakes/played_device.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/supersample.hpp"

namespace rasterdiff {
namespace {

using rasterizer::RuleInfo;

std::set<std::string> rulesOfTheTable() {
  std::ifstream file(RASTERDIFF_SOURCE_DIR "/docs/rules.md");
  const std::string table{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::regex row("\\n\\| (R[0-9]+) \\|");
  std::set<std::string> ids;
  for (std::sregex_iterator i(table.begin(), table.end(), row), end; i != end; ++i) ids.insert((*i)[1]);
  return ids;
}

TEST(RuleCoverage, CountsJustTheRulesOfTheTable) {
  std::set<std::string> counted;
  for (const RuleInfo& rule : rasterizer::countedRules()) counted.emplace(rule.id);
  EXPECT_EQ(counted, rulesOfTheTable());
}

TEST(RuleCoverage, RulesAreListedInTheOrderOfTheirEnumeration) {
  const auto rules = rasterizer::countedRules();
  for (size_t i = 0; i < rules.size(); ++i) EXPECT_EQ(static_cast<size_t>(rules[i].rule), i) << rules[i].name;
}

// Without meshes and random scenes, whose size is a matter of taste.
TEST(RuleCoverage, TheCatalogueHasEveryCounterDecideAThousandTimes) {
  const rasterizer::Rules rules = *rasterizer::Rules::profile("reference", rasterizer::playedDevice(rasterizer::DeliberateError::None));
  rasterizer::RuleCounts counts;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name.starts_with("mesh/") || entry.name.starts_with("random")) continue;
    const Scene scene = supersampled(*entry.make());

    ASSERT_TRUE(rasterizer::render(scene, rules, &counts)) << entry.name;
  }
  for (const RuleInfo& rule : rasterizer::countedRules()) {
    EXPECT_GE(counts[rule.rule], 1000U) << rule.id << " " << rule.name;
  }
}

}  // namespace
}  // namespace rasterdiff
