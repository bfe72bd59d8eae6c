// The rules as JSON: {drivers: [...], rules: [...]}, the standings of a rule in the order of the drivers.
#include "harness/report/json_parts.hpp"
#include "harness/report/rule_survey.hpp"

namespace rasterdiff::harness {
namespace {

Json jsonOf(const DriverPass& pass) {
  if (!pass.refusal.empty()) return {{"driver", pass.driver}, {"refusal", pass.refusal}};
  Json json{{"driver", pass.driver}, {"name", pass.subject.name}, {"info", pass.subject.info}, {"rules", pass.subject.rules},
            {"scenes", pass.scenes.size()}, {"seconds", pass.seconds}};
  if (!pass.stopped.empty()) json["stopped"] = pass.stopped;
  return json;
}

Json jsonOf(const RuleStanding& standing, const std::string& driver) {
  Json json{{"driver", driver}, {"state", toString(standing.state)}, {"same", standing.same}, {"allowed", standing.allowed},
            {"differing", standing.differing}, {"differingForAnotherRule", standing.otherwise}, {"skipped", standing.skipped},
            {"decided", standing.decided}, {"freedoms", standing.freedoms}};
  if (!standing.reason.empty()) json["reason"] = standing.reason;
  for (const RuleStanding::Difference& difference : standing.differences) {
    json["differences"].push_back({{"reason", difference.reason}, {"known", difference.known}, {"scenes", difference.scenes}});
  }
  return json;
}

}  // namespace

std::string rulesJson(std::span<const RuleSurvey> rules, std::span<const DriverPass> passes) {
  Json document{{"drivers", Json::array()}, {"rules", Json::array()}};
  for (const DriverPass& pass : passes) document["drivers"].push_back(jsonOf(pass));
  for (const RuleSurvey& rule : rules) {
    Json json{{"id", rule.id}, {"names", rule.names}, {"anchors", rule.anchors}, {"decided", rule.decided},
              {"decidingScenes", rule.decidingScenes}, {"mutants", rule.mutants}, {"scenes", Json::array()},
              {"standings", Json::array()}};
    for (const CatalogueEntry* scene : rule.scenes) json["scenes"].push_back(scene->name);
    for (size_t i = 0; i < passes.size(); ++i) json["standings"].push_back(jsonOf(rule.drivers[i], passes[i].driver));
    document["rules"].push_back(std::move(json));
  }
  return textOf(document) + "\n";
}

}  // namespace rasterdiff::harness
