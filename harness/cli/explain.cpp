// `explain`: the exact numbers behind one sample, with the driver's answer from a process of its own.
#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/cli/selection.hpp"
#include "harness/compare/compare.hpp"
#include "harness/report/close_up.hpp"
#include "harness/report/explanation.hpp"
#include "harness/report/explanation_parts.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/output.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness::cli {
namespace {

Result<void> checkPlace(const Scene& scene, const ExplainOptions& options) {
  const Target& target = scene.target;
  if (options.x < target.width && options.y < target.height && options.sample < target.samples) return {};
  return fail(ErrorCode::BadInput, "X Y --sample",
              fmt::format("({}, {}) sample {} is outside the target", options.x, options.y, options.sample),
              fmt::format("the target has {} x {} pixels and {} a pixel, counted from 0", target.width, target.height,
                          counted(target.samples, "sample")));
}

/// Every mistake draws the scene anew: what a bunny takes is too long.
constexpr uint64_t kMostPrimitivesToTry = 10'000, kMostSamplesToTry = 600'000;

bool isSmall(const Scene& scene) {
  return primitiveCount(scene) <= kMostPrimitivesToTry &&
         uint64_t{scene.target.width} * scene.target.height * scene.target.samples <= kMostSamplesToTry;
}

Result<void> judge(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference,
                   const rasterizer::SampleExplanation& sample, const rasterizer::SampleQuery& query, DriverAnswer& driver) {
  Result<SceneResult> verdict = compare(scene, rules, reference, withOneSampleOf(reference, driver.frame, query));
  if (!verdict) return tl::unexpected(verdict.error());
  driver.verdict = std::move(*verdict);
  if (driver.verdict.verdict != Verdict::Differs || !isSmall(scene)) return {};
  std::vector<std::string_view> atWork;
  for (const rasterizer::Rule rule : sample.rules) atWork.push_back(ruleId(rule));
  Result<Suspicion> suspicion = suspicionOf(scene, rules, driver.frame, query, atWork);
  if (!suspicion) return tl::unexpected(suspicion.error());
  driver.suspicion = std::move(*suspicion);
  return {};
}

Result<Explanation> explainWith(const Scene& scene, const rasterizer::Rules& rules, const ExplainOptions& options,
                                std::optional<DriverAnswer> driver) {
  const rasterizer::SampleQuery query{options.x, options.y, options.sample};
  Result<rasterizer::SampleExplanation> sample = rasterizer::explain(scene, rules, query);
  if (!sample) return tl::unexpected(sample.error());
  Result<Frame> reference = rasterizer::render(scene, rules);
  if (!reference) return tl::unexpected(reference.error());
  if (driver) {
    if (Result<void> judged = judge(scene, rules, *reference, *sample, query, *driver); !judged) return tl::unexpected(judged.error());
  }
  return Explanation{options.scene, scene, rules, query, std::move(*sample), std::move(*reference), std::move(driver)};
}

Result<void> drawNeighbourhood(const Explanation& e, const ExplainOptions& options) {
  if (options.svg.empty()) return {};
  const Frame& actual = e.driver ? e.driver->frame : e.reference;
  SceneResult result;
  if (e.driver) {
    Result<SceneResult> whole = compare(e.scene, e.rules, e.reference, actual);
    if (!whole) return tl::unexpected(whole.error());
    result = std::move(*whole);
  }
  return writeFile(options.svg, closeUp(e.scene, e.rules, e.reference, actual, result, e.query) + "\n");
}

/// In the driver's process: '1' if the sample differs, '0' if not, then the text.
Result<std::string> askDriver(const Scene& scene, const ExplainOptions& options) {
  Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(options.choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<rasterizer::Rules> rules = rulesFor(options.choice, **subject);
  if (!rules) return tl::unexpected(rules.error());
  Result<Frame> frame = (*subject)->render(scene);
  if (!frame) return tl::unexpected(frame.error());
  const Result<Explanation> explanation =
      explainWith(scene, *rules, options, DriverAnswer{subjectLine(**subject), std::move(*frame), {}, {}});
  if (!explanation) return tl::unexpected(explanation.error());
  if (const Result<void> drawn = drawNeighbourhood(*explanation, options); !drawn) return tl::unexpected(drawn.error());
  const bool differs = explanation->driver->verdict.verdict == Verdict::Differs;
  return (differs ? '1' : '0') + explanationText(*explanation);
}

int explainAlone(const Scene& scene, const ExplainOptions& options) {
  const Result<rasterizer::Rules> rules = rulesWithoutDriver(options.choice.rules);
  if (!rules) return complain(rules.error(), "rasterdiff explain --help");
  const Result<Explanation> explanation = explainWith(scene, *rules, options, std::nullopt);
  if (!explanation) return complain(explanation.error(), nextCommand(explanation.error(), "explain"));
  if (const Result<void> drawn = drawNeighbourhood(*explanation, options); !drawn) return complain(drawn.error(), "rasterdiff explain --help");
  fmt::print("{}", explanationText(*explanation));
  return 0;
}

}  // namespace

int runVerb(const ExplainOptions& options) {
  if (const Result<void> known = checkRulesName(options.choice.rules); !known) {
    return complain(known.error(), "rasterdiff explain --help");
  }
  const Result<Job> job = selectScene(options.scene);
  if (!job) return complain(job.error(), nextCommand(job.error(), "explain"));
  const Result<Scene> scene = drawable(*job);
  if (!scene) return complain(scene.error(), nextCommand(scene.error(), "explain"));
  if (const Result<void> inside = checkPlace(*scene, options); !inside) {
    return complain(inside.error(), "rasterdiff explain --help");
  }
  if (options.choice.driver == "none") return explainAlone(*scene, options);

  const Result<std::string> answer =
      isolated(watchdogSeconds(options.choice.timeoutSeconds), [&] { return askDriver(*scene, options); });
  if (answer) {
    fmt::print("{}", answer->substr(1));
    if (answer->front() == '0') return 0;
    std::fflush(stdout);
    fmt::print(stderr, "rasterdiff check {} --driver {} --report report.html\n", shellQuoted(job->address),
               shellQuoted(options.choice.driver));
    return 1;
  }
  if (exitStatusOf(answer.error().code) == 4) {
    if (const int status = explainAlone(*scene, options); status != 0) return status;
    std::fflush(stdout);
  }
  return complain(answer.error(), nextCommand(answer.error(), "explain"));
}

}  // namespace rasterdiff::harness::cli
