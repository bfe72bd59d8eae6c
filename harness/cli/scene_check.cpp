#include "harness/cli/scene_check.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "harness/cli/metered.hpp"
#include "harness/cli/pool.hpp"
#include "harness/compare/compare.hpp"
#include "harness/compare/placement/placement.hpp"
#include "harness/report/close_up.hpp"
#include "harness/report/npy.hpp"
#include "harness/report/picture.hpp"
#include "rasterizer/render.hpp"
#include "scene/primitive_class.hpp"
#include "scene/stopwatch.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr uint32_t kWidestPicture = 960, kThumbnail = 96;  // pixels

/// "fill/a" → fill/a, "../x/y.scene.json" → _/x/y.scene.json: always below the dump folder.
std::filesystem::path dumpFolder(const std::filesystem::path& root, std::string_view address) {
  std::filesystem::path folder = root;
  while (!address.empty()) {
    const size_t slash = address.find('/');
    if (slash != 0) folder /= planeFileName(address.substr(0, slash));
    address.remove_prefix(slash == std::string_view::npos ? address.size() : slash + 1);
  }
  return folder;
}

Result<void> dump(const std::filesystem::path& root, const Job& job, const Frame& reference, const Frame& actual) {
  const std::filesystem::path folder = dumpFolder(root, job.address);
  if (auto files = writeNpyFiles(folder / "reference", reference); !files) return tl::unexpected(files.error());
  if (auto files = writeNpyFiles(folder / "driver", actual); !files) return tl::unexpected(files.error());
  return {};
}

Result<Pictures> picturesOf(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual, const SceneResult& result) {
  const Image left = shrunk(glanceImage(reference), kWidestPicture, Shrink::Average);
  const Image right = shrunk(glanceImage(actual), kWidestPicture, Shrink::Average);
  const Image difference = shrunk(differenceImage(reference, actual, result), kWidestPicture, Shrink::Worst);
  Pictures pictures;
  pictures.width = left.width;
  pictures.height = left.height;
  const Image thumbnail = shrunk(left, kThumbnail, Shrink::Average);
  for (const auto& [image, file] : {std::pair{&left, &pictures.reference}, {&right, &pictures.driver},
                                    {&difference, &pictures.difference}, {&thumbnail, &pictures.thumbnail}}) {
    Result<std::string> png = encodePng(*image);
    if (!png) return tl::unexpected(png.error());
    *file = std::move(*png);
  }
  if (const auto focus = focusOf(result)) pictures.closeUp = closeUp(scene, rules, reference, actual, result, *focus);
  return pictures;
}

/// The verdict that an error of the driver amounts to; none for errors that are not the driver's.
std::optional<Verdict> verdictOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::NotOffered: return Verdict::Skipped;
    case ErrorCode::DeviceLost: return Verdict::Crashed;
    case ErrorCode::TimedOut: return Verdict::TimedOut;
    case ErrorCode::BadInput:
    case ErrorCode::Io:
    case ErrorCode::NoDevice: return std::nullopt;
  }
  return std::nullopt;
}

void conclude(CheckedScene& checked, const Error& error) {
  const std::optional<Verdict> verdict = verdictOf(error.code);
  if (!verdict) {
    checked.entry.error = error;
    return;
  }
  checked.entry.result.verdict = *verdict;
  checked.entry.result.reason = error.where.empty() ? error.what : error.where + ": " + error.what;
  checked.subjectLost = *verdict != Verdict::Skipped;
}

/// What came of one round.
struct Round {
  Frame reference, actual;
  SceneResult result;
  rasterizer::RuleCounts counts;
  Seconds seconds;
};

