// The random families of the catalogue, drawn again with other seeds: `random/half-1x-w1@SEED` is one batch.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "harness/cli/selection.hpp"

namespace rasterdiff::harness::cli {

/// random/{half,sixteenth,256th,free}-{1x,4x}-{w1,persp}
[[nodiscard]] bool isRandomFamily(std::string_view name);

/// kBatchTriangles triangles of the family of `job`, counted in its entry.
[[nodiscard]] Job batchOf(const Job& job, uint64_t seed);

/// "random/half-1x-w1@7000003". Error: BadInput.
[[nodiscard]] Result<Job> batchByAddress(const std::string& address);

}  // namespace rasterdiff::harness::cli
