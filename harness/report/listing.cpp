#include "harness/report/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/freedoms.hpp"

namespace rasterdiff::harness {
namespace {

/// Two columns; the first as wide as its widest entry.
std::string columns(const std::vector<std::pair<std::string, std::string>>& rows) {
  size_t width = 0;
  for (const auto& [left, right] : rows) width = std::max(width, left.size());
  std::string text;
  for (const auto& [left, right] : rows) fmt::format_to(std::back_inserter(text), "{:<{}}  {}\n", left, width, right);
  return text;
}

}  // namespace

std::string scenesText(std::span<const CatalogueEntry* const> entries) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const CatalogueEntry* entry : entries) rows.emplace_back(entry->name, entry->what);
  return columns(rows);
}

std::string mutantsText() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const rasterizer::DeliberateErrorInfo& error : rasterizer::deliberateErrors()) {
    rows.emplace_back(fmt::format("mutant:{}", error.name), fmt::format("{:<4} {}", error.rule, error.what));
  }
  return columns(rows);
}

std::string freedomsText() {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const rasterizer::FreedomInfo& freedom : rasterizer::freedoms()) {
    if (freedom.freedom == rasterizer::Freedom::None) continue;
    rows.emplace_back(freedom.id, fmt::format("{} [{}]", freedom.what, freedom.anchor));
  }
  return columns(rows);
}

}  // namespace rasterdiff::harness
