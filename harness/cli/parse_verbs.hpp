// The verbs' options and help, one function each: parse.cpp puts them together.
#pragma once

#include <string>

#include "harness/cli/options.hpp"

namespace CLI {
class App;
}

namespace rasterdiff::harness::cli {

/// --driver, --rules, --timeout; `alsoDrivers` is what this verb takes beyond the usual drivers.
void addDriverOptions(CLI::App& verb, DriverChoice& choice, const std::string& alsoDrivers);

void addBench(CLI::App& app, BenchOptions& options);
void addStability(CLI::App& app, StabilityOptions& options);
void addMethods(CLI::App& app, MethodsOptions& options);
void addHunt(CLI::App& app, HuntOptions& options);
void addInvariants(CLI::App& app, InvariantsOptions& options);
void addInfer(CLI::App& app, InferOptions& options);
void addBless(CLI::App& app, BlessOptions& options);
void addExport(CLI::App& app, ExportOptions& options);

}  // namespace rasterdiff::harness::cli
