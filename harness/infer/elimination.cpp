#include "harness/infer/elimination.hpp"

#include <algorithm>

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::ChoiceInfo;
using rasterizer::Choices;
using rasterizer::Rules;

constexpr size_t kMostContenders = 64;

// Answers that say something: not "as advertised", not "any".
std::vector<uint32_t> answersOf(Choice choice) {
  std::vector<uint32_t> answers;
  const bool firstIsNone = choice == Choice::SubPixelBits || choice == Choice::ResolveArithmetic;
  for (uint32_t i = firstIsNone ? 1 : 0; i < rasterizer::info(choice).answers.size(); ++i) answers.push_back(i);
  return answers;
}

class Run {
 public:
  Run(Subject& subject, const Rules& known, const Group& group, uint64_t seed)
      : subject_(subject), known_(known), group_(group), random_(seed) {
    expand();
  }

  Result<GroupOutcome> play(const std::function<void()>& finishedScene) {
    for (uint32_t round = 0; round < group_.rounds && !contradicted_; ++round) {
      std::optional<Scene> scene = group_.propose(random_, round, contenders(round));
      if (!scene) continue;
      Result<Frame> frame = subject_.render(*scene);
      if (!frame && frame.error().code == ErrorCode::NotOffered) continue;
      if (!frame) return tl::unexpected(frame.error());
      observations_.push_back({std::move(*scene), std::move(*frame)});
      if (const Result<void> met = meet(observations_.back()); !met) return tl::unexpected(met.error());
      finishedScene();
    }
    return weigh();
  }

 private:
  [[nodiscard]] Rules with(const Choices& choices) const {
    Rules rules = known_;
    rules.choices = choices;
    return rules;
  }

  void expand() {
    alive_ = {known_.choices};
    for (const Choice choice : group_.choices) {
      std::vector<Choices> next;
      for (const Choices& before : alive_) {
        for (const uint32_t answer : answersOf(choice)) {
          Choices candidate = before;
          rasterizer::info(choice).set(candidate, answer);
          next.push_back(candidate);
        }
      }
      alive_ = std::move(next);
    }
    std::erase_if(alive_, [this](const Choices& candidate) { return canonical(candidate, known_.limits) != candidate; });
    if (!group_.complete) return;
    for (Choices& candidate : alive_) group_.complete(candidate);
  }

  // All others being equal.
  [[nodiscard]] Choices changed(Choice choice, uint32_t answer) const {
    Choices rival = alive_.front();
    rasterizer::info(choice).set(rival, answer);
    if (group_.complete) group_.complete(rival);
    return rival;
  }

  // While several are possible, three scenes of four are to tell those apart; the fourth may be about what is excluded.
  [[nodiscard]] std::vector<Rules> contenders(uint32_t round) const {
    std::vector<Rules> result;
    for (const Choices& candidate : alive_) {
      if (result.size() == kMostContenders) return result;
      result.push_back(with(candidate));
    }
    if (alive_.size() > 1 && round % 4 != 3) return result;
    for (const Choice choice : group_.choices) {
      for (const uint32_t answer : answersOf(choice)) {
        if (answer != rasterizer::info(choice).get(alive_.front())) result.push_back(with(changed(choice, answer)));
      }
    }
    return result;
  }

  Result<void> meet(const Observation& observation) {
    std::vector<Choices> left;
    for (const Choices& candidate : alive_) {
      const Result<uint64_t> wrong = contradictions(observation, with(candidate), group_.tolerance);
      if (!wrong) return tl::unexpected(wrong.error());
      if (*wrong == 0) left.push_back(candidate);
    }
    if (left.empty()) {
      contradicted_ = true;
    } else {
      alive_ = std::move(left);
    }
    return {};
  }

