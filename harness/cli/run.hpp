// The command line: parses, runs one verb, returns the exit status (DESIGN: 0 1 2 3 4).
#pragma once

#include "harness/cli/options.hpp"

namespace rasterdiff::harness::cli {

[[nodiscard]] int run(int argc, const char* const* argv);

// The verbs; each prints its own result and returns the exit status.
[[nodiscard]] int runVerb(const CheckOptions& options);
[[nodiscard]] int runVerb(const RenderOptions& options);
[[nodiscard]] int runVerb(const ExplainOptions& options);
[[nodiscard]] int runVerb(const BenchOptions& options);
[[nodiscard]] int runVerb(const StabilityOptions& options);
[[nodiscard]] int runVerb(const DevicesOptions& options);
[[nodiscard]] int runVerb(const ListOptions& options);
[[nodiscard]] int runVerb(const HuntOptions& options);
[[nodiscard]] int runVerb(const BlessOptions& options);
[[nodiscard]] int runVerb(const MethodsOptions& options);
[[nodiscard]] int runVerb(const InvariantsOptions& options);
[[nodiscard]] int runVerb(const InferOptions& options);
[[nodiscard]] int runVerb(const ExportOptions& options);

}  // namespace rasterdiff::harness::cli
