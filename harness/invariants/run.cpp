#include "harness/invariants/run.hpp"

#include <algorithm>
#include <iterator>

namespace rasterdiff::harness::invariants {
namespace {

constexpr uint64_t kTogether = 16;  ///< cases whose scenes are drawn together

/// Some cases with all their scenes, which are no longer in the cases.
struct Batch {
  struct Part {
    Case made;
    size_t first = 0, size = 0;  ///< scenes
  };
  std::vector<Part> parts;
  std::vector<Scene> scenes;

  void add(Case made, std::string_view name) {
    const size_t first = scenes.size();
    std::move(made.scenes.begin(), made.scenes.end(), std::back_inserter(scenes));
    for (size_t k = first; k < scenes.size(); ++k) scenes[k].name = std::string(name);
    parts.push_back({std::move(made), first, scenes.size() - first});
  }
};

/// The frames of a case; the error of the first scene that has none.
Result<std::vector<Frame>> framesOf(std::span<Result<Frame>> drawn) {
  std::vector<Frame> frames;
  for (Result<Frame>& frame : drawn) {
    if (!frame) return tl::unexpected(frame.error());
    frames.push_back(std::move(*frame));
  }
  return frames;
}

}  // namespace

std::span<const Invariant> invariants() {
  static const std::vector<Invariant> all = [] {
    std::vector<Invariant> list;
    for (const auto part : {ownershipInvariants(), equivalenceInvariants(), independenceInvariants()}) list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

Result<Outcome> run(const Invariant& invariant, Subject& subject, uint64_t seed, uint64_t count) {
  Outcome outcome;
  outcome.name = invariant.name;
  for (uint64_t first = 0; first < count; first += kTogether) {
    Batch batch;
    for (uint64_t i = first; i < std::min(count, first + kTogether); ++i) {
      Prng random(seed * 0x9e3779b97f4a7c15U + i);
      batch.add(invariant.make(random, subject.limits()), invariant.name);
    }
    std::vector<Result<Frame>> drawn = subject.renderTogether(batch.scenes);
    for (const Batch::Part& part : batch.parts) {
      const Result<std::vector<Frame>> frames = framesOf(std::span(drawn).subspan(part.first, part.size));
      if (!frames) {
        const ErrorCode code = frames.error().code;
        if (code == ErrorCode::DeviceLost || code == ErrorCode::TimedOut) return tl::unexpected(frames.error());
        ++outcome.skipped;
        continue;
      }
      const Agreement agreement = part.made.agree(*frames);
      ++outcome.cases;
      outcome.samples += agreement.samples;
      if (!agreement.broken) continue;
      if (outcome.brokenCases++ > 0) continue;
      outcome.broken = agreement.broken;
      outcome.scenes.assign(batch.scenes.begin() + static_cast<std::ptrdiff_t>(part.first),
                            batch.scenes.begin() + static_cast<std::ptrdiff_t>(part.first + part.size));
    }
  }
  return outcome;
}

}  // namespace rasterdiff::harness::invariants
