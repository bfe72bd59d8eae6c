#include "rasterizer/snap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rasterizer/exact_sign.hpp"

namespace rasterdiff::rasterizer {
namespace {

// NaN goes to the far end: it is no number that could become an integer.
double clampToGuardBand(double pixels) { return pixels > -kGuardBand ? std::min(pixels, kGuardBand) : -kGuardBand; }

int32_t toSubpixels(double gridValue, int bits) {
  return static_cast<int32_t>(gridValue) * (1 << (kSubpixelBits - bits));
}

double roundTo(double gridValue, SnapRounding rounding) {
  switch (rounding) {
    case SnapRounding::NearestEven: return std::nearbyint(gridValue);
    case SnapRounding::NearestUp: return std::floor(gridValue + 0.5);
    case SnapRounding::Floor: return std::floor(gridValue);
    case SnapRounding::TowardZero: return std::trunc(gridValue);
    case SnapRounding::NearestDown: return std::ceil(gridValue - 0.5);
    case SnapRounding::NearestAway: return gridValue < 0 ? std::ceil(gridValue - 0.5) : std::floor(gridValue + 0.5);
    case SnapRounding::NearestTowardZero: return gridValue < 0 ? std::floor(gridValue + 0.5) : std::ceil(gridValue - 0.5);
    case SnapRounding::Ceiling: return std::ceil(gridValue);
  }
  return gridValue;
}

// Sign of (x / w · scale + offset) · 2^bits - halves / 2, exactly; times w first, so that only products are needed.
int signAgainst(float coordinate, float w, const ViewportAxis& axis, int bits, double halves) {
  const double twiceUnit = std::ldexp(2.0, bits);
  std::array<double, 8> terms{};
  twoProduct(double{coordinate}, axis.scale * twiceUnit, terms[0], terms[1]);
  twoProduct(axis.origin * twiceUnit, w, terms[2], terms[3]);
  twoProduct(axis.centre * twiceUnit, w, terms[4], terms[5]);
  twoProduct(-halves, w, terms[6], terms[7]);
  const int sign = exactSign(terms);
  return w < 0 ? -sign : sign;
}

double approximate(float coordinate, float w, const ViewportAxis& axis, int bits) {
  const double pixels = double{coordinate} * axis.scale / w + axis.offset();
  return std::ldexp(clampToGuardBand(pixels), bits);
}

bool decides(double gridValue, double point) {
  return std::fabs(gridValue - point) > kSnapTrust * (std::fabs(gridValue) + 1);
}

double exactFloor(float coordinate, float w, const ViewportAxis& axis, int bits) {
  const double value = approximate(coordinate, w, axis, bits);
  const double near = std::nearbyint(value);
  if (decides(value, near)) return std::floor(value);
  return signAgainst(coordinate, w, axis, bits, 2 * near) >= 0 ? near : near - 1;
}

SnapRounding roundingOf(const Rules& rules) {
  return rules.error == DeliberateError::TruncatingSnap ? SnapRounding::TowardZero : rules.choices.snapRounding;
}

constexpr int32_t kHalfPixel = kSubpixelOne / 2;

bool isExactly(float coordinate, float w, const ViewportAxis& axis, int bits, double gridValue) {
  return signAgainst(coordinate, w, axis, bits, 2 * gridValue) == 0;
}

}  // namespace

int32_t ceilingExactly(float coordinate, float w, const ViewportAxis& axis, double shift) {
  const double value = approximate(coordinate, w, axis, kSubpixelBits) + shift;
  const double near = std::nearbyint(value);
  if (decides(value, near)) return static_cast<int32_t>(std::ceil(value));
  const int side = signAgainst(coordinate, w, axis, kSubpixelBits, 2 * (near - shift));
  return static_cast<int32_t>(side > 0 ? near + 1 : near);
}

SnapShift snapShift(const Rules& rules, uint32_t samples) {
  switch (rules.choices.snapOrigin) {
    case SnapOrigin::Corner: return SnapShift::None;
    case SnapOrigin::CentreAtOneSample: return samples == 1 ? SnapShift::AfterViewport : SnapShift::None;
    case SnapOrigin::Centre: return SnapShift::AfterViewport;
    case SnapOrigin::CentreInViewport: return SnapShift::InViewport;
  }
  return SnapShift::None;
}

int gridBits(const Rules& rules) {
  if (rules.error == DeliberateError::CoarseSnap) return 4;
  if (rules.error == DeliberateError::SevenBitSnap) return 7;
  if (rules.variation && rules.variation->gridBits > 0) return static_cast<int>(rules.variation->gridBits);
  const bool own = rules.choices.subPixelBits != 0 && !rules.open;
  return static_cast<int>(std::min<uint32_t>(own ? rules.choices.subPixelBits : rules.limits.subPixelPrecisionBits, kSubpixelBits));
}

int32_t snap(double pixels, int bits, SnapRounding rounding) {
  return toSubpixels(roundTo(std::ldexp(clampToGuardBand(pixels), bits), rounding), bits);
}

int32_t snapExactly(float coordinate, float w, const ViewportAxis& axis, int bits, SnapRounding rounding) {
  const double below = exactFloor(coordinate, w, axis, bits);
  // Is the coordinate in the upper part of its step? `atHalf` decides the middle.
  const auto nearest = [&](bool atHalf) {
    const double value = approximate(coordinate, w, axis, bits);
    const double half = below + 0.5;
    const int side = decides(value, half) ? (value > half ? 1 : -1) : signAgainst(coordinate, w, axis, bits, 2 * half);
    return side > 0 || (side == 0 && atHalf);
  };
  const auto onGrid = [&] { return isExactly(coordinate, w, axis, bits, below); };
  bool up = false;
  switch (rounding) {
    case SnapRounding::Floor: break;
    case SnapRounding::Ceiling: up = !onGrid(); break;
    case SnapRounding::TowardZero: up = below < 0 && !onGrid(); break;
    case SnapRounding::NearestEven: up = nearest(std::fmod(below, 2.0) != 0); break;
    case SnapRounding::NearestUp: up = nearest(true); break;
    case SnapRounding::NearestDown: up = nearest(false); break;
    case SnapRounding::NearestAway: up = nearest(below >= 0); break;
    case SnapRounding::NearestTowardZero: up = nearest(below < 0); break;
  }
  return toSubpixels(up ? below + 1 : below, bits);
}

int32_t snapFloat(const Rules& rules, uint32_t samples, float pixels) {
  const int bits = gridBits(rules);
  const SnapShift shift = snapShift(rules, samples);
  const float shifted = shift == SnapShift::AfterViewport ? pixels - 0.5F : pixels;
  const float scaled = static_cast<float>(clampToGuardBand(shifted)) * std::ldexp(1.0F, bits);
  return toSubpixels(roundTo(scaled, roundingOf(rules)), bits) + (shift == SnapShift::None ? 0 : kHalfPixel);
}

int32_t mapAndSnapFloat(const Rules& rules, uint32_t samples, float coordinate, float w, const ViewportAxis& axis,
                        ViewportArithmetic arithmetic) {
  const float origin = snapShift(rules, samples) == SnapShift::InViewport ? 0.5F : 0;
  return snapFloat(rules, samples, toFramebufferFloat(coordinate, w, axis, arithmetic, origin));
}

int32_t snapPosition(const Rules& rules, uint32_t samples, double pixels) {
  const bool centre = snapShift(rules, samples) != SnapShift::None;
  const int32_t snapped = snap(centre ? pixels - 0.5 : pixels, gridBits(rules), rules.choices.snapRounding);
  return centre ? snapped + kHalfPixel : snapped;
}

int32_t snapUnder(const Rules& rules, uint32_t samples, float coordinate, float w, const ViewportAxis& axis) {
  if (rules.choices.viewportArithmetic != ViewportArithmetic::Exact) {
    return mapAndSnapFloat(rules, samples, coordinate, w, axis, rules.choices.viewportArithmetic);
  }
  if (snapShift(rules, samples) == SnapShift::None) {
    return snapExactly(coordinate, w, axis, gridBits(rules), roundingOf(rules));
  }
  const ViewportAxis shifted{axis.scale, axis.origin - 0.5, axis.centre};  // exact: floats of a screen and a half
  return snapExactly(coordinate, w, shifted, gridBits(rules), roundingOf(rules)) + kHalfPixel;
}

GridPlace snapAnywhere(const Rules& rules, uint32_t samples, float coordinate, float w, const ViewportAxis& axis) {
  const SnapShift shift = snapShift(rules, samples);
  const ViewportArithmetic arithmetic = rules.choices.viewportArithmetic;
  double pixels = 0;
  if (arithmetic == ViewportArithmetic::Exact) {
    pixels = double{coordinate} * axis.scale / w + axis.offset() - (shift == SnapShift::None ? 0 : 0.5);
  } else {
    const float mapped = toFramebufferFloat(coordinate, w, axis, arithmetic, shift == SnapShift::InViewport ? 0.5F : 0);
    pixels = shift == SnapShift::AfterViewport ? mapped - 0.5F : mapped;
  }
  const int bits = gridBits(rules);
  const double steps = roundTo(std::ldexp(pixels, bits), roundingOf(rules));
  return {steps, std::ldexp(steps, -bits) + (shift == SnapShift::None ? 0 : 0.5)};
}

SnapRange legalSnaps(float coordinate, float w, const ViewportAxis& axis, int bits, double uncertainty) {
  if (uncertainty > 0) return legalSnaps(double{coordinate} * axis.scale / w + axis.offset(), bits, uncertainty);
  const double below = exactFloor(coordinate, w, axis, bits);
  const double above = isExactly(coordinate, w, axis, bits, below) ? below : below + 1;
  return {toSubpixels(below, bits), toSubpixels(above, bits)};
}

SnapRange legalSnaps(double pixels, int bits, double uncertainty) {
  const auto grid = [&](double value) { return std::ldexp(clampToGuardBand(value), bits); };
  return {toSubpixels(std::floor(grid(pixels - uncertainty)), bits),
          toSubpixels(std::ceil(grid(pixels + uncertainty)), bits)};
}

}  // namespace rasterdiff::rasterizer
