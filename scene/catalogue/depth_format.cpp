// Depth formats: rounding to fixed point, and what a comparison sees of it. [vk:fundamentals-fpfixedconv]
#include <fmt/format.h>

#include <cmath>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

struct Format {
  DepthFormat format;
  const char* name;
  int bits;  ///< of a fixed-point value; 0: float32
};

/// Level squares at depths around whole and half steps of the format, from 0 to 1.
Scene steps(const Format& f) {
  Scene scene = square(64);
  useDepth(scene, CompareOp::ALWAYS);
  scene.target.depthFormat = f.format;
  const double last = f.bits == 0 ? 65535.0 : std::ldexp(1.0, f.bits) - 1;
  for (int i = 0; i < 64; ++i) {
    const double step = std::floor(last * (i / 8) / 7) + (i % 8 - 4) / 4.0;
    const double z = std::min(std::max(step / last, 0.0), 1.0);
    draw(scene, rectangle(8.0 * (i % 8), 8.0 * (i / 8), 8.0 * (i % 8) + 7, 8.0 * (i / 8) + 7, z));
  }
  return scene;
}

Scene slope(const Format& f, CompareOp op) {
  Scene scene = square(64, 4);
  useDepth(scene, op);
  scene.target.depthFormat = f.format;
  const double step = f.bits == 0 ? 0x1p-24 : 1 / (std::ldexp(1.0, f.bits) - 1);
  draw(scene, {{4, 4, 0.5}, {60, 6, 0.5 + 12 * step}, {20, 60, 0.5 + 5 * step}});
  draw(scene, {{60, 60, 0.5 + 6 * step}, {6, 50, 0.5 + 5 * step}, {50, 4, 0.5 + 7 * step}});
  return scene;
}

constexpr Format kFormats[] = {{DepthFormat::D16_UNORM, "d16", 16},
                               {DepthFormat::X8_D24_UNORM_PACK32, "x8d24", 24},
                               {DepthFormat::D24_UNORM_S8_UINT, "d24s8", 24},
                               {DepthFormat::D32_SFLOAT, "d32f", 0},
                               {DepthFormat::D32_SFLOAT_S8_UINT, "d32fs8", 0}};

}  // namespace

void addDepthFormat(Entries& entries) {
  Family family(entries, "depth-format");
  for (const Format& f : kFormats) {
    family.add(fmt::format("{}-steps", f.name), "depths on and between the values that the format can hold", {"R38"},
               [f] { return steps(f); });
    family.add(fmt::format("{}-slope", f.name), "two planes that differ by a few steps of the format", {"R22", "R38"},
               [f] { return slope(f, CompareOp::LESS); });
  }
  family.add("d16-clear", "the clear value is rounded as depths are", {"R38"}, [] {
    Scene scene = slope(kFormats[0], CompareOp::NOT_EQUAL);
    scene.target.depthClearValue = 0.50001f;
    return scene;
  });
}

}  // namespace rasterdiff::families
