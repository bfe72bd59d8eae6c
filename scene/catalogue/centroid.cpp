// Centroid inputs in pixels of every coverage mask. [vk:shaders-interpolation-decorations]
#include <fmt/format.h>

#include <cmath>

#include "scene/catalogue/build.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::families {
namespace {

Px sampleOf(uint32_t s, double x, double y) {
  const SampleLocation location = standardSampleLocations(4)[s];
  return {x + location.x / 16.0, y + location.y / 16.0};
}

/// A triangle that covers just the samples of `mask` in pixel (x, y) of four samples.
std::vector<Px> covering(uint32_t mask, double x, double y) {
  std::vector<Px> in;
  for (uint32_t s = 0; s < 4; ++s) {
    if (mask >> s & 1) in.push_back(sampleOf(s, x, y));
  }
  if (in.size() == 1) {
    const Px& p = in[0];
    return {{p.x - 0.0625, p.y - 0.03125}, {p.x + 0.0625, p.y - 0.03125}, {p.x, p.y + 0.0625}};
  }
  if (in.size() == 2) {  // a wedge along both
    const double dx = in[1].x - in[0].x, dy = in[1].y - in[0].y;
    const Px back{in[0].x - 0.125 * dx, in[0].y - 0.125 * dy};
    return {{back.x - 0.125 * dy, back.y + 0.125 * dx}, {back.x + 0.125 * dy, back.y - 0.125 * dx},
            {in[1].x + 0.25 * dx, in[1].y + 0.25 * dy}};
  }
  if (in.size() == 3) {
    const double cx = (in[0].x + in[1].x + in[2].x) / 3, cy = (in[0].y + in[1].y + in[2].y) / 3;
    for (Px& p : in) p = {cx + 1.1875 * (p.x - cx), cy + 1.1875 * (p.y - cy)};
    return in;
  }
  return {{x - 1, y - 1}, {x + 3, y - 1}, {x - 1, y + 3}};
}

/// All masks but the empty one, a pixel of 4 × 4 for each; all whole ones are last.
Scene allMasks(bool perspective) {
  Scene scene = square(16, 4);
  std::vector<Px> v;
  for (uint32_t mask = 1; mask < 16; ++mask) {
    const uint32_t cell = mask - 1;
    for (Px p : covering(mask, 4 * (cell % 4) + 1, 4 * std::floor(cell / 4.0) + 1)) {
      p.w = perspective ? 1 + static_cast<double>(v.size() % 3) / 2 : 1;
      v.push_back(p);
    }
  }
  draw(scene, v);
  return scene;
}

}  // namespace

void addCentroid(Entries& entries) {
  Family family(entries, "centroid");
  const std::vector<std::string> rules{"R20", "R21"};
  family.add(
      "all-masks", "every mask of four samples: where is a centroid input evaluated?", rules,
      [] {
        Scene scene = allMasks(false);
        addVarying(scene, "centroid", Interpolation::centroid, 2);
        addVarying(scene, "smooth", Interpolation::smooth, 2);
        return scene;
      },
      issue("gpuweb/gpuweb", 4777));
  family.add(
      "all-masks-frag-coord", "FragCoord stays at the centre although inputs are centroid", {"R20", "R23", "R24"},
      [] {
        Scene scene = allMasks(false);
        addVarying(scene, "centroid", Interpolation::centroid, 1);
        scene.builtIns = {BuiltIn::FragCoord, BuiltIn::SampleMask};
        return scene;
      },
      issue("gpuweb/gpuweb", 4854));
  family.add(
      "all-masks-perspective", "every mask, in perspective", rules,
      [] {
        Scene scene = allMasks(true);
        addVarying(scene, "centroid", Interpolation::centroid, 2);
        return scene;
      },
      issue("GPUOpen-Drivers/llpc", 73));
  family.add("edge", "a centroid value along an edge never leaves the range of the vertices", rules, [] {
    Scene scene = square(32, 4);
    draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
    addVarying(scene, "centroid", Interpolation::centroid, 2);
    return scene;
  });
  family.add("one-sample", "with one sample a centroid input is evaluated at the centre", rules, [] {
    Scene scene = square(32);
    draw(scene, {{3.25, 2.5}, {28.75, 9, 0.5, 2}, {11, 29.125}});
    addVarying(scene, "centroid", Interpolation::centroid, 2);
    return scene;
  });
  family.add("eight-samples", "centroid values at eight samples", rules, [] {
    Scene scene = square(16, 8);
    draw(scene, {{1.25, 2.5}, {14.75, 4}, {6, 14.125}});
    addVarying(scene, "centroid", Interpolation::centroid, 2);
    return scene;
  });
}

}  // namespace rasterdiff::families
