// Depth: interpolation, comparison and writing, in drawing order. [vk:fragops-depth]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// A slope, an equal copy of its left half, and a level square in front of one part and behind the other.
Scene layers(CompareOp op, bool write, float clear, uint32_t samples = 1) {
  Scene scene = square(32, samples);
  useDepth(scene, op, write, clear);
  const std::vector<Px> slope{{2.5, 2.5, 0.125}, {30.5, 2.5, 0.875},  {30.5, 30.5, 0.875},
                              {2.5, 2.5, 0.125}, {30.5, 30.5, 0.875}, {2.5, 30.5, 0.125}};
  draw(scene, slope);
  draw(scene, rectangle(6, 6, 26, 26, 0.5));
  draw(scene, slope);
  return scene;
}

Scene crossing(uint32_t samples) {
  Scene scene = square(64, samples);
  useDepth(scene);
  draw(scene, {{4, 6, 0.125}, {60, 12, 0.875}, {20, 60, 0.5}});
  draw(scene, {{58, 4, 0.125}, {6, 30, 0.75}, {50, 58, 0.375}});
  draw(scene, {{10, 50, 0.9375}, {30, 2, 0.0625}, {62, 40, 0.5}});
  return scene;
}

struct Op {
  CompareOp op;
  const char* name;
  float clear;  ///< such that some samples pass and some fail
};

}  // namespace

void addDepth(Entries& entries) {
  Family family(entries, "depth");
  const std::vector<std::string> rules{"R22", "R38"};
  for (const Op& o : {Op{CompareOp::NEVER, "never", 1}, Op{CompareOp::LESS, "less", 0.75f},
                      Op{CompareOp::EQUAL, "equal", 0.5f}, Op{CompareOp::LESS_OR_EQUAL, "less-or-equal", 1},
                      Op{CompareOp::GREATER, "greater", 0.25f}, Op{CompareOp::NOT_EQUAL, "not-equal", 0.5f},
                      Op{CompareOp::GREATER_OR_EQUAL, "greater-or-equal", 0}, Op{CompareOp::ALWAYS, "always", 1}}) {
    family.add(o.name, std::string("three layers compared with ") + o.name, rules,
               [o] { return layers(o.op, true, o.clear); });
  }
  family.add("less-4x", "each sample has its own depth", {"R17", "R22", "R38"},
             [] { return layers(CompareOp::LESS, true, 1, 4); });
  family.add("no-write", "a test without writing compares with the clear value", rules,
             [] { return layers(CompareOp::LESS, false, 0.5f); });
  family.add("write-without-test", "without the test depth is not written either", rules, [] {
    Scene scene = layers(CompareOp::LESS, true, 0.25f);
    scene.state.depthTestEnable = false;
    return scene;
  });
  family.add("crossing-1x", "planes that go through one another", rules, [] { return crossing(1); });
  family.add("crossing-4x", "planes that go through one another, at four samples", {"R17", "R22", "R38"},
             [] { return crossing(4); });
  family.add(
      "same-twice", "the same geometry again with LESS_OR_EQUAL passes everywhere", {"R38", "R49"},
      [] {
        Scene scene = square(64);
        useDepth(scene, CompareOp::LESS_OR_EQUAL);
        const std::vector<Px> v{{3.3, 5.1, 0.21},     {60.7, 9.9, 0.83, 2}, {21.4, 58.2, 0.47, 0.5},
                                {60.7, 9.9, 0.83, 2}, {55.5, 61.1, 0.66},   {21.4, 58.2, 0.47, 0.5}};
        draw(scene, v);
        draw(scene, v);
        return scene;
      },
      "https://github.com/hrydgard/ppsspp/issues/18357");
  family.add("not-equal-second-pass", "the same geometry again with NOT_EQUAL passes nowhere", {"R38", "R49"}, [] {
    Scene scene = square(64, 4);
    useDepth(scene, CompareOp::NOT_EQUAL);
    const std::vector<Px> v{{3.3, 5.1, 0.21}, {60.7, 9.9, 0.83}, {21.4, 58.2, 0.47}};
    draw(scene, v);
    draw(scene, v);
    return scene;
  });
  family.add("perspective", "depth is linear on the screen although w varies", {"R22"}, [] {
    Scene scene = square(64);
    useDepth(scene);
    draw(scene, {{4, 6, 0.125, 0.25}, {60, 12, 0.875, 8}, {20, 60, 0.5, 1}});
    return scene;
  });
  family.add("far-range", "depths next to 1 as a distant near plane makes them", {"R22"}, [] {
    Scene scene = square(64);
    useDepth(scene);
    draw(scene, {{4, 6, 0.99990}, {60, 12, 0.99999}, {20, 60, 0.99995}});
    draw(scene, {{6, 60, 0.99996}, {62, 40, 0.99992}, {10, 4, 0.99997}});
    return scene;
  });
  family.add("at-limits", "depths of exactly 0 and 1 are inside and are stored", rules, [] {
    Scene scene = square(32);
    useDepth(scene, CompareOp::LESS_OR_EQUAL);
    draw(scene, rectangle(2, 2, 16, 30, 0));
    draw(scene, rectangle(16, 2, 30, 30, 1));
    return scene;
  });
  family.add("steep", "nearly edge-on: depth changes by half the range a pixel", {"R22"}, [] {
    Scene scene = square(32);
    useDepth(scene);
    draw(scene, {{4, 4, 0.125}, {6, 4, 0.875}, {5, 28, 0.125}, {12, 4, 0}, {12.25, 28, 1}, {13.5, 16, 0.5}});
    return scene;
  });
}

}  // namespace rasterdiff::families
