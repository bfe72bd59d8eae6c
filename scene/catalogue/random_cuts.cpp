// Seeded random primitives that are cut: by the view volume, by distances, by a scissor, by masks; and culled by their facing.
#include "scene/catalogue/random_primitives.hpp"
#include "scene/generators/random_state.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kPrimitives = 100;
using LineMode = LineRasterizationMode;

void addClips(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-clip");
  const auto add = [&](const char* name, const char* what, std::vector<std::string> rules,
                       std::function<Scene(uint64_t, uint32_t)> make) {
    family.addRandom(name, what, std::move(rules), ++seed, kPrimitives, std::move(make));
  };
  for (const uint32_t samples : {1u, 4u}) {
    add(samples == 1 ? "sides-1x" : "sides-4x", "triangles of twice the view volume's size", {"R3", "R14"},
        [samples](uint64_t s, uint32_t n) {
          Scene scene = someTriangles(s, n, samples, samples == 4);
          spreadOut(scene, 2);
          return scene;
        });
    add(samples == 1 ? "depth-1x" : "depth-4x", "triangles through the near and the far plane", {"R3", "R14"},
        [samples](uint64_t s, uint32_t n) {
          Scene scene = someTriangles(s, n, samples, samples == 1);
          leaveDepthRange(scene, s);
          return scene;
        });
    add(samples == 1 ? "unclipped-1x" : "minus-one-4x",
        samples == 1 ? "without depth clipping" : "triangles in a volume from -w to w", {"R3", "R4"},
        [samples](uint64_t s, uint32_t n) {
          Scene scene = someTriangles(s, n, samples, true);
          leaveDepthRange(scene, s);
          if (samples == 1) scene.state.depthClampEnable = true;
          if (samples == 4) scene.state.negativeOneToOne = true;
          return scene;
        });
    for (const bool bresenham : {false, true}) {
      const std::string mode = bresenham ? "bresenham" : "rect";
      family.addRandom(mode + (samples == 1 ? "-1x" : "-4x"), "lines that leave the view volume through every plane",
                       {"R8", bresenham ? "R29" : "R27"}, ++seed, kPrimitives, [=](uint64_t s, uint32_t n) {
                         Scene scene = someLines(s, n, samples, bresenham ? LineMode::BRESENHAM : LineMode::RECTANGULAR);
                         spreadOut(scene, 2);
                         leaveDepthRange(scene, s);
                         return scene;
                       });
    }
    add(samples == 1 ? "points-1x" : "points-4x", "points in front of the near and behind the far plane", {"R7", "R25"},
        [samples](uint64_t s, uint32_t n) {
          Scene scene = somePoints(s, n, samples);
          leaveDepthRange(scene, s);
          return scene;
        });
  }
}

void addDistances(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-distances");
  const auto add = [&](const char* name, const char* what, std::vector<std::string> rules,
                       std::function<Scene(uint64_t, uint32_t)> make) {
    family.addRandom(name, what, std::move(rules), ++seed, kPrimitives, std::move(make));
  };
  add("one-1x", "triangles cut by a distance", {"R5"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 1);
    giveClipDistances(scene, s, 1);
    return scene;
  });
  add("two-4x", "triangles cut by two distances, in perspective", {"R5"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 4, true);
    giveClipDistances(scene, s, 2);
    return scene;
  });
  add("eight-1x", "triangles cut by eight distances and the view volume", {"R3", "R5"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 1);
    spreadOut(scene, 2);
    giveClipDistances(scene, s, 8);
    return scene;
  });
  add("lines-1x", "lines cut by two distances", {"R5", "R8", "R27"}, [](uint64_t s, uint32_t n) {
    Scene scene = someLines(s, n, 1);
    giveClipDistances(scene, s, 2);
    return scene;
  });
  add("points-1x", "points kept where their distance is not negative", {"R5", "R7", "R25"}, [](uint64_t s, uint32_t n) {
    Scene scene = somePoints(s, n, 1);
    giveClipDistances(scene, s, 1);
    return scene;
  });
  add("edges-1x", "edges of what a distance leaves of triangles", {"R5", "R27", "R34"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 1);
    scene.state.polygonMode = PolygonMode::LINE;
    scene.state.lineRasterizationMode = LineMode::RECTANGULAR;
    giveClipDistances(scene, s, 1);
    return scene;
  });
  add("cull-1x", "triangles culled where a distance is negative at all vertices", {"R5"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 1);
    giveCullDistances(scene, s, 2);
    return scene;
  });
  add("cull-lines-4x", "lines culled where a distance is negative at both ends", {"R5", "R27"}, [](uint64_t s, uint32_t n) {
    Scene scene = someLines(s, n, 4);
    giveCullDistances(scene, s, 1);
    return scene;
  });
}

