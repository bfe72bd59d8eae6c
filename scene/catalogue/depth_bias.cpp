// Depth bias: its unit by format and binade, its slope, its clamp. [vk:primsrast-depthbias-computation]
#include <fmt/format.h>

#include <cmath>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene biased(DepthFormat format, float constant, float slope = 0, float clamp = 0) {
  Scene scene = square(64);
  useDepth(scene, CompareOp::ALWAYS);
  scene.target.depthFormat = format;
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = constant;
  scene.state.depthBiasSlopeFactor = slope;
  scene.state.depthBiasClamp = clamp;
  return scene;
}

/// A level square in each binade of z from 1/2 to 2^-12: at its start, middle and end.
Scene binades(DepthFormat format, float constant) {
  Scene scene = biased(format, constant);
  constexpr double kMantissa[3] = {1, 1.5, 1.99999};
  for (int i = 0; i < 36; ++i) {
    const double x = 10.0 * (i % 6) + 2, y = 10.0 * (i / 6) + 2;
    draw(scene, rectangle(x, y, x + 8, y + 8, std::ldexp(kMantissa[i % 3], -1 - i / 3)));
  }
  return scene;
}

/// Triangles of several slopes, steeper in x, in y, and alike in both; from flat to a fifth of the range a pixel.
Scene slopes(DepthFormat format, float slope, float clamp) {
  Scene scene = biased(format, 0, slope, clamp);
  for (int i = 0; i < 9; ++i) {
    const double x = 20.0 * (i % 3) + 3, y = 20.0 * (i / 3) + 3;
    const double steep = std::ldexp(0.1, -3 * (i / 3));
    const double dx = i % 3 == 0 ? steep : i % 3 == 1 ? 0 : 0.75 * steep, dy = i % 3 == 0 ? 0 : i % 3 == 1 ? steep : -0.75 * steep;
    draw(scene, {{x, y, 0.375}, {x + 16, y + 1, 0.375 + dx + dy / 16}, {x + 1, y + 16, 0.375 + dx / 16 + dy}});
  }
  return scene;
}

/// Level squares that pass, or not, against what the attachment holds: `steps` float32 steps beside the biased depth.
Scene besideClear(int steps) {
  Scene scene = biased(DepthFormat::D32_SFLOAT, 1);
  scene.state.depthCompareOp = CompareOp::LESS;
  scene.target.depthClearValue = 0.75f + static_cast<float>(1 + steps) * 0x1p-24f;
  draw(scene, rectangle(4, 4, 60, 60, 0.75));
  return scene;
}

}  // namespace

void addDepthBias(Entries& entries) {
  Family family(entries, "depth-bias");
  using enum DepthFormat;
  const std::vector<std::string> unit{"R36", "R38"}, slope{"R35", "R38"};
  struct Case {
    DepthFormat format;
    const char* name;
    const char* repository;
    int number;
  };
  for (const Case& c : {Case{D16_UNORM, "d16", "HansKristian-Work/vkd3d-proton", 2056},
                        Case{X8_D24_UNORM_PACK32, "x8d24", "doitsujin/dxvk", 2892},
                        Case{D24_UNORM_S8_UINT, "d24s8", "doitsujin/dxvk", 2931},
                        Case{D32_SFLOAT, "d32f", "doitsujin/dxvk", 3501}}) {
    family.add(
        fmt::format("{}-one-unit", c.name), "one unit in each binade of z: constant for fixed point, relative for floats",
        unit, [c] { return binades(c.format, 1); }, issue(c.repository, c.number));
    family.add(fmt::format("{}-minus-17", c.name), "seventeen units nearer", unit, [c] { return binades(c.format, -17); });
  }
  family.add("just-below", "one step below what the attachment holds: LESS passes", unit, [] { return besideClear(1); });
  family.add("equal", "the biased depth is what the attachment holds: LESS fails", unit, [] { return besideClear(0); });
  family.add("just-above", "one step above what the attachment holds: LESS fails", unit, [] { return besideClear(-1); });
  family.add("slope", "the slope of triangles in x, in y and diagonally", slope,
             [] { return slopes(D32_SFLOAT, 1, 0); });
  family.add("slope-negative", "a negative slope factor brings nearer", slope,
             [] { return slopes(D32_SFLOAT, -2.5f, 0); });
  family.add("clamp", "a positive clamp bounds from above", slope, [] { return slopes(D32_SFLOAT, 1, 0.001f); });
  family.add("clamp-negative", "a negative clamp bounds from below", slope,
             [] { return slopes(D32_SFLOAT, -1, -0.001f); });
  family.add("slope-d16", "slope and constant together, rounded to fixed point", {"R35", "R36", "R38"}, [] {
    Scene scene = slopes(D16_UNORM, 1, 0);
    scene.state.depthBiasConstantFactor = 2;
    return scene;
  });
  family.add("out-of-range", "biased beyond the far plane and clamped", {"R36", "R38"}, [] {
    Scene scene = biased(D32_SFLOAT, 1e6f);
    scene.state.depthClampEnable = true;
    draw(scene, rectangle(4, 4, 60, 30, 0.99));
    draw(scene, rectangle(4, 34, 60, 60, 0.25));
    return scene;
  });
  family.add("wireframe", "the edges of triangles are biased like the triangles", {"R34", "R37", "R38"}, [] {
    Scene scene = biased(D32_SFLOAT, 1000);
    scene.state.polygonMode = PolygonMode::LINE;
    draw(scene, rectangle(4.5, 4.5, 60.5, 30.5, 0.25));
    draw(scene, rectangle(4.5, 34.5, 60.5, 60.5, 0.75));
    return scene;
  });
}

}  // namespace rasterdiff::families
