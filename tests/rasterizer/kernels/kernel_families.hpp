// Families of hard triangles for the kernel tests: each a name and a generator of one triangle.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::rasterizer::testing {

struct Family {
  std::string name;
  std::function<SnappedTriangle(Prng&)> make;
};

/// For a target of width × height pixels.
std::vector<Family> hardFamilies(int32_t width, int32_t height);

}  // namespace rasterdiff::rasterizer::testing
