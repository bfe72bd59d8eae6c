#include "harness/cli/rule_choice.hpp"

#include <algorithm>

#include "harness/profile/profile_file.hpp"

namespace rasterdiff::harness::cli {
namespace {

bool madeOfReference(const std::string& driver) {
  return driver.starts_with("mutant:") || driver.starts_with("fault:") || driver.starts_with("method:") ||
         driver.starts_with("synthetic:");
}

bool isProfile(const std::string& rules) {
  const auto names = rasterizer::profiles();
  return std::find(names.begin(), names.end(), rules) != names.end();
}

Result<rasterizer::Rules> named(const std::string& rules, const Limits& limits) {
  if (rules == "spec") return rasterizer::Rules::specification(limits);
  if (namesProfileFile(rules)) {
    const Result<Profile> profile = loadProfile(rules);
    if (!profile) return tl::unexpected(profile.error());
    return rulesOf(*profile, limits);
  }
  return rasterizer::Rules::profile(rules, limits);
}

}  // namespace

Result<void> checkRulesName(const std::string& rules) {
  if (rules == "auto") return {};
  if (const Result<rasterizer::Rules> found = named(rules, Limits{}); !found) return tl::unexpected(found.error());
  return {};
}

SubjectOptions subjectOptions(const DriverChoice& choice) {
  SubjectOptions options{choice.driver, choice.validate, choice.timeoutSeconds};
  if (isProfile(choice.rules)) options.profile = choice.rules;
  return options;
}

Result<rasterizer::Rules> rulesFor(const DriverChoice& choice, const Subject& subject) {
  if (choice.rules != "auto") return named(choice.rules, subject.limits());
  if (madeOfReference(choice.driver)) return named("reference", subject.limits());
  return rasterizer::Rules::forDriver(subject.name(), subject.limits());
}

Result<rasterizer::Rules> rulesWithoutDriver(const std::string& rules) {
  return named(rules == "auto" ? "reference" : rules, Limits{});
}

}  // namespace rasterdiff::harness::cli
