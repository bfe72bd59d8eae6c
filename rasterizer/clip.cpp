#include "rasterizer/clip.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kHalfUlp = 0x1p-24;  // relative rounding error of float32

enum Plane : int { PlusX, MinusX, PlusY, MinusY, Near, Far, kPlanes };

bool nearAtMinusW(bool negativeOneToOne, DeliberateError error) {
  return negativeOneToOne != (error == DeliberateError::WrongNearPlane);
}

// Distance to a plane, >= 0 inside. T is float (a driver's arithmetic) or double.
template <class T>
T distance(const std::array<double, 4>& p, int plane, bool minusW) {
  const T x = static_cast<T>(p[0]), y = static_cast<T>(p[1]), z = static_cast<T>(p[2]), w = static_cast<T>(p[3]);
  switch (plane) {
    case PlusX: return w - x;
    case MinusX: return x + w;
    case PlusY: return w - y;
    case MinusY: return y + w;
    case Near: return minusW ? z + w : z;
    default: return w - z;
  }
}

// base + t (other - base), coordinate by coordinate.
template <class T>
ClipVertex between(const ClipVertex& base, const ClipVertex& other, T t) {
  ClipVertex vertex;
  vertex.made = true;
  for (size_t i = 0; i < 4; ++i) {
    const T from = static_cast<T>(base.position[i]), to = static_cast<T>(other.position[i]);
    vertex.position[i] = from + t * (to - from);
    // t carries two roundings of the distances' sum of magnitudes, the lerp three: at most 6 half-ULPs of the larger end.
    vertex.error[i] = std::max(base.error[i], other.error[i]) +
                      6 * kHalfUlp * std::max(std::fabs(base.position[i]), std::fabs(other.position[i]));
  }
  // Parameter on the screen of a point that is at t in clip space.
  const double tLinear = static_cast<double>(t) * other.position[3] / vertex.position[3];
  for (size_t i = 0; i < 3; ++i) {
    vertex.smoothWeights[i] = base.smoothWeights[i] + static_cast<double>(t) * (other.smoothWeights[i] - base.smoothWeights[i]);
    vertex.linearWeights[i] = base.linearWeights[i] + tLinear * (other.linearWeights[i] - base.linearWeights[i]);
  }
  return vertex;
}

// The crossing is computed from the end that is nearer to the plane, so that an edge shared by two triangles gets the
// same new vertex whichever way it is walked.
template <class T>
ClipVertex crossing(const ClipVertex& inside, T dIn, const ClipVertex& outside, T dOut) {
  if (-dOut < dIn) return between<T>(outside, inside, dOut / (dOut - dIn));
  return between<T>(inside, outside, dIn / (dIn - dOut));
}

template <class T>
bool clipAgainst(int plane, bool minusW, const ClipPolygon& in, ClipPolygon& out) {
  out.size = 0;
  const ClipVertex* previous = &in.vertices[0];
  T dPrevious = distance<T>(previous->position, plane, minusW);
  if (!std::isfinite(dPrevious)) return false;
  for (int i = 1; i <= in.size; ++i) {
    const ClipVertex& vertex = in.vertices[static_cast<size_t>(i == in.size ? 0 : i)];
    const T d = distance<T>(vertex.position, plane, minusW);
    if (!std::isfinite(d)) return false;
    const auto append = [&out](const ClipVertex& v) {
      if (out.size < ClipPolygon::kCapacity) out.vertices[static_cast<size_t>(out.size++)] = v;
    };
    if (dPrevious >= 0) append(*previous);
    if (dPrevious >= 0 && d < 0) append(crossing<T>(*previous, dPrevious, vertex, d));
    if (dPrevious < 0 && d >= 0) append(crossing<T>(vertex, d, *previous, dPrevious));
    previous = &vertex;
    dPrevious = d;
  }
  return true;
}

void copyUnadjustedAttributes(ClipPolygon& polygon) {
  for (int i = 0; i < polygon.size; ++i) {
    ClipVertex& vertex = polygon.vertices[static_cast<size_t>(i)];
    if (!vertex.made) continue;
    const auto nearest = std::max_element(vertex.smoothWeights.begin(), vertex.smoothWeights.end());
    std::array<double, 3> copied{};
    copied[static_cast<size_t>(nearest - vertex.smoothWeights.begin())] = 1;
    vertex.smoothWeights = vertex.linearWeights = copied;
  }
}

}  // namespace

unsigned outcode(const ClipPosition& p, bool negativeOneToOne, DeliberateError error) {
  unsigned code = 0;
  if (p.x > p.w) code |= 1U << PlusX;
  if (0 > p.x + p.w) code |= 1U << MinusX;
  if (p.y > p.w) code |= 1U << PlusY;
  if (0 > p.y + p.w) code |= 1U << MinusY;
  if (nearAtMinusW(negativeOneToOne, error) ? 0 > p.z + p.w : 0 > p.z) code |= 1U << Near;
  if (p.z > p.w && error != DeliberateError::NoFarClip) code |= 1U << Far;
  return code;
}

ClipOutcome clipTriangle(std::span<const ClipPosition, 3> triangle, const Rules& rules, bool negativeOneToOne,
                         ClipPolygon& polygon) {
  unsigned any = 0, all = ~0U;
  polygon.size = 3;
  for (size_t i = 0; i < 3; ++i) {
    const ClipPosition& p = triangle[i];
    const unsigned code = outcode(p, negativeOneToOne, rules.error);
    any |= code;
    all &= code;
    ClipVertex& vertex = polygon.vertices[i];
    vertex = ClipVertex{};
    vertex.position = {p.x, p.y, p.z, p.w};
    vertex.smoothWeights[i] = vertex.linearWeights[i] = 1;
  }
  if (any == 0) return ClipOutcome::Inside;
  if (all != 0) return ClipOutcome::Rejected;

  const bool minusW = nearAtMinusW(negativeOneToOne, rules.error);
  const bool asFloat = rules.choices.clipArithmetic == ClipArithmetic::Float32Linear;
  ClipPolygon other;
  for (int plane = 0; plane < kPlanes && polygon.size >= 3; ++plane) {
    if ((any & (1U << plane)) == 0) continue;
    const bool finite = asFloat ? clipAgainst<float>(plane, minusW, polygon, other)
                                : clipAgainst<double>(plane, minusW, polygon, other);
    if (!finite) {
      polygon.size = 0;
      return ClipOutcome::Cut;
    }
    std::swap(polygon, other);
  }
  if (rules.error == DeliberateError::ClipAttributeUnadjusted) copyUnadjustedAttributes(polygon);
  return ClipOutcome::Cut;
}

}  // namespace rasterdiff::rasterizer
