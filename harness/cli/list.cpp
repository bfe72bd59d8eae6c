// `list`: the catalogue, and what can be named on the command line; rules with a driver's standing, measured.
#include <fmt/format.h>

#include "harness/cli/message.hpp"
#include "harness/cli/run.hpp"
#include "harness/cli/survey.hpp"
#include "harness/report/listing.hpp"
#include "vkref/drivers.hpp"

namespace rasterdiff::harness::cli {
namespace {

int listRules(const ListOptions& options, std::span<const CatalogueEntry* const> entries) {
  std::vector<std::string> drivers = options.drivers;
  if (drivers.empty()) {
    for (const vkref::KnownDriver& known : vkref::knownDrivers()) drivers.emplace_back(known.name);
  }
  std::erase(drivers, "none");
  const Result<std::vector<Job>> jobs = selectScenes(std::vector<std::string>{options.glob}, std::nullopt);
  if (!jobs) return complain(jobs.error(), "rasterdiff list");
  std::vector<DriverPass> passes;
  for (const std::string& driver : drivers) {
    passes.push_back(passOver(*jobs, driver));
    if (!passes.back().refusal.empty() && !options.drivers.empty()) {
      return complain({ErrorCode::NoDevice, "--driver", passes.back().refusal, {}}, "rasterdiff devices");
    }
  }
  const std::vector<RuleSurvey> rules = surveyRules(entries, passes);
  fmt::print("{}", options.json ? rulesJson(rules, passes) : rulesText(rules, passes));
  return 0;
}

}  // namespace

int runVerb(const ListOptions& options) {
  const bool ofScenes = options.what == ListOptions::What::Scenes || options.what == ListOptions::What::Rules;
  const std::vector<const CatalogueEntry*> entries = matchCatalogue(options.glob);
  if (ofScenes && entries.empty()) {
    return complain({ErrorCode::BadInput, "GLOB", fmt::format("no scene is named '{}'", options.glob), {}},
                    "rasterdiff list");
  }
  std::string text;
  switch (options.what) {
    case ListOptions::What::Scenes: text = options.json ? scenesJson(entries) : scenesText(entries); break;
    case ListOptions::What::Rules: return listRules(options, entries);
    case ListOptions::What::Mutants: text = options.json ? mutantsJson() : mutantsText(); break;
    case ListOptions::What::Freedoms: text = options.json ? freedomsJson() : freedomsText(); break;
  }
  fmt::print("{}", text);
  return 0;
}

}  // namespace rasterdiff::harness::cli
