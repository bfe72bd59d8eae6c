// User cull distances: a primitive goes if one of them is negative at all its vertices. [vk:vertexpostproc-clipping]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// One triangle each: {distances of its three vertices}, `count` a vertex.
Scene triangles(uint32_t count, std::vector<float> values) {
  Scene scene = square(64);
  std::vector<Px> v;
  for (size_t i = 0; i < values.size() / (3 * count); ++i) {
    const double x = 4 + 15.0 * static_cast<double>(i % 4), y = 4 + 15 * static_cast<double>(i / 4);
    v.insert(v.end(), {{x, y}, {x + 12.5, y + 1}, {x + 1, y + 12.5}});
  }
  Draw& d = draw(scene, v);
  d.cullDistanceCount = count;
  d.cullDistances = std::move(values);
  return scene;
}

/// Triangles with `clips` clip distances, none of which is negative, and `culls` cull distances, of which the last decides: the first
/// triangle goes.
Scene behindClips(uint32_t clips, uint32_t culls) {
  constexpr size_t kVertices = 6;
  std::vector<float> values(kVertices * culls, 1);
  for (size_t vertex = 0; vertex < 3; ++vertex) values[(vertex + 1) * culls - 1] = -1;
  Scene scene = triangles(culls, std::move(values));
  scene.draws[0].clipDistanceCount = clips;
  scene.draws[0].clipDistances.assign(kVertices * clips, 0);
  return scene;
}

}  // namespace

void addCullDistance(Entries& entries) {
  Family family(entries, "cull-distance");
  const std::vector<std::string> rules{"R5"};
  family.add("one", "only a triangle that is negative at all vertices goes; zero and -0 stay", rules, [] {
    return triangles(1, {-1, -1, -1, 1, 1, 1, -1, 1, 1, -1, -1, 1, -1, -1, 0, -0.0f, -1, -1, -1e-30f, -1, -2, 0, 0, 0});
  });
  family.add("two", "each distance by itself: different ones at different vertices cull nothing", rules, [] {
    return triangles(2, {-1, 1, -1, 1, -1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1, -1, 1, -1, -1, -1, -1, 1, 1, -1});
  });
  family.add("with-clip", "clip and cull distances together", rules, [] {
    Scene scene = triangles(1, {-1, -1, -1, 1, 1, 1, -1, 1, 1});
    scene.draws[0].clipDistanceCount = 1;
    scene.draws[0].clipDistances = {1, 1, 1, -1, 1, 1, 1, 1, -1};
    return scene;
  });
  family.add("behind-three-clips", "two cull distances and three clip distances", rules, [] { return behindClips(3, 2); });
  family.add("behind-five-clips", "three cull distances and five clip distances", rules, [] { return behindClips(5, 3); });
  family.add("lines-points", "lines are culled too", {"R5", "R27"}, [] {
    Scene scene = square(32);
    useLines(scene, LineRasterizationMode::RECTANGULAR);
    Draw& d = draw(scene, {{3.5, 4.5}, {28.5, 8.5}, {3.5, 14.5}, {28.5, 14.5}, {4.5, 20.5}, {20.5, 28.5}});
    d.cullDistanceCount = 1;
    d.cullDistances = {-1, -1, -1, 1, 0, -1};
    return scene;
  });
  family.add("strip", "a strip's triangles by their own vertices", rules, [] {
    Scene scene = square(64);
    scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
    std::vector<Px> v;
    for (int i = 0; i < 8; ++i) v.push_back({4.5 + 7 * i, i % 2 == 0 ? 8.5 : 54.5});
    Draw& d = draw(scene, v);
    d.cullDistanceCount = 1;
    d.cullDistances = {1, -1, -1, -1, -1, 1, -1, 1};
    return scene;
  });
}

}  // namespace rasterdiff::families
