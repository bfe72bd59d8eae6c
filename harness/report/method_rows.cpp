#include "harness/report/method_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/report/json_parts.hpp"
#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::MethodRow;

std::string_view kindOf(const MethodRow& row) { return row.hard ? "hard" : "friendly"; }

/// Columns of a terminal that UTF-8 text takes; the table's only wide characters are one column each.
size_t columnsOf(std::string_view text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(std::string_view text, size_t width) {
  return std::string(text) + std::string(width - std::min(width, columnsOf(text)), ' ');
}

std::string csvField(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string methodsText(std::span<const MethodRow> rows) {
  std::string text;
  const auto out = std::back_inserter(text);
  size_t method = 0, inputs = 0;
  for (const MethodRow& row : rows) {
    method = std::max(method, columnsOf(row.method));
    inputs = std::max(inputs, columnsOf(row.inputs));
  }
  for (const rasterizer::MethodFamily& family : rasterizer::methodFamilies()) {
    if (std::ranges::find(rows, family.name, &MethodRow::family) == rows.end()) continue;
    fmt::format_to(out, "{}{}: a case is {}; wrong: {}; error: {}\n", text.empty() ? "" : "\n", family.name, family.caseIs,
                   family.wrongIs, family.errorIs);
    fmt::format_to(out, "  {}  {:<8}  {} {:>8} {:>9} {:>10} {:>10} {:>10}\n", padded("method", method), "", padded("inputs", inputs),
                   "cases", "wrong", "max error", "mean", "RMS");
    for (const MethodRow& row : rows) {
      if (row.family != family.name) continue;
      fmt::format_to(out, "  {}  {:<8}  {} {:>8} {:>9} {:>10.3g} {:>10.3g} {:>10.3g}\n", padded(row.method, method), kindOf(row),
                     padded(row.inputs, inputs), grouped(row.cases), grouped(row.wrongSamples), row.maxError, row.meanError,
                     row.rmsError);
    }
  }
  return text;
}

std::string methodsJson(std::span<const MethodRow> rows, const rasterizer::MethodTableOptions& options) {
  Json json{{"seed", options.seed}, {"cases", options.cases}, {"families", Json::array()}, {"rows", Json::array()}};
  for (const rasterizer::MethodFamily& family : rasterizer::methodFamilies()) {
    json["families"].push_back({{"name", family.name}, {"case", family.caseIs}, {"wrong", family.wrongIs}, {"error", family.errorIs}});
  }
  for (const MethodRow& row : rows) {
    json["rows"].push_back({{"family", row.family}, {"method", row.method}, {"inputs", row.inputs}, {"hard", row.hard},
                            {"cases", row.cases}, {"wrong", row.wrongSamples}, {"maxError", jsonNumber(row.maxError)},
                            {"meanError", jsonNumber(row.meanError)}, {"rmsError", jsonNumber(row.rmsError)}});
  }
  return textOf(json) + "\n";
}

std::string methodsCsv(std::span<const MethodRow> rows) {
  std::string text = "family,method,kind,inputs,cases,wrong,maxError,meanError,rmsError\n";
  for (const MethodRow& row : rows) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", row.family, row.method, kindOf(row),
                   csvField(row.inputs), row.cases, row.wrongSamples, row.maxError, row.meanError, row.rmsError);
  }
  return text;
}

}  // namespace rasterdiff::harness
