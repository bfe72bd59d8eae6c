#include "harness/hunt/shrink.hpp"

#include <utility>

#include "harness/hunt/ingredients.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff::harness::hunt {
namespace {

size_t hashOf(const Scene& scene) { return std::hash<std::string>()(writeScene(scene)); }

}  // namespace

Shrinking::Shrinking(Scene scene, std::string kind, const Judge& judge, uint32_t attempts)
    : scene_(std::move(scene)), kind_(std::move(kind)), judge_(judge), attempts_(attempts) {
  shows_ = look(scene_);
  looked_.insert(hashOf(scene_));
}

bool Shrinking::look(const Scene& scene) {
  ++used_;
  Judgement judgement = judge_(scene);
  const Difference* found = find(judgement, kind_);
  if (found == nullptr) {
    if (!shows_) judgement_ = std::move(judgement);
    return false;
  }
  at_ = *found;
  judgement_ = std::move(judgement);
  return true;
}

bool Shrinking::take(Scene candidate) {
  Prng unused(0);  // nothing is filled up: candidates only lose
  repair(candidate, unused);
  if (exhausted() || candidate == scene_ || !validate(candidate)) return false;
  if (!looked_.insert(hashOf(candidate)).second || !look(candidate)) return false;
  scene_ = std::move(candidate);
  return true;
}

Shrunk Shrinking::result() && { return {std::move(scene_), std::move(kind_), std::move(judgement_), used_}; }

Shrunk shrink(const Scene& scene, const std::string& kind, const Judge& judge, const ShrinkOptions& options) {
  Shrinking shrinking(scene, kind, judge, options.attempts);
  bool progress = shrinking.shows();
  while (progress && !shrinking.exhausted()) {
    progress = false;
    for (const auto pass : {dropPrimitives, dropInputs, dropState, cropTarget, simplifyCoordinates}) {
      if (pass(shrinking)) progress = true;
    }
  }
  return std::move(shrinking).result();
}

}  // namespace rasterdiff::harness::hunt
