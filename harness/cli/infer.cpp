// `infer`: finds the driver's profile by experiment, in a process that may die of it, prints a card and writes the profile.
#include "harness/infer/infer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "harness/cli/driver_range.hpp"
#include "harness/cli/hidden_rules.hpp"
#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/infer/card.hpp"
#include "harness/profile/profile_file.hpp"
#include "harness/report/output.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr char kSeparator = '\0';  // in none of the texts

/// One line that is rewritten on a terminal; nothing elsewhere, the whole takes seconds.
void showProgress(std::string_view question, uint32_t scenes) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\x1b[K{} experiments: {}", scenes, question);
  std::fflush(stderr);
}

Profile profileOf(const Inference& inference) {
  Profile profile;
  profile.name = fmt::format("{} {}", inference.driver, inference.info);
  profile.driver = inference.driver;
  profile.info = inference.info;
  profile.choices = inference.choices;
  profile.openChoices = inference.openChoices;
  return profile;
}

}  // namespace

int runVerb(const InferOptions& options) {
  if (namesSeveral(options.choice.driver)) return inferSeveral(options);
  if (!options.output.empty()) {
    if (const Result<void> writable = checkWritable(options.output); !writable) {
      return complain(writable.error(), "rasterdiff infer --help");
    }
  }
  const double patience = 60 + 10 * watchdogSeconds(options.choice.timeoutSeconds);
  const Result<std::string> found = isolated(patience, [&]() -> Result<std::string> {
    const Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(options.choice));
    if (!subject) return tl::unexpected(subject.error());
    const Result<Inference> inference = harness::infer(**subject, harness::InferOptions{options.seed, showProgress});
    if (!inference) return tl::unexpected(inference.error());
    return writeProfile(profileOf(*inference)) + kSeparator + (options.json ? inferenceJson(*inference) : inferenceCard(*inference));
  });
  if (isatty(fileno(stderr)) != 0) fmt::print(stderr, "\r\x1b[K");
  if (!found) return complain(found.error(), nextCommand(found.error(), "infer"));
  const size_t end = found->find(kSeparator);
  fmt::print("{}", found->substr(end + 1));
  if (options.output.empty()) return 0;
  if (const Result<void> written = writeFile(options.output, found->substr(0, end)); !written) {
    return complain(written.error(), "rasterdiff infer --help");
  }
  if (!options.json) {
    fmt::print("profile      {}\n\nrasterdiff check 'random/*' --count 1000000 --driver {} --rules {}\n", options.output,
               options.choice.driver, options.output);
  }
  return 0;
}

}  // namespace rasterdiff::harness::cli
