#include "harness/hunt/lane.hpp"

#include <algorithm>

#include "harness/hunt/ingredients.hpp"

namespace rasterdiff::harness::hunt {
namespace {

constexpr size_t kMostVertices = 400;  // of a scene that is kept, all draws together

size_t verticesIn(const Scene& scene) {
  size_t vertices = 0;
  for (const Draw& draw : scene.draws) vertices += draw.positions.size();
  return vertices;
}

class Lane {
 public:
  Lane(const Corpus& corpus, const LaneOptions& options, const Judge& judge)
      : corpus_(corpus), options_(options), judge_(judge), random_(options.seed * 0x9e3779b97f4a7c15U + options.lane) {}

  LaneResult run() {
    while (result_.tally.scenes < options_.scenes && result_.tally.lost == 0) {
      Scene scene = next();
      // The same state with other vertices costs no new pipeline.
      constexpr uint32_t kSiblings = 2;
      for (uint32_t sibling = 0; sibling <= kSiblings && result_.tally.scenes < options_.scenes; ++sibling) {
        if (sibling > 0) moveSome(scene);
        if (validate(scene)) examine(scene);
        if (result_.tally.lost > 0) break;
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool showsWhatIsKnown(const Scene& scene) const {
    const Traits traits = traitsOf(scene);
    return std::any_of(options_.avoid.begin(), options_.avoid.end(),
                       [&](const Signature& known) { return includes(traits, known.traits); });
  }

  /// Valid, and if it can be helped nothing that is known already.
  Scene next() {
    constexpr int kTries = 24;
    Scene scene;
    for (int i = 0; i < kTries; ++i) {
      scene = make();
      if (validate(scene) && (!showsWhatIsKnown(scene) || random_.chance(3))) break;
    }
    return scene;
  }

  Scene make() {
    const Kept* base = corpus_.pick(random_);
    if (base == nullptr || random_.chance(35)) return randomScene(*options_.family, options_.limits, random_);
    if (random_.chance(25)) return crossed(base->scene, corpus_.pick(random_)->scene, random_);
    return mutated(base->scene, *options_.family, options_.limits, random_);
  }

  void moveSome(Scene& scene) {
    if (scene.draws.empty()) return;
    const uint32_t moves = 1 + random_.below(4);
    for (uint32_t i = 0; i < moves; ++i) moveVertex(scene, random_);
  }

  void examine(const Scene& scene) {
    const Judgement judgement = judge_(scene);
    Tally& tally = result_.tally;
    ++tally.scenes;
    tally.samples += judgement.samples;
    tally.values += judgement.values;
    tally.decided += judgement.counts;
    switch (judgement.verdict) {
      case Verdict::Same: ++tally.same; break;
      case Verdict::Allowed: ++tally.allowed; break;
      case Verdict::Differs: ++tally.differing; break;
      case Verdict::Skipped: ++tally.skipped; return;
      case Verdict::Crashed:
      case Verdict::TimedOut: ++tally.lost; break;
    }
    const Traits traits = traitsOf(scene);
    for (const Difference& difference : judgement.differences) note({scene, {difference.kind, traits}, judgement.verdict});
    if (verticesIn(scene) > kMostVertices) return;
    Kept candidate{scene, pairsOf(traits, judgement.counts)};
    if (corpus_.offer(candidate)) result_.kept.push_back(std::move(candidate));
  }

  void note(Raw raw) {
    const bool known = std::any_of(result_.raw.begin(), result_.raw.end(), [&](const Raw& r) { return r.signature == raw.signature; });
    if (!known) result_.raw.push_back(std::move(raw));
  }

  Corpus corpus_;
  const LaneOptions& options_;
  const Judge& judge_;
  Prng random_;
  LaneResult result_;
};

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  scenes += other.scenes;
  skipped += other.skipped;
  same += other.same;
  allowed += other.allowed;
  differing += other.differing;
  lost += other.lost;
  samples += other.samples;
  values += other.values;
  decided += other.decided;
  return *this;
}

LaneResult searchLane(const Corpus& corpus, const LaneOptions& options, const Judge& judge) {
  return Lane(corpus, options, judge).run();
}

}  // namespace rasterdiff::harness::hunt
