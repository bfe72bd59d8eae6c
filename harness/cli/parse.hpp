// Words to options. Help and usage errors come back as text, so that nothing is printed or exited here.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "harness/cli/options.hpp"

namespace rasterdiff::harness::cli {

/// There is nothing to run: `--help`, `--version`, or a usage error.
struct NothingToRun {
  int exitStatus = 0;  ///< 0: `text` answers what was asked; 2: `text` says what is wrong
  std::string text;
  std::string next;  ///< the command to type next, for errors
};

[[nodiscard]] tl::expected<Verb, NothingToRun> parse(int argc, const char* const* argv);

}  // namespace rasterdiff::harness::cli
