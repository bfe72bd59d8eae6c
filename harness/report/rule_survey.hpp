// What is known of every rule: scenes, mutants, how often it decided, and how each driver stands to it. Measuring is
// cli/survey.hpp's business.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "harness/report/report.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::harness {

/// One driver's pass over the scenes.
struct DriverPass {
  std::string driver;              ///< as on the command line
  std::string refusal;             ///< why it could not be used; then nothing else is known
  RunSubject subject;
  std::vector<SceneEntry> scenes;  ///< judged against the baseline
  std::string stopped;             ///< why scenes were left out, or empty
  uint64_t notRun = 0;             ///< how many
  double seconds = 0;
};

/// How a driver stands to a rule.
struct RuleStanding {
  enum class State : uint8_t {
    Same,        ///< in every scene that the driver drew
    Allowed,     ///< a named freedom explains every difference
    Differs,     ///< in some scene, for this rule's sake
    NotOffered,  ///< the driver draws none of the scenes
    Unknown,     ///< the driver could not be used, or draws nothing here
  };
  State state = State::Unknown;
  uint64_t same = 0, allowed = 0, differing = 0, otherwise = 0, skipped = 0;  ///< scenes; otherwise: differing for another rule's sake
  uint64_t decided = 0;                       ///< over all scenes of the pass
  std::map<std::string, uint64_t> freedoms;   ///< freedom → samples or values in the rule's scenes
  std::string reason;                         ///< why it is not offered, or unknown
  struct Difference {
    std::string reason;               ///< the bug in a sentence, or what is wrong
    bool known = false;               ///< listed in the baseline
    std::vector<std::string> scenes;  ///< those that show it
  };
  std::vector<Difference> differences;
};
[[nodiscard]] std::string_view toString(RuleStanding::State state);

struct RuleSurvey {
  std::string id;                    ///< "R15"
  std::vector<std::string> names;    ///< of its counters: "tie-break"
  std::vector<std::string> anchors;  ///< "vk:primsrast-polygons-basic"
  std::vector<const CatalogueEntry*> scenes;  ///< that name the rule
  uint64_t decidingScenes = 0;       ///< scenes of the selection in which it decided something (first pass that ran)
  uint64_t decided = 0;              ///< how often, in that pass
  std::vector<std::string> mutants;  ///< that break it
  std::vector<RuleStanding> drivers; ///< one a pass
};

/// Every rule that is counted or that a scene names, by number.
[[nodiscard]] std::vector<RuleSurvey> surveyRules(std::span<const CatalogueEntry* const> entries,
                                                  std::span<const DriverPass> passes);

/// 15 of "R15"; 0 if there is no number.
[[nodiscard]] int ruleNumber(std::string_view id);

[[nodiscard]] std::string rulesText(std::span<const RuleSurvey> rules, std::span<const DriverPass> passes);
[[nodiscard]] std::string rulesJson(std::span<const RuleSurvey> rules, std::span<const DriverPass> passes);

}  // namespace rasterdiff::harness
