// Several drivers in one word of the command line: a range of numbered renderers, a glob over the deliberate errors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff::harness::cli {

/// "legal:1..100", "synthetic:1..400", "mutant:depth-*".
[[nodiscard]] bool namesSeveral(std::string_view driver);

/// One name a driver: "legal:1", "legal:2", …; {driver} itself where it names one.
/// Error: BadInput, a range that is empty, goes backward or is longer than 10,000; a glob that no deliberate error matches.
[[nodiscard]] Result<std::vector<std::string>> driversNamed(const std::string& driver);

}  // namespace rasterdiff::harness::cli
