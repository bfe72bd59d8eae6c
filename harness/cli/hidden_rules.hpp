// `infer` with several hidden renderers at once: of how many random rule sets does it find every choice?
#pragma once

#include "harness/cli/options.hpp"

namespace rasterdiff::harness::cli {

/// `options.choice.driver` is a range, as "synthetic:1..400". Prints what was not recovered and one line that sums up.
/// Returns the exit status: 1 if some rule set was not recovered exactly.
[[nodiscard]] int inferSeveral(const InferOptions& options);

}  // namespace rasterdiff::harness::cli
