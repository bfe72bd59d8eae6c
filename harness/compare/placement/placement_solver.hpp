// One place for every vertex such that each primitive's table holds its triple: generalised arc consistency
// (Mackworth 1977), then depth-first search with the nominal place tried first.
#pragma once

#include <span>
#include <vector>

#include "harness/compare/placement/placement_table.hpp"

namespace rasterdiff::harness {

/// A primitive that constrains its vertices.
struct TableConstraint {
  std::array<uint32_t, 3> vertices{};
  const PlacementTable* table = nullptr;
};

enum class SolverOutcome : uint8_t { Solved, Unsolvable, GivenUp };

struct Solution {
  SolverOutcome outcome = SolverOutcome::Solved;
  std::vector<uint8_t> places;  ///< one a vertex (Solved)
};

/// `placeCounts[v]` places of vertex v (1..64). Proves Unsolvable, or gives up after a fixed number of revisions.
[[nodiscard]] Solution solvePlacement(std::span<const size_t> placeCounts, std::span<const TableConstraint> constraints);

/// A smallest set of constraints (indices) that has no solution, from an unsolvable set: each is dropped that is not
/// needed. Vertices of other constraints stay free.
[[nodiscard]] std::vector<size_t> conflictOf(std::span<const size_t> placeCounts,
                                             std::span<const TableConstraint> constraints);

}  // namespace rasterdiff::harness
