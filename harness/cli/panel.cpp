#include "harness/cli/panel.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "harness/cli/check_worker.hpp"
#include "harness/cli/driver_range.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/progress.hpp"
#include "harness/cli/survey.hpp"
#include "harness/report/output.hpp"
#include "harness/report/panel.hpp"

namespace rasterdiff::harness::cli {
namespace {

/// An option that has no meaning here, or empty.
std::string ofOneDriver(const CheckOptions& options) {
  if (!options.report.empty()) return "--report";
  if (!options.junit.empty()) return "--junit";
  if (!options.dump.empty()) return "--dump";
  if (options.shards > 1) return "--shard";
  if (!options.baseline.empty() && options.baseline != "none") return "--baseline";
  return {};
}

PanelRow rowOf(const std::vector<Job>& jobs, const DriverChoice& choice, unsigned workers, Progress& progress) {
  DriverPass pass = passOver(jobs, choice, workers, progress);
  Report report;
  report.subject = std::move(pass.subject);
  report.subject.driver = choice.driver;
  report.scenes = std::move(pass.scenes);
  report.notRun = pass.refusal.empty() ? pass.notRun : 0;
  report.wallSeconds = pass.seconds;
  PanelRow row = panelRow(report, choice.driver.starts_with("mutant:"));
  row.refusal = pass.refusal;
  return row;
}

}  // namespace

int checkSeveral(const CheckOptions& options, const std::vector<Job>& jobs) {
  if (const std::string option = ofOneDriver(options); !option.empty()) {
    return complain({ErrorCode::BadInput, option, "it is about one driver, and several are named", options.choice.driver},
                    "rasterdiff check --help");
  }
  const Result<std::vector<std::string>> drivers = driversNamed(options.choice.driver);
  if (!drivers) return complain(drivers.error(), nextCommand(drivers.error(), "check"));
  const auto start = std::chrono::steady_clock::now();
  Panel panel{options.choice.driver, options.choice.rules, {}, 0};
  Progress progress(jobs.size() * drivers->size());
  for (const std::string& driver : *drivers) {
    DriverChoice choice = options.choice;
    choice.driver = driver;
    panel.rows.push_back(rowOf(jobs, choice, options.jobs > 0 ? options.jobs : coresToUse(), progress));
  }
  progress.clear();
  panel.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}", panelText(panel));
  if (!options.json.empty()) {
    if (const Result<void> written = writeFile(options.json, panelJson(panel)); !written) return complain(written.error(), "rasterdiff check --help");
    fmt::print("results   {}\n", options.json);
  }
  const int status = exitStatus(panel);
  if (status == 0) return 0;
  std::fflush(stdout);
  for (const PanelRow& row : panel.rows) {
    if (!row.failed()) continue;
    fmt::print(stderr, "rasterdiff check --driver {} --rules {}\n", row.driver, options.choice.rules);
    break;
  }
  return status;
}

}  // namespace rasterdiff::harness::cli
