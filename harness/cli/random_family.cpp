#include "harness/cli/random_family.hpp"

#include <fmt/format.h>

#include <charconv>

namespace rasterdiff::harness::cli {

const CatalogueEntry* randomFamily(std::string_view name) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name == name) return entry.remake ? &entry : nullptr;
  }
  return nullptr;
}

Job batchOf(const CatalogueEntry& family, uint64_t seed) {
  return {family.name, fmt::format("{}@{}", family.name, seed), family.what, family.link, family.rules,
          [&family, seed] { return family.remake(seed, kBatchPrimitives); }};
}

Result<Job> batchByAddress(const std::string& address) {
  const size_t at = address.find('@');
  const CatalogueEntry* family = randomFamily(std::string_view(address).substr(0, at));
  const std::string_view digits = std::string_view(address).substr(at + 1);
  uint64_t seed = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (family == nullptr || error != std::errc{} || end != digits.data() + digits.size()) {
    return fail(ErrorCode::BadInput, "SCENE", fmt::format("'{}' is no batch of random primitives", address),
                "rasterdiff list 'random*/*'");
  }
  return batchOf(*family, seed);
}

}  // namespace rasterdiff::harness::cli
