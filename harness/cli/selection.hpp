// From the words on the command line to scenes: catalogue names and globs, scene files, folders of them, batches of
// random primitives. Files are read (and refused) here, before any work starts; catalogue scenes are made when needed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/invariants/invariant.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::cli {

/// One scene to be drawn.
struct Job {
  std::string id;       ///< of the entry that it is counted in: name, path, or random family
  std::string address;  ///< what names exactly this scene on the command line: "random/half-1x-w1@7000003"
  std::string what, link;
  std::vector<std::string> rules;
  std::function<Result<Scene>()> make;
  const invariants::Invariant* invariant = nullptr;  ///< to be asked instead of drawing one scene
};

struct RandomCount {
  uint64_t primitives = 0;  ///< of each selected kind (random, random-lines, …), shared out over its families in whole batches
  uint64_t seed = 1;
};
inline constexpr uint32_t kBatchPrimitives = 500;

/// The scene as it is drawn: made, checked, and enlarged if it wants supersampling.
[[nodiscard]] Result<Scene> drawable(const Job& job);

/// No words = the whole catalogue. Batches of one family have one id and follow each other.
/// Error: BadInput or Io with `file:line:col`; a word that names nothing; `count` without a random family.
[[nodiscard]] Result<std::vector<Job>> selectScenes(std::span<const std::string> words,
                                                    const std::optional<RandomCount>& count);

/// Exactly one scene, for `render` and `explain`.
[[nodiscard]] Result<Job> selectScene(const std::string& word);

}  // namespace rasterdiff::harness::cli