  Result<GroupOutcome> weigh() {
    GroupOutcome outcome;
    outcome.choices = alive_.front();
    uint64_t samples = 0;
    for (const Observation& observation : observations_) samples += observation.actual.primitive.data.size();
    for (const Choice choice : group_.choices) {
      Finding finding;
      finding.choice = choice;
      finding.answer = rasterizer::info(choice).get(alive_.front());
      finding.scenes = static_cast<uint32_t>(observations_.size());
      finding.samples = samples;
      if (!observations_.empty()) finding.status = contradicted_ ? Finding::Status::NoneFits : Finding::Status::Found;
      if (finding.status == Finding::Status::Found) {
        if (const Result<void> weighed = weighRivals(finding); !weighed) return tl::unexpected(weighed.error());
      }
      outcome.findings.push_back(std::move(finding));
    }
    outcome.observations = std::move(observations_);
    return outcome;
  }

  Result<void> weighRivals(Finding& finding) const {
    for (const uint32_t answer : answersOf(finding.choice)) {
      if (answer == finding.answer) continue;
      Rival rival{answer, 0};
      for (const Observation& observation : observations_) {
        const Result<uint64_t> wrong = contradictions(observation, with(changed(finding.choice, answer)), group_.tolerance);
        if (!wrong) return tl::unexpected(wrong.error());
        rival.contradictions += *wrong;
      }
      finding.rivals.push_back(rival);
    }
    return {};
  }

  Subject& subject_;
  const Rules& known_;
  const Group& group_;
  Prng random_;
  std::vector<Choices> alive_;
  std::vector<Observation> observations_;
  bool contradicted_ = false;
};

}  // namespace

namespace {

// At every sample count above one that is offered.
bool firstSampleIsTheCentre(const rasterizer::SampleTables& tables, const Limits& limits) {
  constexpr rasterizer::SampleTables::Offset kCentre{128, 128};
  for (const uint32_t samples : {2U, 4U, 8U, 16U}) {
    if ((limits.framebufferSampleCounts & samples) != 0 && tables.of(samples)[0] != kCentre) return false;
  }
  return true;
}

}  // namespace

Choices canonical(Choices choices, const Limits& limits) {
  using rasterizer::SnapRounding;
  const SnapRounding rounding = choices.snapRounding;
  const bool aroundZero = rounding == SnapRounding::TowardZero || rounding == SnapRounding::NearestAway ||
                          rounding == SnapRounding::NearestTowardZero;
  // Half a pixel is an even number of steps: exact arithmetic and a rounding that knows no zero do not see it.
  const bool exact = choices.viewportArithmetic == rasterizer::ViewportArithmetic::Exact;
  if (exact && !aroundZero) choices.snapOrigin = rasterizer::SnapOrigin::Corner;
  // Subtracted exactly, it does not matter when.
  if (exact && choices.snapOrigin == rasterizer::SnapOrigin::CentreInViewport) choices.snapOrigin = rasterizer::SnapOrigin::Centre;
  // To within a step of any legal bias.
  using rasterizer::DepthBiasUnit;
  if (choices.depthBiasUnit == DepthBiasUnit::OneStepOfRange) choices.depthBiasUnit = DepthBiasUnit::OneStep;
  // Without lines and points that are cut in clip space, an outline is the same whether the polygon is cut or each of its edges.
  const bool ownLines = choices.lineArithmetic == rasterizer::LineArithmetic::ClipCorners;
  const bool ownPoints = choices.pointClip != rasterizer::PointClip::Volume && choices.pointArithmetic == rasterizer::PointArithmetic::ClipCorners;
  using rasterizer::CutOutline;
  if (choices.cutOutline == CutOutline::Uncut && !ownLines && !ownPoints) choices.cutOutline = CutOutline::Original;
  // A fragment that is covered by all samples is covered by the first one, which is the centre.
  using rasterizer::CentroidPosition;
  const bool centred = choices.sampleLocations && firstSampleIsTheCentre(*choices.sampleLocations, limits);
  if (choices.centroid == CentroidPosition::First && centred) choices.centroid = CentroidPosition::CentreOrFirst;
  if (choices.lineArithmetic != rasterizer::LineArithmetic::Exact) choices.diamondExit = rasterizer::DiamondExit::Vulkan;
  return choices;
}

Result<GroupOutcome> eliminate(Subject& subject, const Rules& known, const Group& group, uint64_t seed,
                               const std::function<void()>& finishedScene) {
  return Run(subject, known, group, seed).play(finishedScene);
}

}  // namespace rasterdiff::harness
