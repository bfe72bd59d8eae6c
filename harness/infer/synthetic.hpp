// Random closed rules: what `--driver synthetic:SEED` draws by, to see whether inference finds rules that nobody told it.
#pragma once

#include "rasterizer/rules.hpp"

namespace rasterdiff::harness {

/// Every choice is drawn, sample locations too; the grid has 4 to 8 bits, and a number of them of its own is advertised.
/// Of several combinations that always draw the same, the first one.
[[nodiscard]] rasterizer::Rules syntheticRules(uint64_t seed);

}  // namespace rasterdiff::harness
