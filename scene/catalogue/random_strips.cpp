// Seeded random strips and fans of triangles, and strips of lines, cut by the restart index.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"
#include "scene/generators/random_state.hpp"
#include "scene/generators/random_strips.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kPrimitives = 150;

}  // namespace

void addRandomStrips(Entries& entries) {
  using enum PrimitiveTopology;
  uint64_t seed = 4000;
  Family triangles(entries, "random-strips");
  struct Kind {
    PrimitiveTopology topology;
    const char* name;
  };
  for (const Kind& kind : {Kind{TRIANGLE_STRIP, "strip"}, Kind{TRIANGLE_FAN, "fan"}}) {
    for (const uint32_t samples : {1u, 4u}) {
      for (const bool perspective : {false, true}) {
        const RandomStrips options{.topology = kind.topology,
                                   .grid = perspective ? Grid::Free : Grid::Sixteenth,
                                   .samples = samples,
                                   .perspective = perspective};
        triangles.addRandom(fmt::format("{}-{}x-{}", kind.name, samples, perspective ? "persp" : "w1"),
                            "runs of 1 to 10 triangles, each with the vertices of the last", {"R11", "R14", "R15", "R50"},
                            ++seed, kPrimitives, [options](uint64_t s, uint32_t n) {
                              RandomStrips asked = options;
                              asked.seed = s;
                              asked.primitives = n;
                              return randomStrips(asked);
                            });
      }
    }
  }
  Family lines(entries, "random-line-strips");
  for (const bool bresenham : {false, true}) {
    for (const uint32_t samples : {1u, 4u}) {
      for (const bool stippled : {false, true}) {
        std::vector<std::string> rules{bresenham ? "R29" : "R27"};
        if (stippled) rules.push_back("R32");
        lines.addRandom(fmt::format("{}-{}x{}", bresenham ? "bresenham" : "rect", samples, stippled ? "-stippled" : ""),
                        "runs of 1 to 10 lines that share their ends", std::move(rules), ++seed, kPrimitives,
                        [=](uint64_t s, uint32_t n) {
                          Scene scene = randomStrips(
                              {.seed = s, .primitives = n, .topology = LINE_STRIP, .grid = Grid::Free, .samples = samples});
                          if (bresenham) scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
                          if (!bresenham) scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR;
                          if (stippled) giveStipple(scene, s);
                          return scene;
                        });
      }
    }
  }
}

}  // namespace rasterdiff::families
