// Where vertices go so that outcomes hang on them: on samples, pixel corners and edges, borders of tiles and of the
// target, in line with earlier vertices, and one grid step beside all of these.
#pragma once

#include <vector>

#include "scene/generators/prng.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::hunt {

struct Place {
  double x = 0, y = 0;  ///< pixels
};

class Places {
 public:
  /// `steps` a pixel: 2, 4, 16 or 256; 0 for any float32.
  Places(Prng& random, const Target& target, double steps) : random_(random), target_(target), steps_(steps) {}

  [[nodiscard]] Place next();
  /// The steps of a grid, coarse ones more often.
  [[nodiscard]] static double randomSteps(Prng& random);

 private:
  [[nodiscard]] Place choose();
  [[nodiscard]] Place anywhere();
  [[nodiscard]] Place onSample();
  [[nodiscard]] Place onBorder();
  [[nodiscard]] Place inLine();
  [[nodiscard]] double snapped(double v) const;

  Prng& random_;
  Target target_;
  double steps_;
  std::vector<Place> earlier_;
};

}  // namespace rasterdiff::harness::hunt
