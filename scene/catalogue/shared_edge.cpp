// Two triangles with a common edge: each sample on it belongs to exactly one. [vk:primsrast-polygons-basic]
#include "scene/catalogue/build.hpp"
#include "scene/generators/shared_edges.hpp"

namespace rasterdiff::families {
namespace {

constexpr const char* kSeams = "https://github.com/ssloy/tinyrenderer/issues/32";
constexpr const char* kGrazingSeams = "https://github.com/jdolan/quetoo/issues/517";

Scene diagonal(uint32_t samples) {
  Scene scene = square(32, samples);
  const double s = samples == 4 ? 0.375 : 0.5, t = samples == 4 ? 0.125 : 0.5;
  draw(scene, rectangle(4 + s, 4 + t, 28 + s, 28 + t));
  return scene;
}

Scene pair(const std::vector<Px>& first, const std::vector<Px>& second) {
  Scene scene = square(32);
  draw(scene, first);
  draw(scene, second);
  return scene;
}

Scene mesh(SharedMesh kind, Grid grid, uint32_t samples, uint32_t pieces, uint64_t seed) {
  return sharedEdges({seed, kind, grid, samples, 64, pieces});
}

/// A tiled floor at a grazing angle, turned a little. `split`: every second row of tiles has its corners in the middle of
/// its neighbours' edges, at places that are rounded for themselves.
Scene tiledFloor(bool split) {
  constexpr int kColumns = 12, kRows = 10;
  Scene scene = square(96, 4);
  const auto corner = [](double column, double row) {
    const double along = 0.9 * row, across = 0.31 * (column - kColumns / 2.0);
    const double x = 0.96 * across - 0.28 * (along - 4), w = 0.28 * across + 0.96 * along + 3.2;
    return ClipPosition{static_cast<float>(x), 2.2f, static_cast<float>(0.5 * w), static_cast<float>(w)};
  };
  std::vector<ClipPosition> v;
  for (int row = 0; row < kRows; ++row) {
    const double shift = split && row % 2 == 1 ? 0.5 : 0;
    for (int column = 0; column < kColumns; ++column) {
      const ClipPosition a = corner(column + shift, row), b = corner(column + 1 + shift, row);
      const ClipPosition c = corner(column + 1 + shift, row + 1), d = corner(column + shift, row + 1);
      v.insert(v.end(), {a, b, c, a, c, d});
    }
  }
  drawClip(scene, std::move(v));
  return scene;
}

}  // namespace

void addSharedEdge(Entries& entries) {
  Family family(entries, "shared-edge");
  const std::vector<std::string> rules{"R14", "R15"};
  family.add(
      "diagonal-1x", "the diagonal of a square runs through pixel centres", rules, [] { return diagonal(1); }, kSeams);
  family.add("diagonal-4x", "the diagonal of a square runs through samples", rules, [] { return diagonal(4); });
  family.add("horizontal", "a shared horizontal edge lies on a row of centres", rules, [] {
    return pair({{4.5, 16.5}, {28.5, 16.5}, {14.5, 4.5}}, {{4.5, 16.5}, {28.5, 16.5}, {20.5, 28.5}});
  });
  family.add("vertical", "a shared vertical edge lies on a column of centres", rules, [] {
    return pair({{16.5, 4.5}, {16.5, 28.5}, {4.5, 12.5}}, {{16.5, 4.5}, {16.5, 28.5}, {28.5, 20.5}});
  });
  family.add("across-draws", "the neighbours come from different draws", rules, [] {
    return pair({{4.5, 4.5}, {28.5, 28.5}, {4.5, 28.5}}, {{4.5, 4.5}, {28.5, 4.5}, {28.5, 28.5}});
  });
  family.add("steep-and-flat", "shared edges of slope 3 and 1/3 with a centre every third pixel", rules, [] {
    Scene scene = square(32);
    draw(scene, {{3.5, 6.5},
                 {27.5, 14.5},
                 {10.5, 28.5},
                 {3.5, 6.5},
                 {27.5, 14.5},
                 {26.5, 2.5},
                 {8.5, 28.5},
                 {16.5, 4.5},
                 {2.5, 12.5},
                 {8.5, 28.5},
                 {16.5, 4.5},
                 {24.5, 24.5}});
    return scene;
  });
  family.add("opposite-windings", "the neighbours are wound differently", rules, [] {
    return pair({{4.5, 4.5}, {28.5, 28.5}, {4.5, 28.5}}, {{4.5, 4.5}, {28.5, 28.5}, {28.5, 4.5}});
  });
  family.add("same-side", "triangles on the same side of a common edge both cover it or neither does", rules, [] {
    return pair({{4.5, 4.5}, {28.5, 28.5}, {4.5, 28.5}}, {{28.5, 28.5}, {4.5, 4.5}, {10.5, 26.5}});
  });
  family.add("t-junction", "a vertex lies on the middle of a neighbour's edge, on the grid", rules, [] {
    Scene scene = square(32);
    draw(scene, {{4.5, 16.5},
                 {28.5, 16.5},
                 {16.5, 4.5},
                 {4.5, 16.5},
                 {16.5, 16.5},
                 {8.5, 28.5},
                 {16.5, 16.5},
                 {28.5, 16.5},
                 {24.5, 28.5}});
    return scene;
  });
  family.add(
      "grazing-floor-4x", "a tiled floor at a grazing angle has no seams at four samples", {"R1", "R14", "R15"},
      [] { return tiledFloor(false); }, kGrazingSeams);
  family.add(
      "grazing-t-junctions-4x", "the same with vertices on neighbours' edges: seams, but the same ones", {"R1", "R14", "R15"},
      [] { return tiledFloor(true); }, kGrazingSeams);
  family.add("off-grid-edge", "the shared edge's ends are snapped, to the same place for both", rules, [] {
    Scene scene = square(64);
    const Px a{5.1234567, 7.7654321}, b{58.3333333, 49.9999999};
    draw(scene, {a, b, {9.9, 60.2}, a, b, {54.4, 3.3}});
    return scene;
  });
  family.add("fan-1x", "many edges meet on a pixel centre", rules,
             [] { return mesh(SharedMesh::Fan, Grid::Half, 1, 24, 11); });
  family.add("fan-4x", "many edges meet on a sample", rules,
             [] { return mesh(SharedMesh::Fan, Grid::Sixteenth, 4, 24, 12); });
  family.add("strip-1x", "every edge of a strip is shared and ends on samples", rules,
             [] { return mesh(SharedMesh::Strip, Grid::Half, 1, 30, 13); });
  family.add("strip-4x", "every edge of a strip is shared and ends on samples", rules,
             [] { return mesh(SharedMesh::Strip, Grid::Sixteenth, 4, 30, 14); });
  family.add(
      "grid-half-1x", "a lattice of triangles with vertices on the half-pixel grid", rules,
      [] { return mesh(SharedMesh::Grid, Grid::Half, 1, 14, 15); }, kSeams);
  family.add("grid-sixteenth-4x", "a lattice of triangles with vertices on samples", rules,
             [] { return mesh(SharedMesh::Grid, Grid::Sixteenth, 4, 14, 16); });
  family.add("grid-256th-4x", "a lattice of triangles with some vertices between samples", rules,
             [] { return mesh(SharedMesh::Grid, Grid::TwoHundredFiftySixth, 4, 14, 17); });
  family.add(
      "grid-free-1x", "a lattice whose vertices have to be snapped", rules,
      [] { return mesh(SharedMesh::Grid, Grid::Free, 1, 14, 18); },
      "https://github.com/KhronosGroup/WebGL/issues/1797");
}

}  // namespace rasterdiff::families
