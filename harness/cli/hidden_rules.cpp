#include "harness/cli/hidden_rules.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <numeric>

#include "harness/cli/check_worker.hpp"
#include "harness/cli/driver_range.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/infer/infer.hpp"
#include "harness/infer/synthetic.hpp"
#include "harness/report/numbers.hpp"

namespace rasterdiff::harness::cli {
namespace {

using rasterizer::ChoiceInfo;

constexpr std::string_view kSynthetic = "synthetic:";

/// What was found wrong or left open; empty: every choice is the hidden one.
std::string deviation(const Inference& found, const rasterizer::Rules& hidden) {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  for (const ChoiceInfo& row : rasterizer::choiceTable()) {
    const Finding& finding = found.of(row.choice);
    const std::string_view is = row.answers[row.get(hidden.choices)], said = row.answers[row.get(found.choices)];
    if (finding.status != Finding::Status::Found) {
      add(fmt::format("{} is {}, left open", row.name, is));
    } else if (is != said) {
      add(fmt::format("{} is {}, taken for {}", row.name, is, said));
    }
  }
  if (found.choices.sampleLocations != hidden.choices.sampleLocations) add("sample locations are others");
  return text;
}

Result<std::string> recover(const InferOptions& options, const std::string& driver) {
  DriverChoice choice = options.choice;
  choice.driver = driver;
  const Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<Inference> found = harness::infer(**subject, harness::InferOptions{options.seed, {}});
  if (!found) return tl::unexpected(found.error());
  return deviation(*found, syntheticRules(std::stoull(driver.substr(kSynthetic.size()))));
}

void showProgress(size_t done, size_t all) {
  if (isatty(STDERR_FILENO) == 1) {
    fmt::print(stderr, "\r\x1b[K{}/{} renderers", done, all);
    std::fflush(stderr);
  } else if (done % 50 == 0) {
    fmt::print(stderr, "{}/{} renderers\n", done, all);
  }
}

}  // namespace

int inferSeveral(const InferOptions& options) {
  const Result<std::vector<std::string>> drivers = driversNamed(options.choice.driver);
  if (!drivers) return complain(drivers.error(), nextCommand(drivers.error(), "infer"));
  if (!drivers->front().starts_with(kSynthetic)) {
    return complain({ErrorCode::BadInput, "--driver", "only hidden rules can be looked for several at a time", "synthetic:1..100"}, "rasterdiff infer --help");
  }
  for (const auto& [given, option] : {std::pair{!options.output.empty(), "--output"}, {options.json, "--json"}}) {
    if (given) return complain({ErrorCode::BadInput, option, "it is about one driver, and several are named", options.choice.driver}, "rasterdiff infer --help");
  }
  const auto start = std::chrono::steady_clock::now();
  std::map<uint32_t, std::string> wrong;  // by renderer
  size_t done = 0;
  const auto count = [&](uint32_t job, std::string text) {
    if (!text.empty()) wrong[job] = std::move(text);
    showProgress(++done, drivers->size());
  };
  PoolEvents events;
  events.record = [&](uint32_t job, std::string_view record) {
    count(job, std::string(record));
    return true;
  };
  events.died = [&](uint32_t job, const Death& death) { count(job, death.what); };
  events.tick = [] {};
  PoolOptions pool;
  pool.workers = coresToUse();
  std::vector<uint32_t> order(drivers->size());
  std::iota(order.begin(), order.end(), 0U);
  const PoolOutcome outcome = runPool(order, pool, [&](WorkerLink& link) {
    link.opened({});
    while (const std::optional<uint32_t> job = link.nextJob()) {
      link.entering("inference");
      const Result<std::string> text = recover(options, (*drivers)[*job]);
      link.done(text ? *text : text.error().what, false);
    }
  }, events);
  if (isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\x1b[K");
  for (const auto& [job, text] : wrong) fmt::print("{:<14}  {}\n", (*drivers)[job], text);
  const size_t missing = wrong.size() + outcome.notRun;
  fmt::print("{}: {} of {} recovered exactly; {}\n", missing == 0 ? "PASS" : "FAIL", grouped(drivers->size() - missing),
             counted(drivers->size(), "hidden rule set"), secondsText(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
  if (missing == 0) return 0;
  std::fflush(stdout);
  if (!wrong.empty()) fmt::print(stderr, "rasterdiff infer --driver {}\n", (*drivers)[wrong.begin()->first]);
  return 1;
}

}  // namespace rasterdiff::harness::cli
