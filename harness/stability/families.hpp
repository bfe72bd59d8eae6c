// Hard cases with a dial: each family is one scene that gets harder as its dial grows. What is measured on them is left
// to measure.hpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace rasterdiff::harness::stability {

struct Family {
  std::string name;             ///< "sliver"
  std::string what;             ///< one sentence
  std::string dial;             ///< what the dial is, with its unit
  std::vector<double> values;   ///< of the dial, > 0, growing
  std::function<Scene(double)> make;
};

/// All families in a fixed order.
[[nodiscard]] const std::vector<Family>& families();

// Where geometry is hard, and where values are.
[[nodiscard]] std::vector<Family> geometryFamilies();
[[nodiscard]] std::vector<Family> valueFamilies();

}  // namespace rasterdiff::harness::stability
