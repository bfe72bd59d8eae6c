// The grids that generated vertices lie on. Coarse grids make ties; `Free` takes any float32.
#pragma once

#include <cmath>
#include <cstdint>

namespace rasterdiff {

enum class Grid : uint8_t { Half, Sixteenth, TwoHundredFiftySixth, Free };

/// Steps a pixel; 0 for Free.
[[nodiscard]] constexpr double stepsPerPixel(Grid grid) {
  switch (grid) {
    case Grid::Half:
      return 2;
    case Grid::Sixteenth:
      return 16;
    case Grid::TwoHundredFiftySixth:
      return 256;
    case Grid::Free:
      break;
  }
  return 0;
}

/// The nearest point of the grid, in pixels.
[[nodiscard]] inline double snapToGrid(double pixels, Grid grid) {
  const double steps = stepsPerPixel(grid);
  return steps == 0 ? pixels : std::round(pixels * steps) / steps;
}

}  // namespace rasterdiff
