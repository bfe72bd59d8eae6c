#include "rasterizer/rules.hpp"

#include <array>

namespace rasterdiff::rasterizer {
namespace {

constexpr std::array<std::string_view, 3> kProfiles{"reference", "lavapipe", "d3d11"};

// The driver compiles its vertex stage for the CPU it runs on: it fuses where the CPU has fused multiply-add.
bool cpuFusesMultiplyAdd() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

}  // namespace

Rules Rules::specification(const Limits& limits) {
  Rules rules;
  rules.name = "spec";
  rules.limits = limits;
  rules.open = true;
  return rules;
}

Result<Rules> Rules::profile(std::string_view name, const Limits& limits) {
  Rules rules;
  rules.name = name;
  rules.limits = limits;
  if (name == "reference") return rules;
  if (name == "lavapipe") {
    rules.choices.viewportArithmetic =
        cpuFusesMultiplyAdd() ? ViewportArithmetic::Float32Fma : ViewportArithmetic::Float32;
    rules.choices.snapOrigin = SnapOrigin::CentreAtOneSample;
    rules.choices.clipArithmetic = ClipArithmetic::Float32Linear;
    rules.choices.pointArithmetic = PointArithmetic::SnappedCentre;
    rules.choices.pointClip = PointClip::SidesIgnored;
    rules.choices.cutOutline = CutOutline::Flagged;
    rules.choices.cullPosition = CullPosition::AlsoFloat;
    rules.choices.cutFill = CutFill::Fan;
    rules.choices.drawingRegion = DrawingRegionRule::RoundedViewport;
    rules.choices.valuesOpen = true;
    rules.choices.lineArithmetic = LineArithmetic::Float32Corners;
    rules.choices.depthBiasUnit = DepthBiasUnit::TwoSteps;
    return rules;
  }
  // Direct3D 11.3, where it is stricter than Vulkan: vertices on a grid of 16.8 bits, nearest even, through which values
  // are interpolated too; points as two triangles around the snapped vertex; its own diamond; the smallest step of a fixed-point depth. Top-left ties, the larger component
  // of the slope, no bias on lines and points, and the first covered sample as centroid are the reference's answers.
  if (name == "d3d11") {
    rules.choices.subPixelBits = 8;
    rules.choices.pointArithmetic = PointArithmetic::SnappedCorners;
    rules.choices.diamondExit = DiamondExit::Direct3D11;
    rules.choices.depthBiasUnit = DepthBiasUnit::OneStepOfRange;
    rules.choices.planePositions = PlanePositions::Snapped;
    return rules;
  }
  return fail(ErrorCode::BadInput, "--rules", "there is no profile named \"" + std::string(name) + "\"",
              "profiles: spec, reference, lavapipe, d3d11, auto");
}

Rules Rules::forDriver(std::string_view driverName, const Limits& limits) {
  if (driverName == "llvmpipe") return *profile("lavapipe", limits);
  return specification(limits);
}

std::span<const std::string_view> profiles() { return kProfiles; }

}  // namespace rasterdiff::rasterizer
