// Polygons as they stand in SVG files: concave, with holes by crossing themselves, many edges through one point.
#include "scene/catalogue/build.hpp"
#include "scene/polygon/polygon_draw.hpp"

namespace rasterdiff::families {
namespace {

/// `svg` is markup; user units are pixels.
Result<Scene> drawn(Scene scene, const char* svg, std::span<const Varying> varyings = {}) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(svg, "catalogue");
  if (!polygons) return tl::unexpected(polygons.error());
  Result<Draw> draw = polygonDraw(*polygons, scene.viewport, 0.5, varyings);
  if (!draw) return tl::unexpected(draw.error());
  scene.draws.push_back(std::move(*draw));
  return scene;
}

constexpr const char* kConcave =
    "<polygon points='4,4 60,4 60,60 52.5,60 52.5,12.25 44,12.25 44,60 30.125,20 20.5,60 20.5,32.5 4,60'/>";
/// Every third corner of a 16-gon, on the half-pixel grid: sixteen crossings deep.
constexpr const char* kStar =
    "<polygon fill-rule='evenodd' points='62.5,32.5 20.5,60.5 11,11 60.5,20.5 32.5,62.5 4.5,20.5 54,11 44.5,60.5'/>";
constexpr const char* kStarFilled =
    "<polygon points='62.5,32.5 20.5,60.5 11,11 60.5,20.5 32.5,62.5 4.5,20.5 54,11 44.5,60.5'/>";
/// Edges in all directions through one sample, in whole pixels: triangles whose corners meet at (32.5, 32.5).
constexpr const char* kPinwheel =
    "<polygon points='32.5,32.5 60.5,20.5 60.5,32.5 32.5,32.5 44.5,60.5 32.5,60.5 32.5,32.5 4.5,44.5 4.5,32.5 "
    "32.5,32.5 20.5,4.5 32.5,4.5'/>";
constexpr const char* kTwo =
    "<svg width='64' height='64' viewBox='0 0 64 64'><polygon points='2.3,5.1 61.7,17.9 40.2,33.3 58.6,61.4 9.1,44.8'/>"
    "<polygon fill-rule='evenodd' points='10,10 54,10 54,54 10,54 10,10 20,20 20,44 44,44 44,20 20,20'/></svg>";

}  // namespace

void addPolygon(Entries& entries) {
  Family family(entries, "polygon");
  const std::vector<std::string> rules{"R14", "R15"};
  struct Shape {
    const char *name, *what, *svg;
  };
  for (const Shape& shape : {Shape{"concave", "a comb with a notch: no sample outside of it, none missed", kConcave},
                             {"star-evenodd", "crossings off the grid, holes by parity", kStar},
                             {"star-nonzero", "the same without holes", kStarFilled},
                             {"pinwheel", "blades that share one corner on a sample", kPinwheel},
                             {"two", "two elements of one document, the second a frame with a hole, over the first", kTwo}}) {
    for (const uint32_t samples : {1u, 4u}) {
      family.addFallible(std::string(shape.name) + (samples == 1 ? "-1x" : "-4x"), shape.what, rules,
                         [svg = shape.svg, samples] { return drawn(square(64, samples), svg); });
    }
  }
  family.addFallible("values", "values run on across the triangles of a concave polygon", {"R14", "R15", "R21"}, [] {
    const Varying position{.name = "position"};
    return drawn(square(64), kConcave, {&position, 1});
  });
}

}  // namespace rasterdiff::families
