#include "scene/supersample.hpp"

namespace rasterdiff {
namespace {

Viewport larger(Viewport v, float n) {
  return {v.x * n, v.y * n, v.width * n, v.height * n, v.minDepth, v.maxDepth};
}

void enlarge(std::optional<Rect2D>& scissor, uint32_t n) {
  if (!scissor) return;
  const auto factor = static_cast<int32_t>(n);
  *scissor = {scissor->x * factor, scissor->y * factor, scissor->width * n, scissor->height * n};
}

}  // namespace

Scene supersampled(const Scene& scene) {
  Scene large = scene;
  const uint32_t n = scene.target.supersample;
  const auto factor = static_cast<float>(n);
  large.target.supersample = 1;
  large.target.width *= n;
  large.target.height *= n;
  large.viewport = larger(scene.viewport, factor);
  enlarge(large.scissor, n);
  for (ViewportAndScissor& further : large.furtherViewports) {
    further.viewport = larger(further.viewport, factor);
    enlarge(further.scissor, n);
  }
  large.state.lineWidth *= factor;
  large.state.pointSize *= factor;
  large.state.depthBiasSlopeFactor *= factor;  // [vk:primsrast-depthbias-computation] the slope is per pixel
  if (large.state.stippledLineEnable) large.state.lineStippleFactor *= n;
  for (Draw& draw : large.draws) {
    for (float& size : draw.pointSizes) size *= factor;
  }
  return large;
}

Plane<float> boxAveraged(const Plane<float>& plane, uint32_t n) {
  if (n == 0) return {};
  Plane<float> mean(plane.width / n, plane.height / n, plane.samples, plane.components);
  const double area = static_cast<double>(n) * n;
  for (uint32_t y = 0; y < mean.height; ++y) {
    for (uint32_t x = 0; x < mean.width; ++x) {
      for (uint32_t s = 0; s < mean.samples; ++s) {
        for (uint32_t c = 0; c < mean.components; ++c) {
          double sum = 0;
          for (uint32_t j = 0; j < n; ++j) {
            for (uint32_t i = 0; i < n; ++i) sum += double{plane.at(x * n + i, y * n + j, s, c)};
          }
          mean.at(x, y, s, c) = static_cast<float>(sum / area);
        }
      }
    }
  }
  return mean;
}

}  // namespace rasterdiff
