// `stability`: error as a function of how hard a scene is, for every method, the reference and every driver; each driver
// in a process of its own.
#include <fmt/format.h>
#include <fnmatch.h>

#include <chrono>
#include <cstdio>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/report/output.hpp"
#include "harness/report/stability_text.hpp"
#include "vkref/drivers.hpp"

namespace rasterdiff::harness::cli {
namespace {

using stability::Family;
using stability::Results;
using stability::Series;

Result<std::vector<Family>> selected(const std::string& glob) {
  std::vector<Family> chosen;
  std::string names;
  for (const Family& family : stability::families()) {
    names += (names.empty() ? "" : ", ") + family.name;
    if (fnmatch(glob.c_str(), family.name.c_str(), 0) == 0) chosen.push_back(family);
  }
  if (chosen.empty()) return fail(ErrorCode::BadInput, "FAMILY", fmt::format("no family is named '{}'", glob), "families: " + names);
  return chosen;
}

std::vector<std::string> driversOf(const StabilityOptions& options) {
  if (options.driver == "none") return {};
  if (options.driver != "all") return {options.driver};
  std::vector<std::string> installed;
  for (const vkref::KnownDriver& driver : vkref::knownDrivers()) {
    const auto manifests = vkref::manifestsOf(std::string(driver.name));
    if (manifests && !manifests->empty()) installed.emplace_back(driver.name);
  }
  return installed;
}

/// In the driver's process: its line, then its series.
Result<std::string> askDriver(const std::string& driver, const std::vector<Family>& families) {
  DriverChoice choice;
  choice.driver = driver;
  Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<rasterizer::Rules> rules = rulesFor(choice, **subject);
  if (!rules) return tl::unexpected(rules.error());
  std::string text = subjectLine(**subject) + "\n";
  for (const Family& family : families) {
    const Result<std::vector<Series>> series = measureDriver(family, **subject, *rules);
    if (!series) return tl::unexpected(series.error());
    text += recordOf(*series);
  }
  return text;
}

Result<void> addDriver(Results& results, const std::string& driver) {
  constexpr double kSeconds = 600;  // for all families
  const Result<std::string> answer = isolated(kSeconds, [&] { return askDriver(driver, results.families); });
  if (!answer) return tl::unexpected(answer.error());
  const size_t line = answer->find('\n');
  Result<std::vector<Series>> series = stability::readRecord(std::string_view(*answer).substr(line + 1));
  if (!series) return tl::unexpected(series.error());
  results.drivers.push_back(answer->substr(0, line));
  results.series.insert(results.series.end(), series->begin(), series->end());
  return {};
}

Result<void> writeOutputs(const StabilityOptions& options, const Results& results) {
  const auto write = [](const std::string& path, const auto& make) -> Result<void> {
    return path.empty() ? Result<void>{} : writeFile(path, make());
  };
  Result<void> written = write(options.json, [&] { return stabilityJson(results); });
  if (written) written = write(options.csv, [&] { return stabilityCsv(results); });
  if (written) written = write(options.svg, [&] { return stabilitySvg(results); });
  if (written) written = write(options.report, [&] { return stabilityHtml(results); });
  return written;
}

}  // namespace

int runVerb(const StabilityOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Result<std::vector<Family>> chosen = selected(options.family);
  if (!chosen) return complain(chosen.error(), "rasterdiff stability --help");
  for (const std::string* path : {&options.json, &options.csv, &options.svg, &options.report}) {
    if (path->empty()) continue;
    if (const Result<void> writable = checkWritable(*path); !writable) return complain(writable.error(), "rasterdiff stability --help");
  }
  Results results;
  results.families = std::move(*chosen);
  for (const Family& family : results.families) {
    fmt::print(stderr, "methods: {}\n", family.name);
    for (Series& series : measureMethods(family)) results.series.push_back(std::move(series));
  }
  int status = 0;
  for (const std::string& driver : driversOf(options)) {
    fmt::print(stderr, "driver: {}\n", driver);
    if (const Result<void> added = addDriver(results, driver); !added) status = complain(added.error(), nextCommand(added.error(), "stability"));
  }
  results.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}", stabilityText(results));
  if (const Result<void> written = writeOutputs(options, results); !written) {
    return complain(written.error(), "rasterdiff stability --help");
  }
  return status;
}

}  // namespace rasterdiff::harness::cli
