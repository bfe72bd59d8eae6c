#include "rasterizer/legal/legal_rules.hpp"

#include <fmt/format.h>

#include <array>

#include "scene/generators/prng.hpp"

namespace rasterdiff::rasterizer {
namespace {

template <class T, size_t n>
T oneOf(Prng& random, const std::array<T, n>& answers) {
  return answers[random.below(n)];
}

Limits randomDevice(Prng& random) {
  Limits limits;
  limits.subPixelPrecisionBits = static_cast<uint32_t>(random.between(4, 8));
  limits.viewportSubPixelBits = random.chance(50) ? 8 : 0;
  limits.framebufferSampleCounts = 0x1F;
  limits.strictLines = random.chance(50);
  limits.stippledRectangularLines = limits.stippledBresenhamLines = true;
  limits.lineWidthMax = 64;
  limits.lineWidthGranularity = oneOf(random, std::array{0.0F, 0.125F, 1.0F});
  limits.pointSizeMin = oneOf(random, std::array{0.0F, 1.0F});
  limits.pointSizeMax = 256;
  limits.pointSizeGranularity = oneOf(random, std::array{0.0F, 0.125F, 1.0F});
  if (random.chance(50)) limits.pointClippingBehavior = PointClippingBehavior::USER_CLIP_PLANES_ONLY;
  return limits;
}

Choices randomChoices(Prng& random, const Limits& limits) {
  Choices choices;
  choices.viewportArithmetic =
      oneOf(random, std::array{ViewportArithmetic::Exact, ViewportArithmetic::Float32, ViewportArithmetic::Float32Fma});
  choices.snapRounding = static_cast<SnapRounding>(random.below(8));
  choices.snapOrigin = static_cast<SnapOrigin>(random.below(4));
  choices.tieOwner =
      oneOf(random, std::array{TieOwner::TopLeft, TieOwner::TopRight, TieOwner::BottomLeft, TieOwner::BottomRight});
  // With the other two answers no shift of the samples explains who owns what: a vertex of a mesh that lies on a sample
  // would own it twice, or not at all. [vk:primsrast-polygons-basic]
  choices.slantedTies = oneOf(random, std::array{SlantedTies::LikeVertical, SlantedTies::LikeHorizontal});
  choices.clipArithmetic =
      oneOf(random, std::array{ClipArithmetic::Exact, ClipArithmetic::Float32Linear, ClipArithmetic::Float32Weighted});
  choices.cutFill = oneOf(random, std::array{CutFill::Polygon, CutFill::Spans});
  // Points are never drawn smaller than a pixel around a snapped vertex: legal only where no smaller size is offered.
  const bool wholePixels = limits.pointSizeMin >= 1;
  if (wholePixels && random.chance(50)) choices.pointArithmetic = PointArithmetic::SnappedCentre;
  choices.diamondExit = oneOf(random, std::array{DiamondExit::Vulkan, DiamondExit::Direct3D11});
  choices.depthBiasUnit = oneOf(random, std::array{DepthBiasUnit::OneStep, DepthBiasUnit::TwoSteps});
  return choices;
}

Variation randomVariation(Prng& random, const Limits& limits) {
  Variation v;
  v.arithmetic = oneOf(random, std::array{Variation::Arithmetic::PlaneAtOrigin, Variation::Arithmetic::PlaneAtVertex,
                                          Variation::Arithmetic::Barycentric});
  v.snappedCorners = random.chance(50);
  v.uncutCorners = random.chance(33);
  v.reciprocal = random.chance(50);
  v.attributeX = static_cast<float>(random.between(-8, 8)) / 16;
  v.attributeY = static_cast<float>(random.between(-8, 8)) / 16;
  v.attributesAtSamples = random.chance(33);
  v.centroid = oneOf(random, std::array{Variation::Centroid::CentreOrFirst, Variation::Centroid::Last, Variation::Centroid::Mean});
  v.offset = oneOf(random, std::array{Variation::Offset::Unrounded, Variation::Offset::Down, Variation::Offset::Up});
  v.biasSlope = oneOf(random, std::array{0.0, 0.5, 1.0});
  v.biasUnit = random.between(1.0, 2.0);
  v.biasesLines = random.chance(50);
  v.ditheredAlpha = random.chance(50);
  v.linesUncut = random.chance(50);
  v.bresenhamByDefault = random.chance(50);
  v.roundsViewport = random.chance(50);
  if (random.chance(33)) v.gridBits = static_cast<uint32_t>(random.between(static_cast<int32_t>(limits.subPixelPrecisionBits), 8));
  return v;
}

}  // namespace

Rules legalRules(uint64_t seed) {
  Prng random(seed);
  Rules rules;
  rules.name = fmt::format("legal:{}", seed);
  rules.limits = randomDevice(random);
  rules.choices = randomChoices(random, rules.limits);
  rules.variation = randomVariation(random, rules.limits);
  return rules;
}

std::string describe(const Rules& rules) {
  constexpr std::array kViewport{"exact", "float32", "fused float32"};
  constexpr std::array kSnap{"nearest even", "nearest up", "floor", "toward zero",
                             "nearest down", "nearest away", "nearest toward zero", "ceiling"};
  constexpr std::array kOwner{"top-left", "top-right", "bottom-left", "bottom-right"};
  constexpr std::array kArithmetic{"planes at the origin", "planes at a vertex", "barycentric weights"};
  const Choices& c = rules.choices;
  const Variation v = rules.variation.value_or(Variation{});
  return fmt::format("{} viewport; {} of {} subpixel bits, {}; ties {}; {} clipping; values by {} through {}{} corners, at "
                     "({}, {}){}; m {}",
                     kViewport[static_cast<size_t>(c.viewportArithmetic)], v.gridBits == 0 ? rules.limits.subPixelPrecisionBits : v.gridBits,
                     rules.limits.subPixelPrecisionBits, kSnap[static_cast<size_t>(c.snapRounding)],
                     kOwner[static_cast<size_t>(c.tieOwner)], c.clipArithmetic == ClipArithmetic::Exact ? "exact" : "float32",
                     kArithmetic[static_cast<size_t>(v.arithmetic)], v.uncutCorners ? "uncut " : "", v.snappedCorners ? "snapped" : "unsnapped", v.attributeX,
                     v.attributeY, v.attributesAtSamples ? " or at samples" : "", v.biasSlope);
}

}  // namespace rasterdiff::rasterizer
