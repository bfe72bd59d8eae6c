// All legal placements of one primitive's three vertices on one grid that explain its own samples, by enumeration.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "harness/compare/placement/placement_problem.hpp"

namespace rasterdiff::harness {

struct FinePosition {
  int64_t x = 0, y = 0;  ///< 1/4096 pixel  // Q.12, |v| < 2^33
  friend bool operator==(const FinePosition&, const FinePosition&) = default;
};

/// At most this many places a vertex: a domain is one 64-bit word.
inline constexpr size_t kMostPlaces = 64;

/// Where a vertex may go on the grid of 2^-bits pixel, the nominal place (or the nearest to it) first; none if there are
/// more than kMostPlaces.
[[nodiscard]] std::optional<std::vector<FinePosition>> legalPlaces(const PlacedVertex& vertex, int advertisedBits, int bits);

using PlaceTriple = std::array<uint8_t, 3>;

struct PlacementTable {
  std::vector<PlaceTriple> allowed;  ///< indices into the three vertices' places
  bool constrains = false;           ///< some triple is missing
};

/// Differences of two positions are below 2^34, products below 2^68: edge functions are evaluated in 128 bits.
[[nodiscard]] PlacementTable placementTable(const PlacementProblem& problem, const PlacedPrimitive& primitive,
                                            const std::array<const std::vector<FinePosition>*, 3>& places);

}  // namespace rasterdiff::harness
