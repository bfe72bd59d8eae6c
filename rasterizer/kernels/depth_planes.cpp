#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/depth_planes.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>

#include "hwy/highway.h"
#include "rasterizer/fragment/plane_formula.hpp"
#include "rasterizer/kernels/depth_planes.hpp"
#include "rasterizer/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

#include "rasterizer/fragment/plane_formula.inc"

void DepthPlanes(std::span<const DepthCorners> corners, std::span<const CornerErrors> errors, std::span<const uint32_t> numbers,
                 std::span<LinearFunction> planes) {
  const D d;
  constexpr size_t kNumbers = 11, kPlane = 10;  // of a triangle; of its plane
  alignas(64) double in[kNumbers][kLanes] = {}, out[kPlane][kLanes];
  for (size_t first = 0; first < numbers.size(); first += kLanes) {
    const size_t count = std::min(kLanes, numbers.size() - first);
    for (size_t k = 0; k < count; ++k) {
      const DepthCorners& c = corners[numbers[first + k] - 1];
      const CornerErrors& e = errors[numbers[first + k] - 1];
      for (size_t i = 0; i < 3; ++i) in[i][k] = c.x[i], in[3 + i][k] = c.y[i], in[6 + i][k] = c.z[i];
      in[9][k] = e.deviation, in[10][k] = e.inputError;
    }
    const auto at = [&](size_t n) { return Lanes(hn::Load(d, in[n])); };
    const TriangleMeasures<Lanes> t({at(0), at(1), at(2)}, {at(3), at(4), at(5)}, at(9));
    const PlaneOf<Lanes> p = planeThrough<Lanes>(t, {at(6), at(7), at(8)}, at(10), Lanes(0), Lanes(1));
    const Lanes* const parts[kPlane] = {&p.value, &p.dx, &p.dy, &p.x0, &p.y0, &p.constantRadius, &p.radiusPerX, &p.radiusPerY, &p.farX, &p.farY};
    for (size_t n = 0; n < kPlane; ++n) hn::Store(parts[n]->v, d, out[n]);
    for (size_t k = 0; k < count; ++k) {
      planes[first + k] = {out[0][k], out[1][k], out[2][k], out[3][k], out[4][k], out[5][k], out[6][k], out[7][k], out[8][k], out[9][k]};
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(DepthPlanes);

void depthPlanes(std::span<const DepthCorners> corners, std::span<const CornerErrors> errors, std::span<const uint32_t> numbers,
                 std::span<LinearFunction> planes) {
  HWY_DYNAMIC_DISPATCH(DepthPlanes)(corners, errors, numbers, planes);
}

}  // namespace rasterdiff::rasterizer
#endif
