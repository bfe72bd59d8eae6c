#include "harness/cli/random_family.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "scene/catalogue/catalogue.hpp"
#include "scene/generators/random_triangles.hpp"

namespace rasterdiff::harness::cli {
namespace {

/// Takes `prefix` off the front of `text` if it is there.
bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::optional<RandomTriangles> optionsOf(std::string_view name) {
  RandomTriangles options;
  options.triangles = kBatchTriangles;
  if (!take(name, "random/")) return std::nullopt;
  if (take(name, "half-")) {
    options.grid = Grid::Half;
  } else if (take(name, "sixteenth-")) {
    options.grid = Grid::Sixteenth;
  } else if (take(name, "256th-")) {
    options.grid = Grid::TwoHundredFiftySixth;
  } else if (take(name, "free-")) {
    options.grid = Grid::Free;
  } else {
    return std::nullopt;
  }
  options.samples = name.starts_with("4x-") ? 4 : 1;
  if (!take(name, "1x-") && !take(name, "4x-")) return std::nullopt;
  options.perspective = name == "persp";
  if (name != "persp" && name != "w1") return std::nullopt;
  return options;
}

}  // namespace

bool isRandomFamily(std::string_view name) { return optionsOf(name).has_value(); }

Job batchOf(const Job& job, uint64_t seed) {
  Job batch = job;
  batch.address = fmt::format("{}@{}", job.id, seed);
  RandomTriangles options = *optionsOf(job.id);
  options.seed = seed;
  batch.make = [options]() -> Result<Scene> { return randomTriangles(options); };
  return batch;
}

Result<Job> batchByAddress(const std::string& address) {
  const size_t at = address.find('@');
  const std::string family = address.substr(0, at);
  const std::string_view digits = std::string_view(address).substr(at + 1);
  uint64_t seed = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  const std::vector<const CatalogueEntry*> entries = matchCatalogue(family);
  if (!isRandomFamily(family) || entries.size() != 1 || error != std::errc{} || end != digits.data() + digits.size()) {
    return fail(ErrorCode::BadInput, "SCENE", fmt::format("'{}' is no batch of random triangles", address),
                "rasterdiff list 'random/*'");
  }
  const CatalogueEntry& entry = *entries.front();
  return batchOf({entry.name, entry.name, entry.what, entry.link, entry.rules, entry.make}, seed);
}

}  // namespace rasterdiff::harness::cli
