// Where the samples of a pixel are, one tiny triangle for each. [vk:primsrast-multisampling]
#include "scene/catalogue/build.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::families {
namespace {

/// Pixel (s, row) gets a triangle around where sample s has to be: 1/16 pixel to each side, no other sample inside.
Scene oneEach(uint32_t samples) {
  Scene scene = square(16, samples);
  std::vector<Px> v;
  const auto locations = standardSampleLocations(samples);
  for (size_t s = 0; s < locations.size(); ++s) {
    const double x = static_cast<double>(s) + locations[s].x / 16.0, y = 4 + locations[s].y / 16.0;
    v.insert(v.end(), {{x - 0.0625, y - 0.03125}, {x + 0.0625, y - 0.03125}, {x, y + 0.0625}});
  }
  draw(scene, v);
  return scene;
}

/// In row y every pixel is covered up to y/16 from the left; in the lower half from the top.
Scene sweep(uint32_t samples) {
  Scene scene = square(32, samples);
  std::vector<Px> v;
  for (int i = 0; i <= 16; ++i) {
    const double edge = i / 16.0;
    for (const Px& p : rectangle(i + 0.0, 2, i + edge, 4)) v.push_back(p);
    for (const Px& p : rectangle(i + 0.0, 8, i + 1.0, 8 + edge)) v.push_back(p);
  }
  draw(scene, v);
  return scene;
}

}  // namespace

void addSamples(Entries& entries) {
  Family family(entries, "samples");
  for (uint32_t samples : {1u, 2u, 4u, 8u, 16u}) {
    const std::string n = std::to_string(samples);
    family.add("locations-" + n + "x", "a tiny triangle at each standard location of " + n, {"R16", "R17"},
               [samples] { return oneEach(samples); });
  }
  for (uint32_t samples : {1u, 4u}) {
    const std::string n = std::to_string(samples);
    family.add("sweep-" + n + "x", "edges in steps of 1/16 pixel find every sample of " + n + " as a tie",
               {"R14", "R15", "R17"}, [samples] { return sweep(samples); });
  }
  family.add(
      "centre-uncovered", "pixels with some samples covered but not the centre still have values",
      {"R17", "R20", "R21"},
      [] {
        Scene scene = square(16, 4);
        draw(scene, {{2, 2}, {13.5, 2.25}, {2.25, 13.5}, {14, 14}, {13.75, 3.5}, {3.5, 13.75}});
        addVarying(scene, "value", Interpolation::smooth, 2);
        return scene;
      },
      "https://github.com/gpuweb/gpuweb/issues/4777");
}

}  // namespace rasterdiff::families
