// Crowds: a thousand small primitives each, so that a rule that decides once a primitive decides often, on both drivers.
#include "scene/catalogue/build.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kCells = 32;  // in each direction
constexpr double kCell = 4;      // pixels

Scene crowdTarget(uint32_t samples = 1) { return square(static_cast<uint32_t>(kCells * kCell), samples); }

/// Calls `make(x, y, prng)` with the corner of every cell in pixels; it appends vertices.
template <class Make>
std::vector<Px> everywhere(uint64_t seed, const Make& make) {
  Prng prng(seed);
  std::vector<Px> vertices;
  for (uint32_t i = 0; i < kCells * kCells; ++i) make(vertices, kCell * (i % kCells), kCell * (i / kCells), prng);
  return vertices;
}

/// A point of the half-pixel grid in the cell.
Px somewhere(double x, double y, Prng& prng) { return {x + prng.between(0, 8) * 0.5, y + prng.between(0, 8) * 0.5}; }

std::vector<Px> triangles(uint64_t seed, uint32_t each = 1) {
  return everywhere(seed, [each](std::vector<Px>& v, double x, double y, Prng& prng) {
    for (uint32_t i = 0; i < 3 * each; ++i) v.push_back(somewhere(x, y, prng));
  });
}

/// Depths between `low` and `high`, one for each vertex.
std::vector<Px> withDepths(std::vector<Px> vertices, double low, double high, uint64_t seed) {
  Prng prng(seed);
  for (Px& vertex : vertices) vertex.z = prng.between(low, high);
  return vertices;
}

Scene biased(PolygonMode mode) {
  Scene scene = crowdTarget();
  scene.state.polygonMode = mode;
  draw(scene, withDepths(triangles(7), 0.25, 0.75, 8));
  useDepth(scene, CompareOp::ALWAYS);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = -64;
  scene.state.depthBiasSlopeFactor = 1.5f;
  return scene;
}

}  // namespace

void addCrowd(Entries& entries) {
  Family family(entries, "crowd");
  for (const CullMode cull : {CullMode::FRONT, CullMode::BACK}) {
    family.add(cull == CullMode::FRONT ? "cull-front" : "cull-back", "triangles of both windings and of no area, culled",
               {"R12", "R13"}, [cull] {
                 Scene scene = crowdTarget();
                 draw(scene, triangles(1, 2));
                 scene.state.cullMode = cull;
                 return scene;
               });
  }
  family.add("depth-clamp", "depths beyond both ends of the range, clamped", {"R4", "R38"}, [] {
    Scene scene = crowdTarget();
    draw(scene, withDepths(triangles(2, 2), -0.75, 1.75, 3));
    useDepth(scene, CompareOp::ALWAYS);
    scene.state.depthClampEnable = true;
    return scene;
  });
  family.add("clip-distance", "triangles halved, kept and dropped by a distance of their own", {"R5"}, [] {
    Scene scene = crowdTarget();
    Draw& d = draw(scene, triangles(4, 2));
    Prng prng(5);
    d.clipDistanceCount = 1;
    for (size_t i = 0; i < d.positions.size(); ++i) d.clipDistances.push_back(static_cast<float>(prng.between(-2, 2)));
    return scene;
  });
  family.add("points-in-depth", "points before, on, between and behind the near and far plane", {"R7", "R25", "R26"}, [] {
    Scene scene = crowdTarget();
    usePoints(scene);
    draw(scene, everywhere(6, [](std::vector<Px>& v, double x, double y, Prng& prng) {
           constexpr double kDepths[] = {-0.5, -0x1p-20, 0, 0.5, 1, 1 + 0x1p-20, 2};
           for (int32_t i = 0; i < 4; ++i) {
             v.push_back({x + 2 * (i % 2) + 0.5, y + 2 * (i / 2) + 0.5, kDepths[prng.below(std::size(kDepths))]});
           }
         }));
    return scene;
  });
  family.add("lines-cut", "lines that a clip distance cuts half-way, or removes", {"R5", "R8", "R27"}, [] {
    Scene scene = crowdTarget();
    useLines(scene, LineRasterizationMode::RECTANGULAR);
    Draw& d = draw(scene, everywhere(9, [](std::vector<Px>& v, double x, double y, Prng& prng) {
                     v.push_back({x + 0.5, y + 0.5 + prng.between(0, 3)});
                     v.push_back({x + 3.5, v.back().y});
                   }));
    d.clipDistanceCount = 1;
    for (size_t i = 0; i < d.positions.size(); i += 2) {
      d.clipDistances.push_back(1);
      d.clipDistances.push_back(-1);
    }
    return scene;
  });
  family.add("outlines", "the edges of small triangles", {"R27", "R34"}, [] {
    Scene scene = crowdTarget();
    scene.state.polygonMode = PolygonMode::LINE;
    draw(scene, triangles(10));
    return scene;
  });
  family.add("masks", "the masks of partly covered pixels", {"R16", "R24"}, [] {
    Scene scene = crowdTarget(4);
    scene.builtIns = {BuiltIn::SampleMask};
    draw(scene, triangles(11));
    return scene;
  });
  family.add("biased", "a bias of slope and constant on small steep triangles", {"R35", "R36"},
             [] { return biased(PolygonMode::FILL); });
  family.add("biased-corners", "the bias of the triangle on its corners", {"R34", "R37"},
             [] { return biased(PolygonMode::POINT); });
  family.add("resolved", "pixels of two values, averaged", {"R42"}, [] {
    Scene scene = crowdTarget(4);
    scene.target.resolve = true;
    draw(scene, triangles(12));
    addVarying(scene, "value", Interpolation::flat, 1);
    return scene;
  });
}

}  // namespace rasterdiff::families
