// Invariants as a part of `check`: each is one more entry, "invariant/NAME", beside the scenes.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "harness/cli/scene_check.hpp"

namespace rasterdiff::harness::cli {

/// What a run of `check` is to do: its scenes, then its invariants. Without words everything; a word that begins with
/// "invariant/" is a glob over the invariants.
/// Error: as selectScenes; BadInput for a word that names no invariant.
[[nodiscard]] Result<std::vector<Job>> selectScenesAndInvariants(std::span<const std::string> words, const std::optional<RandomCount>& count);

/// A few cases of the job's invariant, always the same ones. A broken one Differs; where no case is offered it is Skipped.
[[nodiscard]] CheckedScene checkInvariant(const Job& job, Subject& subject, const std::function<void(std::string_view)>& entering);

}  // namespace rasterdiff::harness::cli
