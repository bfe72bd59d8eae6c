// Seeded random points at one and four samples: one pixel wide, small, and of all sizes.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"
#include "scene/generators/random_points.hpp"

namespace rasterdiff::families {

void addRandomPoints(Entries& entries) {
  Family family(entries, "random-points");
  struct Kind {
    const char* suffix;
    Grid grid;
    float smallest, largest;
  };
  uint64_t seed = 3000;
  for (const uint32_t samples : {1u, 4u}) {
    for (const Kind& kind : {Kind{"", Grid::Sixteenth, 1, 1}, Kind{"-mixed", Grid::Sixteenth, 0.5f, 16},
                             Kind{"-free", Grid::Free, 1, 1}, Kind{"-free-mixed", Grid::Free, 0.5f, 16}}) {
      RandomPoints options{.seed = ++seed,
                                 .grid = kind.grid,
                                 .samples = samples,
                                 .smallest = kind.smallest,
                                 .largest = kind.largest};
      family.addRandom(fmt::format("{}x{}", samples, kind.suffix), "400 points, many on pixel centres and edges",
                       {"R25", "R50"}, options.seed, 400, [options](uint64_t s, uint32_t points) mutable {
                         options.seed = s;
                         options.points = points;
                         return randomPoints(options);
                       });
    }
  }
}

}  // namespace rasterdiff::families
