// Seeded random triangles drawn as their edges, or as their corners. [vk:primsrast-polygonmode]
#include "scene/catalogue/random_primitives.hpp"
#include "scene/generators/random_state.hpp"
#include "scene/generators/random_strips.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kTriangles = 100;

struct Outline {
  uint32_t samples = 1;
  bool perspective = false;
  float spread = 1;
  LineRasterizationMode mode = LineRasterizationMode::RECTANGULAR;
  float width = 1;
  bool stippled = false, culled = false;
};

Scene edges(const Outline& o, uint64_t seed, uint32_t count) {
  Scene scene = someTriangles(seed, count, o.samples, o.perspective);
  scene.state.polygonMode = PolygonMode::LINE;
  scene.state.lineRasterizationMode = o.mode;
  scene.state.lineWidth = o.width;
  if (o.spread != 1) spreadOut(scene, o.spread);
  if (o.stippled) giveStipple(scene, seed);
  if (o.culled) giveCulling(scene, seed);
  return scene;
}

Scene corners(const Outline& o, uint64_t seed, uint32_t count) {
  Scene scene = someTriangles(seed, count, o.samples, o.perspective);
  scene.state.polygonMode = PolygonMode::POINT;
  scene.state.pointSize = o.width;
  if (o.spread != 1) spreadOut(scene, o.spread);
  if (o.culled) giveCulling(scene, seed);
  return scene;
}

}  // namespace

void addRandomOutlines(Entries& entries) {
  using enum LineRasterizationMode;
  uint64_t seed = 5000;
  Family lines(entries, "random-edges");
  const auto addEdges = [&](const char* name, const char* what, std::vector<std::string> rules, Outline o) {
    lines.addRandom(name, what, std::move(rules), ++seed, kTriangles,
                    [o](uint64_t s, uint32_t n) { return edges(o, s, n); });
  };
  addEdges("rect-1x", "rectangular edges", {"R27", "R34"}, {});
  addEdges("rect-4x", "rectangular edges at four samples, in perspective", {"R27", "R34"}, {.samples = 4, .perspective = true});
  addEdges("wide-4x", "edges three and a half pixels wide", {"R27", "R34"}, {.samples = 4, .width = 3.5f});
  addEdges("bresenham-1x", "Bresenham edges", {"R29", "R34"}, {.mode = BRESENHAM});
  addEdges("bresenham-4x", "Bresenham edges cover whole pixels", {"R29", "R31", "R34"}, {.samples = 4, .mode = BRESENHAM});
  addEdges("culled-1x", "no edges of culled triangles", {"R13", "R27", "R34"}, {.culled = true});
  addEdges("clipped-1x", "edges of triangles that leave the view volume", {"R3", "R27", "R34"}, {.spread = 2});
  addEdges("clipped-4x", "edges of triangles that leave the view volume, in perspective", {"R3", "R27", "R34"},
           {.samples = 4, .perspective = true, .spread = 2});
  Family points(entries, "random-corners");
  const auto addCorners = [&](const char* name, const char* what, std::vector<std::string> rules, Outline o) {
    points.addRandom(name, what, std::move(rules), ++seed, kTriangles,
                     [o](uint64_t s, uint32_t n) { return corners(o, s, n); });
  };
  addCorners("1x", "corners of one pixel", {"R25", "R34"}, {});
  addCorners("4x", "corners of three pixels and a half at four samples, in perspective", {"R25", "R34"},
             {.samples = 4, .perspective = true, .width = 3.5f});
  addCorners("culled-4x", "no corners of culled triangles", {"R13", "R25", "R34"}, {.samples = 4, .culled = true});
  addCorners("clipped-1x", "corners of triangles that leave the view volume", {"R3", "R25", "R34"}, {.spread = 2});
}

}  // namespace rasterdiff::families
