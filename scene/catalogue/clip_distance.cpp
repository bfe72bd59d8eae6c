// User clip distances: half-spaces that are kept where c >= 0. [vk:vertexpostproc-clipping]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

void distances(Draw& draw, uint32_t count, std::vector<float> values) {
  draw.clipDistanceCount = count;
  draw.clipDistances = std::move(values);
}

Scene triangle(uint32_t samples, uint32_t count, std::vector<float> values) {
  Scene scene = square(64, samples);
  distances(draw(scene, {{6.5, 5.5}, {58.25, 14.5}, {22.5, 59.75}}), count, std::move(values));
  return scene;
}

/// A lattice drawn twice, with d and with -d: d is linear in clip space and zero on samples.
Scene complementary(uint32_t samples, double a, double b, double c, bool perspective) {
  Scene scene = square(64, samples);
  for (const double sign : {1.0, -1.0}) {
    std::vector<Px> v;
    std::vector<float> d;
    for (int i = 0; i < 9; ++i) {
      const double x = 6.5 + 17 * (i % 3), y = 6.5 + 17 * (i / 3);
      for (const Px& p : rectangle(x, y, x + 17, y + 17)) {
        const double w = perspective ? 1 + (p.x + p.y) / 64 : 1;
        v.push_back({p.x, p.y, 0.5, w});
        d.push_back(static_cast<float>(sign * (a * p.x + b * p.y + c) * w));
      }
    }
    distances(draw(scene, v), 1, std::move(d));
  }
  return scene;
}

}  // namespace

void addClipDistance(Entries& entries) {
  Family family(entries, "clip-distance");
  const std::vector<std::string> rules{"R5"};
  family.add("one", "one vertex is cut off", rules, [] { return triangle(1, 1, {-1, 0.5f, 1}); });
  family.add("two-off", "two vertices are cut off", rules, [] { return triangle(4, 1, {-1, -0.25f, 1}); });
  family.add("all-off", "all vertices are outside: nothing is left", rules, [] { return triangle(1, 1, {-1, -0.5f, -1e-30f}); });
  family.add("all-zero", "distances of exactly 0 are inside", rules, [] { return triangle(1, 1, {0, 0, -0.0f}); });
  family.add("zero-edge", "an edge at exactly 0 and the rest inside, or outside", rules, [] {
    Scene scene = triangle(4, 1, {0, 0, 1});
    distances(draw(scene, {{60.5, 20.5}, {60.5, 60.5}, {28.5, 60.5}}), 1, {0, -1, 0});
    return scene;
  });
  family.add("two-distances", "what two half-spaces have in common", rules,
             [] { return triangle(4, 2, {-1, 1, 1, -0.5f, 0.75f, 1}); });
  family.add("eight-distances", "eight half-spaces, each takes a corner", rules, [] {
    return triangle(1, 8, {-0.1f, 1, 1, 1, 0.9f, 1, 2, 1, 1, -0.1f, 1, -0.2f, 1, 1, 1, 1, 1, 1, -0.1f, 1, 1, 1, -0.3f, 1});
  });
  family.add("perspective", "distances are interpolated in clip space", rules, [] {
    Scene scene = square(64);
    distances(draw(scene, {{6.5, 5.5, 0.5, 0.5}, {58.25, 14.5, 0.5, 4}, {22.5, 59.75, 0.5, 1}}), 1, {-1, 4, 1});
    return scene;
  });
  const std::vector<std::string> both{"R5", "R6"};
  family.add("complementary-vertical-1x", "d and -d: no pixel twice, none missing, zero on pixel centres", both,
             [] { return complementary(1, 1, 0, -32.5, false); });
  family.add("complementary-diagonal-1x", "d and -d along a diagonal through pixel centres", both,
             [] { return complementary(1, 1, 1, -64, false); });
  family.add("complementary-slanted-4x", "d and -d along a slanted line at four samples", both,
             [] { return complementary(4, 0.75, -0.5, -5.0 / 3, false); });
  family.add("complementary-perspective", "d and -d under perspective", both,
             [] { return complementary(1, 0.625, 0.375, -30.1, true); });
  family.add("values", "values of the part that is kept", {"R5", "R9"}, [] {
    Scene scene = triangle(1, 1, {-1, 0.5f, 1});
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "screen", Interpolation::noperspective, 1);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("lines", "lines cut by a distance", {"R5", "R8", "R27"}, [] {
    Scene scene = square(32);
    useLines(scene, LineRasterizationMode::RECTANGULAR);
    distances(draw(scene, {{3.5, 4.5}, {28.5, 8.5}, {3.5, 14.5}, {28.5, 14.5}, {4.5, 20.5}, {20.5, 28.5}}), 1,
              {-1, 1, 0, 1, -1, -0.5f});
    return scene;
  });
  family.add("with-view-volume", "cut by the view volume and by a distance", {"R3", "R5"}, [] {
    Scene scene = square(64);
    distances(drawClip(scene, {{-2, -0.5f, 0.5f, 1}, {0.75f, -0.75f, 0.5f, 1}, {0.25f, 1.75f, -0.5f, 1}}), 1, {1, -0.5f, 1});
    return scene;
  });
}

}  // namespace rasterdiff::families
