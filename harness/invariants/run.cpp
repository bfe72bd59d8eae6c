#include "harness/invariants/run.hpp"

namespace rasterdiff::harness::invariants {
namespace {

/// The frames of a case; none where the driver does not offer what a scene needs.
Result<std::vector<Frame>> draw(const Case& made, Subject& subject) {
  std::vector<Frame> frames;
  for (const Scene& scene : made.scenes) {
    if (Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
    Result<Frame> frame = subject.render(scene);
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
  for (uint64_t i = 0; i < count; ++i) {
    Prng random(seed * 0x9e3779b97f4a7c15U + i);
    Case made = invariant.make(random, subject.limits());
    for (Scene& scene : made.scenes) scene.name = std::string(invariant.name);
    const Result<std::vector<Frame>> frames = draw(made, subject);
    if (!frames) {
      const ErrorCode code = frames.error().code;
      if (code == ErrorCode::DeviceLost || code == ErrorCode::TimedOut) return tl::unexpected(frames.error());
      ++outcome.skipped;
      continue;
    }
    const Agreement agreement = made.agree(*frames);
    ++outcome.cases;
    outcome.samples += agreement.samples;
    if (!agreement.broken) continue;
    if (outcome.brokenCases++ > 0) continue;
    outcome.broken = agreement.broken;
    outcome.scenes = std::move(made.scenes);
  }
  return outcome;
}

}  // namespace rasterdiff::harness::invariants
