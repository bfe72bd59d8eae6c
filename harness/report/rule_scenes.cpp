#include "harness/report/rule_scenes.hpp"

#include <algorithm>
#include <charconv>

#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::harness {

int ruleNumber(std::string_view id) {
  int number = 0;
  if (id.size() > 1) std::from_chars(id.data() + 1, id.data() + id.size(), number);
  return number;
}

std::vector<RuleScenes> ruleScenes(std::span<const CatalogueEntry* const> entries) {
  std::vector<RuleScenes> rules;
  for (const rasterizer::RuleInfo& rule : rasterizer::countedRules()) {
    rules.push_back({std::string(rule.id), std::string(rule.name), std::string(rule.anchor), {}});
  }
  for (const CatalogueEntry* entry : entries) {
    for (const std::string& id : entry->rules) {
      auto rule = std::find_if(rules.begin(), rules.end(), [&](const RuleScenes& known) { return known.id == id; });
      if (rule == rules.end()) rule = rules.insert(rules.end(), {id, {}, {}, {}});
      rule->scenes.push_back(entry);
    }
  }
  std::ranges::stable_sort(rules, {}, [](const RuleScenes& rule) { return ruleNumber(rule.id); });
  return rules;
}

}  // namespace rasterdiff::harness