void addFacings(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-facing");
  for (const uint32_t samples : {1u, 4u}) {
    for (const bool perspective : {false, true}) {
      family.addRandom(std::string(samples == 1 ? "1x" : "4x") + (perspective ? "-persp" : "-w1"),
                       "triangles of one facing are culled", {"R12", "R13", "R14"}, ++seed, kPrimitives,
                       [=](uint64_t s, uint32_t n) {
                         Scene scene = someTriangles(s, n, samples, perspective);
                         giveCulling(scene, s);
                         return scene;
                       });
    }
  }
}

void addScissors(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-scissor");
  struct Kind {
    const char* name;
    std::function<Scene(uint64_t, uint32_t, uint32_t)> make;
  };
  const std::vector<Kind> kinds{
      {"triangles", [](uint64_t s, uint32_t n, uint32_t samples) { return someTriangles(s, n, samples); }},
      {"lines", [](uint64_t s, uint32_t n, uint32_t samples) { return someLines(s, n, samples); }},
      {"bresenham", [](uint64_t s, uint32_t n, uint32_t samples) { return someLines(s, n, samples, LineMode::BRESENHAM, 3); }},
      {"points", somePoints}};
  for (const Kind& kind : kinds) {
    for (const uint32_t samples : {1u, 4u}) {
      family.addRandom(std::string(kind.name) + (samples == 1 ? "-1x" : "-4x"), "no sample outside the scissor",
                       {"R39", "R49"}, ++seed, kPrimitives, [make = kind.make, samples](uint64_t s, uint32_t n) {
                         Scene scene = make(s, n, samples);
                         giveScissor(scene, s);
                         return scene;
                       });
    }
  }
}

void addMasks(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-masks");
  const auto add = [&](const char* name, std::vector<std::string> rules, std::function<Scene(uint64_t, uint32_t)> make) {
    rules.emplace_back("R40");
    family.addRandom(name, "what a written mask, and that of the pipeline, leave", std::move(rules), ++seed, kPrimitives,
                     [make = std::move(make)](uint64_t s, uint32_t n) {
                       Scene scene = make(s, n);
                       giveMasks(scene, s);
                       return scene;
                     });
  };
  add("triangles-4x", {"R14", "R24"}, [](uint64_t s, uint32_t n) { return someTriangles(s, n, 4); });
  add("persp-4x", {"R14", "R24"}, [](uint64_t s, uint32_t n) { return someTriangles(s, n, 4, true); });
  add("cut-4x", {"R3", "R24"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 4);
    spreadOut(scene, 2);
    return scene;
  });
  add("shaded-4x", {"R14", "R19"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 4);
    scene.state.sampleShadingEnable = true;
    scene.state.minSampleShading = 1;
    return scene;
  });
  add("triangles-1x", {"R14"}, [](uint64_t s, uint32_t n) { return someTriangles(s, n, 1); });
  add("points-4x", {"R24", "R25"}, [](uint64_t s, uint32_t n) { return somePoints(s, n, 4); });
}

}  // namespace

void addRandomCuts(Entries& entries) {
  uint64_t seed = 6000;
  addClips(entries, seed);
  addDistances(entries, seed);
  addFacings(entries, seed);
  addScissors(entries, seed);
  addMasks(entries, seed);
}

}  // namespace rasterdiff::families
