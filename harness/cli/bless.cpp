// `bless`: what differs in the results of a check becomes a baseline, with the reason that the user gives.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "harness/cli/message.hpp"
#include "harness/cli/run.hpp"
#include "harness/compare/blessing.hpp"
#include "harness/report/output.hpp"

namespace rasterdiff::harness::cli {

int runVerb(const BlessOptions& options) {
  constexpr const char* kHelp = "rasterdiff bless --help";
  std::ifstream file(options.results, std::ios::binary);
  if (!file) {
    return complain({ErrorCode::Io, options.results, "the results cannot be read", "rasterdiff check --json FILE writes them"}, kHelp);
  }
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  Baseline old;
  if (std::filesystem::exists(options.baseline)) {
    Result<Baseline> loaded = loadBaseline(options.baseline);
    if (!loaded) return complain(loaded.error(), kHelp);
    old = std::move(*loaded);
  }
  const Result<Blessing> blessing = bless(text, options.results, old, {options.scenes, options.reason, options.rule, options.anchor});
  if (!blessing) return complain(blessing.error(), kHelp);
  if (const Result<void> written = writeFile(options.baseline, writeBaseline(blessing->baseline)); !written) {
    return complain(written.error(), kHelp);
  }
  for (const std::string& scene : blessing->gone) fmt::print("gone    {}\n", scene);
  for (const std::string& scene : blessing->added) fmt::print("known   {}\n", scene);
  fmt::print("{}: {} added, {} gone, {} in all\nrasterdiff check --baseline {}\n", options.baseline, blessing->added.size(),
             blessing->gone.size(), blessing->baseline.entries.size(), options.baseline);
  return 0;
}

}  // namespace rasterdiff::harness::cli
