// `list`: the catalogue, and what can be named on the command line.
#include <fmt/format.h>

#include "harness/cli/message.hpp"
#include "harness/cli/run.hpp"
#include "harness/report/listing.hpp"

namespace rasterdiff::harness::cli {

int runVerb(const ListOptions& options) {
  const bool ofScenes = options.what == ListOptions::What::Scenes || options.what == ListOptions::What::Rules;
  const std::vector<const CatalogueEntry*> entries = matchCatalogue(options.glob);
  if (ofScenes && entries.empty()) {
    return complain({ErrorCode::BadInput, "GLOB", fmt::format("no scene is named '{}'", options.glob), {}},
                    "rasterdiff list");
  }
  std::string text;
  switch (options.what) {
    case ListOptions::What::Scenes: text = options.json ? scenesJson(entries) : scenesText(entries); break;
    case ListOptions::What::Rules: text = options.json ? rulesJson(entries) : rulesText(entries); break;
    case ListOptions::What::Mutants: text = options.json ? mutantsJson() : mutantsText(); break;
    case ListOptions::What::Freedoms: text = options.json ? freedomsJson() : freedomsText(); break;
  }
  fmt::print("{}", text);
  return 0;
}

}  // namespace rasterdiff::harness::cli
