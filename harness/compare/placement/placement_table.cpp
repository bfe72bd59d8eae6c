#include "harness/compare/placement/placement_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rasterdiff::harness {
namespace {

__extension__ using Wide = __int128;

constexpr int64_t kFine = int64_t{1} << (kFinestGridBits - kSubpixelBits);  // 1/4096 steps in 1/256 pixel

struct AxisRange {
  int64_t lowest = 0, highest = 0, step = 1;
  [[nodiscard]] size_t size() const { return static_cast<size_t>((highest - lowest) / step + 1); }
};

// On the advertised grid the box is exact already; a finer grid has its own neighbours of the position inside the box.
AxisRange axisRange(double position, double deviation, int32_t lowest, int32_t highest, int advertisedBits, int bits) {
  const int64_t low = lowest * kFine, high = highest * kFine;
  const int64_t step = int64_t{1} << (kFinestGridBits - bits);
  if (bits == advertisedBits || low == high) return {low, high, step};
  const auto grid = [&](double pixels) { return std::ldexp(pixels, bits); };
  const auto below = static_cast<int64_t>(std::floor(grid(position - deviation))) * step;
  const auto above = static_cast<int64_t>(std::ceil(grid(position + deviation))) * step;
  return {std::clamp(below, low, high), std::clamp(above, low, high), step};
}

// (b - a) × (p - a)
Wide edgeAt(const FinePosition& a, const FinePosition& b, int64_t px, int64_t py) {
  return Wide{b.x - a.x} * (py - a.y) - Wide{b.y - a.y} * (px - a.x);
}

bool culled(const PlacementProblem& problem, bool clockwise) {
  const bool front = (problem.frontFace == FrontFace::CLOCKWISE) == clockwise;
  return (static_cast<uint32_t>(problem.cullMode) & static_cast<uint32_t>(front ? CullMode::FRONT : CullMode::BACK)) != 0;
}

bool satisfies(const Requirement& requirement, const std::array<FinePosition, 3>& v, bool drawn, bool clockwise) {
  if (!drawn) return !requirement.covered;
  const int64_t px = requirement.px * kFine, py = requirement.py * kFine;
  unsigned ties = 0;
  for (unsigned e = 0; e < 3; ++e) {
    const Wide value = edgeAt(v[e], v[(e + 1) % 3], px, py);
    if (value == 0) {
      ties |= 1U << e;
    } else if ((value > 0) != clockwise) {
      return !requirement.covered;
    }
  }
  // On a corner more than two polygons meet: of two that share an edge both may be left.
  if (std::has_single_bit(ties) && (requirement.strictEdges & ties) != 0) return false;
  return requirement.covered || ties != 0;
}

}  // namespace

std::optional<std::vector<FinePosition>> legalPlaces(const PlacedVertex& vertex, int advertisedBits, int bits) {
  const AxisRange x = axisRange(vertex.position.x, vertex.deviationX, vertex.lowest.x, vertex.highest.x, advertisedBits, bits);
  const AxisRange y = axisRange(vertex.position.y, vertex.deviationY, vertex.lowest.y, vertex.highest.y, advertisedBits, bits);
  if (x.size() > kMostPlaces || y.size() > kMostPlaces || x.size() * y.size() > kMostPlaces) return std::nullopt;
  std::vector<FinePosition> places;
  for (int64_t py = y.lowest; py <= y.highest; py += y.step) {
    for (int64_t px = x.lowest; px <= x.highest; px += x.step) places.push_back({px, py});
  }
  const FinePosition nominal{vertex.nominal.x * kFine, vertex.nominal.y * kFine};
  const auto distance = [&](const FinePosition& p) { return std::abs(p.x - nominal.x) + std::abs(p.y - nominal.y); };
  std::ranges::stable_sort(places, {}, distance);
  return places;
}

PlacementTable placementTable(const PlacementProblem& problem, const PlacedPrimitive& primitive,
                              const std::array<const std::vector<FinePosition>*, 3>& places) {
  PlacementTable table;
  const size_t all = places[0]->size() * places[1]->size() * places[2]->size();
  for (size_t i = 0; i < all; ++i) {
    const size_t a = i % places[0]->size(), rest = i / places[0]->size();
    const size_t b = rest % places[1]->size(), c = rest / places[1]->size();
    const std::array<FinePosition, 3> v{(*places[0])[a], (*places[1])[b], (*places[2])[c]};
    const Wide area = edgeAt(v[0], v[1], v[2].x, v[2].y);
    const bool drawn = area != 0 && !culled(problem, area > 0);
    const bool fits = std::ranges::all_of(primitive.requirements, [&](const Requirement& requirement) {
      return satisfies(requirement, v, drawn, area > 0);
    });
    if (fits) table.allowed.push_back({static_cast<uint8_t>(a), static_cast<uint8_t>(b), static_cast<uint8_t>(c)});
  }
  table.constrains = table.allowed.size() != all;
  return table;
}

}  // namespace rasterdiff::harness
