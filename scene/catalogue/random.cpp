// Seeded random triangles on each grid, at one and four samples, flat on the screen and in perspective.
#include "scene/catalogue/build.hpp"
#include "scene/generators/random_triangles.hpp"

namespace rasterdiff::families {

void addRandom(Entries& entries) {
  Family family(entries, "random");
  struct Named {
    Grid grid;
    const char* name;
  };
  const auto add = [&](const std::string& name, std::string what, std::vector<std::string> rules, RandomTriangles options) {
    family.addRandom(name, std::move(what), std::move(rules), options.seed, options.triangles,
                     [options](uint64_t seed, uint32_t triangles) mutable {
                       options.seed = seed;
                       options.triangles = triangles;
                       return randomTriangles(options);
                     });
  };
  uint64_t seed = 1000;
  for (const Named& g : {Named{Grid::Half, "half"}, Named{Grid::Sixteenth, "sixteenth"},
                         Named{Grid::TwoHundredFiftySixth, "256th"}, Named{Grid::Free, "free"}}) {
    for (uint32_t samples : {1u, 4u}) {
      for (bool perspective : {false, true}) {
        add(std::string(g.name) + (samples == 1 ? "-1x" : "-4x") + (perspective ? "-persp" : "-w1"),
            "500 triangles of all sizes", {"R1", "R3", "R12", "R14", "R15", "R50"},
            {++seed, 500, g.grid, samples, perspective, 256, false});
      }
    }
  }
  for (bool perspective : {false, true}) {
    add(perspective ? "values-persp" : "values-w1", "depth and values of 200 triangles of all sizes",
        {"R11", "R21", "R22", "R38"}, {++seed, 200, Grid::Free, 1, perspective, 128, true});
  }
}

}  // namespace rasterdiff::families
