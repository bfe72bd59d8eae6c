// Values between vertices: perspective-correct, linear on the screen, or the provoking vertex's.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// Two large triangles; with `perspective` their w differ by powers of two and by odd factors.
Scene pair(bool perspective, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  const double w1 = perspective ? 4 : 1, w2 = perspective ? 0.3 : 1;
  draw(scene, {{3.3, 5.1, 0.25},
               {60.7, 9.9, 0.5, w1},
               {21.4, 58.2, 0.75, w2},
               {60.7, 9.9, 0.5, w1},
               {61.5, 61.25, 0.5},
               {21.4, 58.2, 0.75, w2}});
  return scene;
}

Scene with(Interpolation interpolation, bool perspective, uint32_t components = 4, uint32_t samples = 1) {
  Scene scene = pair(perspective, samples);
  addVarying(scene, "value", interpolation, components);
  return scene;
}

/// The smooth value scaled: its legal intervals scale along.
Scene scaled(float factor, float offset) {
  Scene scene = with(Interpolation::smooth, true, 2);
  for (float& v : scene.draws[0].varyings[0].values) v = v * factor + offset;
  return scene;
}

Scene constant(Interpolation interpolation, float value) {
  Scene scene = with(interpolation, true, 1);
  for (float& v : scene.draws[0].varyings[0].values) v = value;
  return scene;
}

Scene provoking(PrimitiveTopology topology, ProvokingVertexMode mode) {
  Scene scene = square(64);
  scene.state.topology = topology;
  scene.state.provokingVertexMode = mode;
  draw(scene, {{32.5, 32.5},
               {60.5, 30.5},
               {48.5, 60.5},
               {20.5, 58.5},
               {4.5, 34.5},
               {14.5, 6.5},
               {44.5, 3.5},
               {58.5, 20.5},
               {9.5, 20.5}});
  addVarying(scene, "flat", Interpolation::flat, 2);
  return scene;
}

}  // namespace

void addVaryings(Entries& entries) {
  Family family(entries, "varying");
  const std::vector<std::string> rules{"R21"};
  family.add("smooth-w1", "a smooth value where all w are 1", rules, [] { return with(Interpolation::smooth, false); });
  family.add("smooth-perspective", "a smooth value is divided by w", rules,
             [] { return with(Interpolation::smooth, true); });
  family.add("smooth-perspective-4x", "a smooth value at four samples", {"R17", "R20", "R21"},
             [] { return with(Interpolation::smooth, true, 4, 4); });
  family.add("noperspective-w1", "a value linear on the screen where all w are 1", rules,
             [] { return with(Interpolation::noperspective, false); });
  family.add("noperspective-perspective", "a value linear on the screen ignores w", rules,
             [] { return with(Interpolation::noperspective, true); });
  family.add("noperspective-4x", "a value linear on the screen at four samples", {"R17", "R20", "R21"},
             [] { return with(Interpolation::noperspective, true, 2, 4); });
  family.add("flat", "a flat value is a vertex's, bit by bit", {"R11"}, [] { return with(Interpolation::flat, true); });
  for (uint32_t components : {1u, 2u, 3u}) {
    family.add(fmt::format("components-{}", components), "a value of fewer than four components", rules,
               [components] { return with(Interpolation::smooth, true, components); });
  }
  family.add("eight", "as many varyings as there may be, of all kinds", {"R11", "R21"}, [] {
    Scene scene = pair(true);
    for (uint32_t i = 0; i < kMaxVaryings; ++i)
      addVarying(scene, fmt::format("v{}", i), static_cast<Interpolation>(i % 3));
    return scene;
  });
  family.add("with-depth", "values and depth in one scene, the nearer wins", {"R21", "R22", "R38"}, [] {
    Scene scene = pair(true);
    useDepth(scene);
    draw(scene, {{50, 3, 0.125, 2}, {58, 50, 0.875}, {5, 40, 0.25, 0.5}});
    addVarying(scene, "value", Interpolation::smooth);
    return scene;
  });
  family.add("constant-smooth", "the same value at all vertices: how constant is it?", rules,
             [] { return constant(Interpolation::smooth, 0.7f); });
  family.add("constant-noperspective", "the same value at all vertices, linear on the screen", rules,
             [] { return constant(Interpolation::noperspective, 0.7f); });
  family.add("large", "values around 1e30", rules, [] { return scaled(1e30f, 0); });
  family.add("small", "values around 1e-30", rules, [] { return scaled(1e-30f, 0); });
  family.add("denormal", "flat values below the smallest normal number", {"R11"},
             [] { return constant(Interpolation::flat, 1e-40f); });
  family.add("offset", "small differences on a large value: cancellation", rules, [] { return scaled(1, 4096); });
  family.add("negative", "values of both signs", rules, [] { return scaled(-8, 2); });
  family.add("w-range", "w from 2^-8 to 2^8 in one triangle", rules, [] {
    Scene scene = square(64);
    draw(scene, {{4, 6, 0.5, 0x1p-8}, {60, 12, 0.5, 0x1p8}, {20, 60, 0.5, 1}});
    addVarying(scene, "value", Interpolation::smooth);
    return scene;
  });
  family.add("sliver", "a value across a long thin triangle", rules, [] {
    Scene scene = target(256, 32);
    draw(scene, {{2, 4.1, 0.5, 1},
                 {254, 27.3, 0.5, 3},
                 {250, 27.6, 0.5, 0.5},
                 {2, 28, 0.5},
                 {253, 3, 0.5, 2},
                 {254.5, 4.25, 0.5}});
    addVarying(scene, "value", Interpolation::smooth);
    return scene;
  });
  family.add("across-draws", "the second draw's values are its own", {"R21", "R50"}, [] {
    Scene scene = pair(true);
    draw(scene, {{50, 3, 0.5, 2}, {58, 50}, {5, 40, 0.5, 0.5}});
    addVarying(scene, "value", Interpolation::smooth);
    return scene;
  });
  struct Topology {
    PrimitiveTopology topology;
    const char* name;
  };
  for (const Topology& t :
       {Topology{PrimitiveTopology::TRIANGLE_LIST, "list"}, Topology{PrimitiveTopology::TRIANGLE_STRIP, "strip"},
        Topology{PrimitiveTopology::TRIANGLE_FAN, "fan"}}) {
    for (const auto mode : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
      const std::string end = mode == ProvokingVertexMode::FIRST_VERTEX ? "first" : "last";
      family.add("provoking-" + end + "-" + t.name,
                 "a flat value comes from the " + end + " vertex of a " + t.name + "'s triangles", {"R11"},
                 [topology = t.topology, mode] { return provoking(topology, mode); });
    }
  }
}

}  // namespace rasterdiff::families
