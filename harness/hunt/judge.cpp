#include "harness/hunt/judge.hpp"

#include <algorithm>

#include "harness/compare/compare.hpp"
#include "rasterizer/render.hpp"
#include "scene/file/enum_names.hpp"

namespace rasterdiff::harness::hunt {
namespace {

std::string_view kindOf(const SampleDifference& d) {
  if (d.actualPrimitive == d.expectedPrimitive) {
    return d.actualCount > d.expectedCount ? "coverage/twice" : "coverage/once-less";
  }
  if (d.actualPrimitive == 0) return "coverage/missing";
  return d.expectedPrimitive == 0 ? "coverage/extra" : "coverage/other";
}

void note(std::vector<Difference>& differences, std::string kind, uint32_t x, uint32_t y, uint32_t sample) {
  const bool known = std::any_of(differences.begin(), differences.end(), [&](const Difference& d) { return d.kind == kind; });
  if (!known) differences.push_back({std::move(kind), x, y, sample});
}

std::vector<Difference> differencesOf(const Scene& scene, const SceneResult& result) {
  std::vector<Difference> differences;
  for (const SampleDifference& d : result.differences) {
    if (d.verdict == Verdict::Differs) note(differences, std::string(kindOf(d)), d.x, d.y, d.sample);
  }
  for (const ValueStats& stats : result.values) {
    if (!stats.firstDiffering) continue;
    const ValueStats::Worst& at = *stats.firstDiffering;
    note(differences, kindOfPlane(scene, stats.name), at.x, at.y, at.sample);
  }
  return differences;
}

Judgement unfinished(const Error& error) {
  Judgement judgement;
  judgement.reason = error.what;
  judgement.verdict = Verdict::Skipped;
  if (error.code == ErrorCode::DeviceLost) judgement.verdict = Verdict::Crashed;
  if (error.code == ErrorCode::TimedOut) judgement.verdict = Verdict::TimedOut;
  if (judgement.verdict == Verdict::Crashed) judgement.differences = {{"crash"}};
  if (judgement.verdict == Verdict::TimedOut) judgement.differences = {{"hang"}};
  return judgement;
}

}  // namespace

const Difference* find(const Judgement& judgement, std::string_view kind) {
  const auto at = std::find_if(judgement.differences.begin(), judgement.differences.end(),
                               [&](const Difference& d) { return d.kind == kind; });
  return at == judgement.differences.end() ? nullptr : &*at;
}

std::string_view planeKind(std::string_view kind) { return kind.substr(0, kind.find('/')); }

std::string kindOfPlane(const Scene& scene, std::string_view plane) {
  constexpr std::string_view kResolved = ".resolved";
  if (plane.ends_with(kResolved)) {
    return "resolved/" + kindOfPlane(scene, plane.substr(0, plane.size() - kResolved.size()));
  }
  for (const Draw& draw : scene.draws) {
    for (const Varying& varying : draw.varyings) {
      if (varying.name == plane) return std::string(enumName(varying.interpolation));
    }
  }
  return std::string(plane);
}

Judgement judge(const Scene& scene, Subject& subject, const rasterizer::Rules& rules) {
  if (const Result<void> valid = validate(scene); !valid) return unfinished(valid.error());
  const Result<Frame> actual = subject.render(scene);
  if (!actual) return unfinished(actual.error());
  Judgement judgement;
  const Result<Frame> reference = rasterizer::render(scene, rules, &judgement.counts);
  if (!reference) return unfinished(reference.error());
  const Result<SceneResult> result = compare(scene, rules, *reference, *actual);
  if (!result) return unfinished(result.error());
  judgement.verdict = result->verdict;
  judgement.reason = result->reason;
  judgement.samples = result->samples;
  for (const ValueStats& stats : result->values) judgement.values += stats.compared;
  if (judgement.verdict == Verdict::Differs) judgement.differences = differencesOf(scene, *result);
  return judgement;
}

}  // namespace rasterdiff::harness::hunt
