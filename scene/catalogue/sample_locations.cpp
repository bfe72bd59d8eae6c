// Samples where the scene puts them: one table for all pixels, one for each pixel of a grid, and locations that a device
// has to clamp. [vk:primsrast-samplelocations]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

using Locations = std::vector<SampleLocationEXT>;

/// `sixteenths`: x and y by turns.
Locations at(const std::vector<int>& sixteenths) {
  Locations locations;
  for (size_t i = 0; i + 1 < sixteenths.size(); i += 2) {
    locations.push_back({static_cast<float>(sixteenths[i]) / 16, static_cast<float>(sixteenths[i + 1]) / 16});
  }
  return locations;
}

/// Every location another one of the 256 that there are: steps of a number that has no factor in common with 256.
Locations scattered(size_t count) {
  std::vector<int> sixteenths;
  for (size_t i = 0; i < count; ++i) {
    const int place = static_cast<int>((i * 103 + 37) % 256);
    sixteenths.insert(sixteenths.end(), {place % 16, place / 16});
  }
  return at(sixteenths);
}

/// Edges of many directions through sixteenths of a pixel: a fan around the middle.
Scene fan(uint32_t samples, uint32_t gridWidth, uint32_t gridHeight, Locations locations) {
  Scene scene = square(64, samples);
  scene.target.sampleLocations = SampleLocationsInfo{gridWidth, gridHeight, std::move(locations)};
  std::vector<Px> v;
  const Px rim[] = {{61.0625, 30.5}, {58.25, 51.1875}, {40.5, 60.9375}, {21.125, 58.5},  {3.5, 47.0625},
                    {5.8125, 22.25}, {18.5, 3.0625},   {33.375, 5.5},   {52.6875, 9.25}};
  for (size_t i = 0; i < std::size(rim); ++i) {
    v.insert(v.end(), {Px{31.5625, 33.1875}, rim[i], rim[(i + 1) % std::size(rim)]});
  }
  draw(scene, v);
  return scene;
}

}  // namespace

void addSampleLocations(Entries& entries) {
  Family family(entries, "sample-locations");
  const std::vector<std::string> rules{"R14", "R18"};
  family.add("corners-4x", "four samples in the corners of every pixel", rules,
             [] { return fan(4, 1, 1, at({0, 0, 15, 0, 0, 15, 15, 15})); });
  family.add("one-place-4x", "four samples in one place: all covered or none", rules,
             [] { return fan(4, 1, 1, at({3, 11, 3, 11, 3, 11, 3, 11})); });
  for (const uint32_t samples : {2u, 4u, 8u, 16u}) {
    family.add("scattered-" + std::to_string(samples) + "x", "another location for every sample", rules,
               [samples] { return fan(samples, 1, 1, scattered(samples)); });
  }
  family.add("columns-4x", "odd and even columns have tables of their own", rules,
             [] { return fan(4, 2, 1, scattered(8)); });
  family.add("rows-4x", "odd and even rows have tables of their own", rules, [] { return fan(4, 1, 2, scattered(8)); });
  family.add("grid-4x", "each pixel of four by two has a table of its own", rules,
             [] { return fan(4, 4, 2, scattered(32)); });
  family.add("grid-8x", "each pixel of two by two has a table of its own", rules,
             [] { return fan(8, 2, 2, scattered(32)); });
  family.add("beyond-4x", "locations outside of the pixel are clamped to the advertised range", rules, [] {
    return fan(4, 1, 1, {{-0.5F, 0.25F}, {1, 0.5F}, {0.25F, 1}, {1.5F, 1.5F}});
  });
  for (const Interpolation interpolation : {Interpolation::sample, Interpolation::centroid}) {
    const bool each = interpolation == Interpolation::sample;
    family.add(each ? "values-4x" : "centroid-4x", each ? "values at the samples' own locations" : "values where samples cover",
               {"R14", "R18", "R20", "R21"}, [interpolation] {
                 Scene scene = fan(4, 2, 2, scattered(16));
                 addVarying(scene, "v", interpolation, 2);
                 return scene;
               });
  }
}

}  // namespace rasterdiff::families
