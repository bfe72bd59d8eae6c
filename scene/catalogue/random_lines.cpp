// Seeded random lines, rectangular and Bresenham, at one and four samples: narrow on the grid, narrow off it, wide.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"
#include "scene/generators/random_lines.hpp"

namespace rasterdiff::families {

void addRandomLines(Entries& entries) {
  Family family(entries, "random-lines");
  struct Kind {
    const char* suffix;
    Grid grid;
    float width;
  };
  uint64_t seed = 2000;
  for (const bool bresenham : {false, true}) {
    for (const uint32_t samples : {1u, 4u}) {
      for (const Kind& kind :
           {Kind{"", Grid::Sixteenth, 1}, Kind{"-free", Grid::Free, 1}, Kind{"-wide", Grid::Sixteenth, 3.5f},
            Kind{"-free-wide", Grid::Free, 6}}) {
        RandomLines options{
            .seed = ++seed,
            .grid = kind.grid,
            .samples = samples,
            .mode = bresenham ? LineRasterizationMode::BRESENHAM : LineRasterizationMode::RECTANGULAR,
            .width = kind.width};
        std::vector<std::string> rules{"R50", bresenham ? "R29" : "R27"};
        if (bresenham && kind.width != 1) rules.push_back("R30");
        if (bresenham && samples > 1) rules.push_back("R31");
        family.addRandom(fmt::format("{}-{}x{}", bresenham ? "bresenham" : "rect", samples, kind.suffix),
                         "400 lines in all directions", std::move(rules), options.seed, 400,
                         [options](uint64_t s, uint32_t lines) mutable {
                           options.seed = s;
                           options.lines = lines;
                           return randomLines(options);
                         });
      }
    }
  }
}

}  // namespace rasterdiff::families
