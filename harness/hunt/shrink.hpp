// From a scene that shows a wrong answer to the smallest one that still does: the same verdict at the same kind of
// sample. Greedy passes, each in its own file, until none of them finds anything to leave out.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>

#include "harness/hunt/judge.hpp"

namespace rasterdiff::harness::hunt {

struct ShrinkOptions {
  uint32_t attempts = 1000;  ///< scenes judged at most
};

struct Shrunk {
  Scene scene;
  std::string kind;
  Judgement judgement;    ///< of the scene
  uint32_t attempts = 0;  ///< scenes judged
};

/// `scene` must show `kind` under `judge`; otherwise it is returned as it is, its judgement without that kind.
[[nodiscard]] Shrunk shrink(const Scene& scene, const std::string& kind, const Judge& judge, const ShrinkOptions& options = {});

/// The scene of the passes: replaced by every smaller one that still shows the kind.
class Shrinking {
 public:
  Shrinking(Scene scene, std::string kind, const Judge& judge, uint32_t attempts);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Where the kind shows.
  [[nodiscard]] const Difference& at() const { return at_; }
  [[nodiscard]] bool exhausted() const { return used_ >= attempts_; }
  /// Judges a candidate; takes it and returns true if it still shows the kind. No scene is looked at twice, so that
  /// passes that undo each other come to an end.
  bool take(Scene candidate);
  /// Edits a copy and takes that.
  template <class Edit>
  bool edit(const Edit& change) {
    Scene candidate = scene_;
    change(candidate);
    return take(std::move(candidate));
  }
  [[nodiscard]] bool shows() const { return shows_; }
  [[nodiscard]] Shrunk result() &&;

 private:
  bool look(const Scene& scene);

  Scene scene_;
  std::string kind_;
  const Judge& judge_;
  uint32_t attempts_, used_ = 0;
  bool shows_ = false;
  Difference at_;
  Judgement judgement_;
  std::unordered_set<size_t> looked_;  ///< hashes of candidates
};

// The passes; each returns whether it took anything.
bool dropPrimitives(Shrinking& shrinking);      ///< draws, primitives, indices, strips to lists
bool dropInputs(Shrinking& shrinking);          ///< varyings, built-ins, distances, sizes of single points
bool dropState(Shrinking& shrinking);           ///< every field to its default
bool cropTarget(Shrinking& shrinking);          ///< to a few pixels around the sample, at the origin
bool simplifyCoordinates(Shrinking& shrinking); ///< coarser grids, w to 1, plain values

}  // namespace rasterdiff::harness::hunt
