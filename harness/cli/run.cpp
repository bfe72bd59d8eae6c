#include "harness/cli/run.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "harness/cli/parse.hpp"

namespace rasterdiff::harness::cli {

int run(int argc, const char* const* argv) {
  const tl::expected<Verb, NothingToRun> verb = parse(argc, argv);
  if (verb) return std::visit([](const auto& options) { return runVerb(options); }, *verb);
  const NothingToRun& answer = verb.error();
  if (answer.exitStatus == 0) {
    fmt::print("{}", answer.text);
  } else {
    fmt::print(stderr, "{}\n{}\n", answer.text, answer.next);
  }
  return answer.exitStatus;
}

}  // namespace rasterdiff::harness::cli
