// What a failure looks like: `where: what`, a hint, and as the last line the next command to type.
#pragma once

#include <string>
#include <string_view>

#include "scene/result.hpp"

namespace rasterdiff::harness::cli {

[[nodiscard]] int exitStatusOf(ErrorCode code);  ///< 2, 3 or 4

/// The command that goes on from an error: `rasterdiff devices`, `rasterdiff VERB --help`.
[[nodiscard]] std::string nextCommand(const Error& error, std::string_view verb);

/// Prints the error to stderr and returns its exit status.
int complain(const Error& error, std::string_view next);

}  // namespace rasterdiff::harness::cli
