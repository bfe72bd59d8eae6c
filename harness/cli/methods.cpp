// `methods`: every algorithm of the lectures against the exact answer, as a table.
#include <fmt/format.h>

#include <algorithm>

#include "harness/cli/message.hpp"
#include "harness/cli/run.hpp"
#include "harness/report/method_rows.hpp"
#include "harness/report/output.hpp"

namespace rasterdiff::harness::cli {
namespace {

std::string familyNames() {
  std::string names;
  for (const rasterizer::MethodFamily& family : rasterizer::methodFamilies()) {
    names += (names.empty() ? "" : ", ") + std::string(family.name);
  }
  return names;
}

}  // namespace

int runVerb(const MethodsOptions& options) {
  const auto families = rasterizer::methodFamilies();
  const bool all = options.family.empty();
  if (!all && std::ranges::find(families, options.family, &rasterizer::MethodFamily::name) == families.end()) {
    return complain({ErrorCode::BadInput, "FAMILY", fmt::format("there is no family '{}'", options.family),
                     "families: " + familyNames()},
                    "rasterdiff methods --help");
  }
  for (const std::string* path : {&options.json, &options.csv}) {
    if (path->empty()) continue;
    if (const Result<void> writable = checkWritable(*path); !writable) {
      return complain(writable.error(), "rasterdiff methods --help");
    }
  }
  const rasterizer::MethodTableOptions table{options.seed, options.cases};
  std::vector<rasterizer::MethodRow> rows = rasterizer::methodTable(table);
  if (!all) std::erase_if(rows, [&](const rasterizer::MethodRow& row) { return row.family != options.family; });
  fmt::print("{}", options.markdown ? rasterizer::methodTableMarkdown(rows) : methodsText(rows));
  for (const auto& [path, text] : {std::pair{options.json, methodsJson(rows, table)}, {options.csv, methodsCsv(rows)}}) {
    if (path.empty()) continue;
    if (const Result<void> written = writeFile(path, text); !written) {
      return complain(written.error(), "rasterdiff methods --help");
    }
  }
  return 0;
}

}  // namespace rasterdiff::harness::cli
