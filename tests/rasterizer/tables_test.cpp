// Tables that are indexed by an enumerator hold its row at its place, with unique, complete names.
#include <gtest/gtest.h>

#include <set>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/freedoms.hpp"
#include "rasterizer/rule_counts.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool isKebab(std::string_view name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos;
}

bool isRuleId(std::string_view id) {
  return id.size() >= 2 && id[0] == 'R' && id.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

TEST(Tables, EveryFreedomHasItsRowInOrder) {
  std::set<std::string_view> ids;
  for (size_t i = 0; i < freedoms().size(); ++i) {
    const FreedomInfo& row = freedoms()[i];
    EXPECT_EQ(static_cast<size_t>(row.freedom), i) << row.id;
    EXPECT_EQ(&info(row.freedom), &row);
    EXPECT_TRUE(isKebab(row.id)) << row.id;
    EXPECT_TRUE(ids.insert(row.id).second) << row.id << " twice";
    EXPECT_FALSE(row.what.empty());
    EXPECT_EQ(row.anchor.starts_with("vk:"), row.freedom != Freedom::None) << row.id;
  }
}

TEST(Tables, EveryRuleThatIsCountedHasItsRowInOrder) {
  ASSERT_EQ(countedRules().size(), static_cast<size_t>(Rule::Count_));
  std::set<std::string_view> names;
  for (size_t i = 0; i < countedRules().size(); ++i) {
    const RuleInfo& row = countedRules()[i];
    EXPECT_EQ(static_cast<size_t>(row.rule), i) << row.name;
    EXPECT_TRUE(isRuleId(row.id)) << row.id;
    EXPECT_TRUE(isKebab(row.name)) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " twice";
    EXPECT_TRUE(row.anchor.starts_with("vk:")) << row.name;
  }
}

TEST(Tables, EveryDeliberateErrorHasItsRowInOrderAndIsFoundByName) {
  std::set<std::string_view> names;
  for (size_t i = 0; i < deliberateErrors().size(); ++i) {
    const DeliberateErrorInfo& row = deliberateErrors()[i];
    EXPECT_EQ(static_cast<size_t>(row.error), i + 1) << row.name << ": enumerator 0 is None";
    EXPECT_TRUE(isRuleId(row.rule)) << row.rule;
    EXPECT_TRUE(isKebab(row.name)) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " twice";
    EXPECT_FALSE(row.what.empty());
    EXPECT_EQ(deliberateErrorByName(row.name), row.error);
  }
  EXPECT_FALSE(deliberateErrorByName("no-such-mutant"));
  EXPECT_FALSE(deliberateErrorByName(""));
}

TEST(Profiles, EveryNameGivesClosedRulesWithTheDevicesLimits) {
  Limits limits;
  limits.subPixelPrecisionBits = 4;
  for (const std::string_view name : profiles()) {
    const Result<Rules> rules = Rules::profile(name, limits);
    ASSERT_TRUE(rules) << name;
    EXPECT_EQ(rules->name, name);
    EXPECT_FALSE(rules->open);
    EXPECT_EQ(rules->limits, limits);
    EXPECT_EQ(rules->error, DeliberateError::None);
  }
}

TEST(Profiles, UnknownNameIsRefusedWithTheKnownOnes) {
  const Result<Rules> rules = Rules::profile("no-such-profile", Limits{});
  ASSERT_FALSE(rules);
  EXPECT_EQ(rules.error().code, ErrorCode::BadInput);
  for (const std::string_view name : profiles()) EXPECT_NE(rules.error().hint.find(name), std::string::npos) << name;
}

TEST(Profiles, SpecificationIsOpenAndOtherDriversGetIt) {
  EXPECT_TRUE(Rules::specification(Limits{}).open);
  EXPECT_TRUE(Rules::forDriver("some other driver", Limits{}).open);
  EXPECT_EQ(Rules::forDriver("llvmpipe", Limits{}).name, "lavapipe");
}

}  // namespace
}  // namespace rasterdiff::rasterizer
