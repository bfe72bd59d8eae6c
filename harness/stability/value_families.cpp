// Families where it is hard to evaluate values and depth.
#include <cmath>

#include "harness/stability/families.hpp"
#include "harness/stability/hard_scene.hpp"

namespace rasterdiff::harness::stability {
namespace {

Scene onScreen(const std::array<float, 3>& values, const std::array<double, 3>& w, const std::array<double, 3>& z = {0.5, 0.5, 0.5}) {
  Scene scene = hardTarget(64, 64);
  addTriangle(scene, {{{2.3, 3.1, values[0], w[0], z[0]}, {61.7, 8.4, values[1], w[1], z[1]}, {12.6, 60.2, values[2], w[2], z[2]}}});
  return scene;
}

Scene wRatio(double dial) { return onScreen({0, 1, 2}, {1, 1, dial}); }

Scene wToZero(double dial) {
  Scene scene = hardTarget(64, 64);
  const auto w = static_cast<float>(1 / dial);
  addClipTriangle(scene, {ClipPosition{0, 0, 0, w}, {0.9F, -0.8F, 0.5F, 1}, {-0.7F, 0.9F, 0.5F, 1}}, {0, 1, 2});
  return scene;
}

Scene depthRange(double dial) {
  const std::array<double, 3> distance{1, dial, std::sqrt(dial)};
  std::array<double, 3> z{};
  for (size_t i = 0; i < 3; ++i) z[i] = dial / (dial - 1) * (1 - 1 / distance[i]);
  Scene scene = onScreen({0, 1, 2}, distance, z);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::LESS_OR_EQUAL;
  return scene;
}

Scene magnitude(double dial) { return onScreen({static_cast<float>(1 / dial), 1, static_cast<float>(dial)}, {1, 2, 4}); }

Scene cancelling(double dial) { return onScreen({static_cast<float>(dial), static_cast<float>(-dial), 1}, {1, 2, 4}); }

Scene constant(double dial) { return onScreen({0.7F, 0.7F, 0.7F}, {1, dial, 1 / dial}); }

}  // namespace

std::vector<Family> valueFamilies() {
  return {
      {"w-ratio", "one corner is farther away than the others", "ratio of w", decades(0, 7), wRatio},
      {"w-to-zero", "one corner comes up to the eye", "1 / w", decades(0, 7), wToZero},
      {"depth-range", "depth and a value on a floor from the near to the far plane", "far / near", decades(1, 7), depthRange},
      {"magnitude", "values of 1 / m, 1 and m at the corners", "m", {1, 1e6, 1e12, 1e18, 1e24, 1e30}, magnitude},
      {"cancelling", "values of m, -m and 1 at the corners", "m", decades(0, 7), cancelling},
      {"constant", "the same value at all corners, whose w are 1, m and 1 / m", "m", decades(0, 7), constant},
  };
}

}  // namespace rasterdiff::harness::stability