/// Everything that can fail, in order; the caller turns the error into a verdict.
Result<Round> drawAndCompare(const Scene& scene, Subject& subject, const rasterizer::Rules& rules, const CheckSettings& settings,
                             const std::function<void(std::string_view)>& entering) {
  Round round;
  entering(kDriverPhase);
  MeteredSubject metered(subject);
  Result<Frame> actual = metered.render(scene);
  if (!actual) return tl::unexpected(actual.error());
  round.seconds += metered.seconds();
  round.actual = std::move(*actual);

  entering("reference");
  Stopwatch watch;
  RowPasses early(scene, rules, round.actual);
  const auto judge = [&](const Frame& drawn, uint32_t first, uint32_t end) { early.judge(drawn, first, end); };
  Result<Frame> reference = rasterizer::render(scene, rules, &round.counts, settings.threads, judge);
  if (!reference) return tl::unexpected(reference.error());
  round.reference = std::move(*reference);
  const double compared = early.seconds() / settings.threads;
  round.seconds.reference = watch.lap() - compared;

  entering("compare");
  Result<SceneResult> result = compare(scene, rules, round.reference, round.actual, settings.threads, &early);
  if (!result) return tl::unexpected(result.error());
  if (Result<void> judged = judgeJointly(scene, rules, round.reference, round.actual, *result); !judged) return tl::unexpected(judged.error());
  round.result = std::move(*result);
  round.seconds.compare = compared + watch.lap();
  return round;
}

Result<void> check(SceneEntry& entry, const Job& job, Subject& subject, const rasterizer::Rules& rules, const CheckSettings& settings,
                   const std::function<void(std::string_view)>& entering) {
  Stopwatch watch;
  entering("scene");
  const Result<Scene> scene = drawable(job);
  if (!scene) return tl::unexpected(scene.error());
  entry.width = scene->target.width;
  entry.height = scene->target.height;
  entry.samplesPerPixel = scene->target.samples;
  entry.primitives = primitiveCount(*scene);
  const double setUp = watch.lap();

  std::vector<Seconds> rounds;
  std::optional<Round> last;
  while (rounds.size() < settings.rounds) {
    last.reset();  // its memory is the next one's
    Result<Round> round = drawAndCompare(*scene, subject, rules, settings, entering);
    if (!round) return tl::unexpected(round.error());
    rounds.push_back(round->seconds);
    last = std::move(*round);
  }
  Seconds seconds = medianOf(rounds);
  seconds.setUp = setUp;
  entry.result = std::move(last->result);
  entry.result.id = job.id;
  for (const rasterizer::RuleInfo& rule : rasterizer::countedRules()) {
    if (last->counts[rule.rule] > 0) entry.result.ruleCoverage[std::string(rule.id)] += last->counts[rule.rule];
  }

  entering("report");
  watch.lap();
  if (settings.dump) {
    if (Result<void> dumped = dump(*settings.dump, job, last->reference, last->actual); !dumped) return dumped;
  }
  if (settings.pictures) {
    Result<Pictures> pictures = picturesOf(*scene, rules, last->reference, last->actual, entry.result);
    if (!pictures) return tl::unexpected(pictures.error());
    entry.pictures = std::move(*pictures);
  }
  if (settings.dump || settings.pictures) seconds.pictures = watch.lap();
  entry.result.seconds = seconds;
  return {};
}

}  // namespace

SceneEntry entryOf(const Job& job) {
  SceneEntry entry;
  entry.result.id = job.id;
  entry.address = job.address;
  entry.what = job.what;
  entry.link = job.link;
  entry.rules = job.rules;
  return entry;
}

CheckedScene checkScene(const Job& job, Subject& subject, const rasterizer::Rules& rules,
                        const CheckSettings& settings, const std::function<void(std::string_view)>& entering) {
  CheckedScene checked{entryOf(job), false};
  const size_t messagesBefore = subject.validationMessages().size();
  if (const Result<void> drawn = check(checked.entry, job, subject, rules, settings, entering); !drawn) {
    conclude(checked, drawn.error());
  }
  const std::vector<std::string> messages = subject.validationMessages();
  checked.entry.validationMessages.assign(messages.begin() + static_cast<std::ptrdiff_t>(messagesBefore),
                                          messages.end());
  return checked;
}

}  // namespace rasterdiff::harness::cli
