// Triangles below a pixel: most cover nothing, none may cover twice.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// An indexed lattice of squares of `step` pixels from (x, y).
Scene lattice(double x, double y, double step, uint32_t cells, uint32_t samples) {
  Scene scene = square(16, samples);
  std::vector<Px> v;
  for (uint32_t row = 0; row <= cells; ++row) {
    for (uint32_t column = 0; column <= cells; ++column) v.push_back({x + step * column, y + step * row});
  }
  std::vector<uint32_t>& indices = draw(scene, v).indices.emplace();
  for (uint32_t row = 0; row < cells; ++row) {
    for (uint32_t column = 0; column < cells; ++column) {
      const uint32_t a = row * (cells + 1) + column, b = a + cells + 1;
      for (uint32_t i : {a, a + 1, b, a + 1, b + 1, b}) indices.push_back(i);
    }
  }
  return scene;
}

}  // namespace

void addTiny(Entries& entries) {
  Family family(entries, "tiny");
  const std::vector<std::string> rules{"R14", "R15"};
  family.add("sixteenth-lattice-1x", "squares of 1/16 pixel, each sample once", rules,
             [] { return lattice(4, 4, 0.0625, 48, 1); });
  family.add("sixteenth-lattice-4x", "squares of 1/16 pixel with samples on their corners", rules,
             [] { return lattice(4, 4, 0.0625, 48, 4); });
  family.add("256th-lattice", "squares of 1/256 pixel around a centre", rules,
             [] { return lattice(8.375, 8.375, 0.00390625, 64, 1); });
  family.add("off-grid-lattice", "squares of 1/100 pixel: many collapse when snapped", {"R12", "R14", "R15"},
             [] { return lattice(7.9, 7.9, 0.01, 64, 1); });
  family.add("smallest", "the smallest triangle of the grid on a sample, in every orientation", rules, [] {
    Scene scene = square(16);
    std::vector<Px> v;
    for (int i = 0; i < 16; ++i) {
      const double x = i + 0.5, s = i & 1 ? 0x1p-8 : -0x1p-8, t = i & 2 ? 0x1p-8 : -0x1p-8;
      Px a{x + s, 8.5}, b{x, 8.5 + t}, c{x, 8.5};
      if (i & 4) c = {x + s, 8.5 + t};
      if (i & 8) std::swap(a, b);
      v.insert(v.end(), {c, a, b});
    }
    draw(scene, v);
    return scene;
  });
}

}  // namespace rasterdiff::families
