// `hunt`: searches for scenes that differ, round by round, shrinks what it finds and writes it.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <set>

#include "harness/cli/hunt_workers.hpp"
#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/cli/scene_check.hpp"
#include "harness/hunt/summary.hpp"
#include "harness/report/output.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff::harness::cli {
namespace {

using Clock = std::chrono::steady_clock;

void showProgress(const hunt::Campaign& campaign, double seconds) {
  size_t fresh = 0;
  for (const hunt::Finding& finding : campaign.findings()) fresh += finding.known.empty() ? 1U : 0U;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  fmt::print(stderr, "{}{:.0f} s: {} scenes, {} pairs, {} found, {} known{}", terminal ? "\r\033[K" : "", seconds, campaign.tally().scenes,
             campaign.corpus().pairs(), fresh, campaign.findings().size() - fresh, terminal ? "" : "\n");
  std::fflush(stderr);
}

/// The difference picture of a scene, drawn in a process of its own; empty for what cannot be drawn.
std::string pictureOf(const Scene& scene, const DriverChoice& choice) {
  const Result<std::string> picture = isolated(watchdogSeconds(choice.timeoutSeconds), [&]() -> Result<std::string> {
    const Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(choice));
    if (!subject) return tl::unexpected(subject.error());
    const Result<rasterizer::Rules> rules = rulesFor(choice, **subject);
    if (!rules) return tl::unexpected(rules.error());
    const Job job{scene.name, scene.name, {}, {}, {}, [&]() -> Result<Scene> { return scene; }};
    return checkScene(job, **subject, *rules, {true, {}}, [](std::string_view) {}).entry.pictures.difference;
  });
  return picture.value_or(std::string());
}

/// Scene file and picture of a finding.
Result<hunt::Written> write(const hunt::Finding& finding, const HuntOptions& options, std::set<std::string>& taken) {
  const std::string stem = hunt::fileStem(finding);
  std::string name = stem;
  for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}-{}", stem, n);
  Scene scene = finding.scene;
  scene.name = "hunt/" + name;
  const std::filesystem::path folder = options.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);  // writing says what is wrong
  hunt::Written written{&finding, (folder / (name + ".scene.json")).string(), {}};
  if (Result<void> ok = writeFile(written.file, writeScene(scene)); !ok) return tl::unexpected(ok.error());
  const std::string picture = finding.verdict == Verdict::Differs ? pictureOf(scene, options.choice) : std::string();
  if (picture.empty()) return written;
  written.picture = (folder / (name + ".png")).string();
  if (Result<void> ok = writeFile(written.picture, picture); !ok) return tl::unexpected(ok.error());
  return written;
}

/// New findings first; known ones are written only where they are listed.
Result<std::vector<hunt::Written>> writeAll(const std::vector<hunt::Finding>& findings, const HuntOptions& options) {
  std::vector<hunt::Written> all;
  std::set<std::string> taken;
  for (const bool known : {false, true}) {
    for (const hunt::Finding& finding : findings) {
      if (finding.known.empty() == known) continue;
      if (known && !options.known) {
        all.push_back({&finding, {}, {}});
        continue;
      }
      Result<hunt::Written> written = write(finding, options, taken);
      if (!written) return tl::unexpected(written.error());
      all.push_back(std::move(*written));
    }
  }
  return all;
}

void search(hunt::Campaign& campaign, HuntWorkers& workers, const HuntOptions& options, Clock::time_point start) {
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  std::optional<Clock::time_point> deadline;
  if (!options.count) deadline = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.seconds));
  const uint64_t lanes = options.count ? (*options.count + hunt::kScenesPerLane - 1) / hunt::kScenesPerLane : UINT64_MAX;
  bool more = true;
  while (more && campaign.lanes() < lanes) {
    const uint64_t first = campaign.lanes();
    const auto count = static_cast<uint32_t>(std::min<uint64_t>(hunt::kLanesPerRound, lanes - first));
    std::vector<hunt::LaneResult> results = workers.lanes(campaign, first, count, deadline);
    more = results.size() == count && workers.stopped().empty();
    for (hunt::LaneResult& result : results) campaign.absorb(std::move(result));
    const std::vector<hunt::Raw> raw = campaign.toShrink();
    const std::vector<hunt::Shrunk> shrunk = workers.shrink(raw);
    for (size_t i = 0; i < raw.size(); ++i) campaign.absorb(raw[i], shrunk[i], workers.isSteady(shrunk[i]));
    showProgress(campaign, seconds());
  }
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

Error noFamily(const std::string& name) {
  std::string names;
  for (const hunt::Family& family : hunt::families()) names += fmt::format("{}{}: {}", names.empty() ? "" : "; ", family.name, family.what);
  return {ErrorCode::BadInput, "--family", fmt::format("there is no family '{}'", name), names};
}

}  // namespace

int runVerb(const HuntOptions& options) {
  const auto start = Clock::now();
  constexpr const char* kHelp = "rasterdiff hunt --help";
  const hunt::Family* family = hunt::familyByName(options.family);
  if (family == nullptr) return complain(noFamily(options.family), kHelp);
  if (const Result<void> known = checkRulesName(options.choice.rules); !known) return complain(known.error(), kHelp);
  if (!options.json.empty()) {
    if (const Result<void> writable = checkWritable(options.json); !writable) return complain(writable.error(), kHelp);
  }
  HuntWorkers workers(options);
  const Result<RunSubject> subject = workers.introduce();
  if (!subject) return complain(subject.error(), nextCommand(subject.error(), "hunt"));

  hunt::Campaign campaign({family, options.seed, subject->limits, subject->name, subject->info, subject->rules, builtInBaseline()});
  search(campaign, workers, options, start);
  Result<std::vector<hunt::Written>> written = writeAll(campaign.findings(), options);
  if (!written) return complain(written.error(), kHelp);
  const hunt::HuntReport report{*subject, options.family, options.seed, campaign.tally(), campaign.corpus().kept().size(), campaign.corpus().pairs(),
                                std::move(*written), workers.stopped(), std::chrono::duration<double>(Clock::now() - start).count()};
  fmt::print("{}", hunt::huntText(report, options.known));
  if (!options.json.empty()) {
    if (const Result<void> ok = writeFile(options.json, hunt::huntJson(report)); !ok) return complain(ok.error(), kHelp);
  }
  const int status = hunt::exitStatus(report);
  if (status == 0 || report.findings.empty() || report.findings.front().file.empty()) return status;
  std::fflush(stdout);
  const hunt::Written& first = report.findings.front();
  const std::string explain = hunt::explainCommand(report, first);
  fmt::print(stderr, "{}\n", explain.empty() ? hunt::checkCommand(report, first) : explain);
  return status;
}

}  // namespace rasterdiff::harness::cli
