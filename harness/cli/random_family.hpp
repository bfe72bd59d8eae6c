// The random families of the catalogue, drawn again with other seeds: `random/half-1x-w1@SEED` is one batch.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "harness/cli/selection.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::harness::cli {

/// The catalogue's entry if `name` is a random family, else null.
[[nodiscard]] const CatalogueEntry* randomFamily(std::string_view name);

/// kBatchPrimitives primitives of a random family, counted in its entry.
[[nodiscard]] Job batchOf(const CatalogueEntry& family, uint64_t seed);

/// "random/half-1x-w1@7000003". Error: BadInput.
[[nodiscard]] Result<Job> batchByAddress(const std::string& address);

}  // namespace rasterdiff::harness::cli
