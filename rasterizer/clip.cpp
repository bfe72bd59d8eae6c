#include "rasterizer/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/mistakes/mistaken_clip.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kHalfUlp = 0x1p-24;  // relative rounding error of float32

enum Plane : int { PlusX, MinusX, PlusY, MinusY, Near, Far };

// Distance to a plane, >= 0 inside. T is float (a driver's arithmetic) or double.
template <class T>
T distance(const ClipVertex& vertex, int plane, const ClipVolume& volume) {
  if (plane >= kVolumePlanes) return static_cast<T>(vertex.distances[static_cast<size_t>(plane - kVolumePlanes)]);
  const std::array<double, 4>& p = vertex.position;
  const T side = volume.wideSides ? T{0.5} : T{1};
  const T x = side * static_cast<T>(p[0]), y = side * static_cast<T>(p[1]), z = static_cast<T>(p[2]), w = static_cast<T>(p[3]);
  switch (plane) {
    case PlusX: return w - x;
    case MinusX: return x + w;
    case PlusY: return w - y;
    case MinusY: return y + w;
    case Near: return volume.nearAtMinusW ? z + w : z;
    default: return w - z;
  }
}

// A vertex at parameter t from base to other; `mix` combines one coordinate of each.
template <class T, class Mix>
ClipVertex mixed(const ClipVertex& base, const ClipVertex& other, T t, const Mix& mix) {
  ClipVertex vertex;
  vertex.made = true;
  for (size_t i = 0; i < 4; ++i) {
    vertex.position[i] = mix(static_cast<T>(base.position[i]), static_cast<T>(other.position[i]));
    // t carries two roundings of the distances' sum of magnitudes, the lerp three: at most 6 half-ULPs of the larger end.
    vertex.error[i] = std::max(base.error[i], other.error[i]) +
                      6 * kHalfUlp * std::max(std::fabs(base.position[i]), std::fabs(other.position[i]));
  }
  for (size_t i = 0; i < kMaxDistances; ++i) {
    vertex.distances[i] = mix(static_cast<T>(base.distances[i]), static_cast<T>(other.distances[i]));
  }
  for (size_t i = 0; i < 3; ++i) {
    vertex.smoothWeights[i] = base.smoothWeights[i] + static_cast<double>(t) * (other.smoothWeights[i] - base.smoothWeights[i]);
  }
  return vertex;
}

// Weights on the screen from those in clip space: bᵢ = sᵢ wᵢ / Σ sⱼ wⱼ. Not carried along while cutting, since a vertex that
// is cut away again may have any w.
void weighOnScreen(ClipPolygon& polygon, std::span<const ClipInput> corners) {
  for (ClipVertex& vertex : std::span(polygon.vertices).first(static_cast<size_t>(polygon.size))) {
    if (!vertex.made) continue;
    double sum = 0;
    for (size_t i = 0; i < corners.size(); ++i) sum += vertex.linearWeights[i] = vertex.smoothWeights[i] * double{corners[i].position.w};
    for (size_t i = 0; i < corners.size(); ++i) vertex.linearWeights[i] /= sum;
  }
}

// base + t (other - base), coordinate by coordinate.
template <class T>
ClipVertex between(const ClipVertex& base, const ClipVertex& other, T t) {
  return mixed<T>(base, other, t, [t](T from, T to) { return from + t * (to - from); });
}

// Both ends weighted by the other's distance, always from the inner to the outer one.
ClipVertex weighted(const ClipVertex& inside, float dIn, const ClipVertex& outside, float dOut) {
  const float scale = 1.0F / (dOut - dIn);
  return mixed<float>(inside, outside, dIn / (dIn - dOut),
                      [&](float in, float out) { return (dOut * in - dIn * out) * scale; });
}

// The crossing is computed from the end that is nearer to the plane, so that an edge shared by two triangles gets the
// same new vertex whichever way it is walked.
template <class T>
ClipVertex crossing(const ClipVertex& inside, T dIn, const ClipVertex& outside, T dOut) {
  if (-dOut < dIn) return between<T>(outside, inside, dOut / (dOut - dIn));
  return between<T>(inside, outside, dIn / (dIn - dOut));
}

// `meet`: the crossing of an edge, given its inner end with its distance, then its outer end. kAtVertex: an edge that comes in
// through a vertex on the plane has a crossing there, too.
template <class T, bool kAtVertex, class Meet>
bool clipAgainst(int plane, const ClipVolume& volume, const ClipPolygon& in, ClipPolygon& out, const Meet& meet) {
  out.size = 0;
  const ClipVertex* previous = &in.vertices[0];
  T dPrevious = distance<T>(*previous, plane, volume);
  if (!std::isfinite(dPrevious)) return false;
  for (int i = 1; i <= in.size; ++i) {
    const ClipVertex& vertex = in.vertices[static_cast<size_t>(i == in.size ? 0 : i)];
    const T d = distance<T>(vertex, plane, volume);
    if (!std::isfinite(d)) return false;
    const auto append = [&out](const ClipVertex& v, bool outlined) {
      if (out.size == ClipPolygon::kCapacity) return;
      out.vertices[static_cast<size_t>(out.size)] = v;
      out.vertices[static_cast<size_t>(out.size++)].outlined = outlined;
    };
    if (dPrevious >= 0) append(*previous, previous->outlined);
    if (dPrevious >= 0 && d < 0) append(meet(*previous, dPrevious, vertex, d), plane >= kVolumePlanes);
    if (dPrevious < 0 && (d > 0 || (kAtVertex && d == 0))) append(meet(vertex, d, *previous, dPrevious), previous->outlined);
    previous = &vertex;
    dPrevious = d;
  }
  return true;
}

bool clipAgainst(ClipArithmetic arithmetic, int plane, const ClipVolume& volume, const ClipPolygon& in, ClipPolygon& out) {
  switch (arithmetic) {
    case ClipArithmetic::Exact: return clipAgainst<double, true>(plane, volume, in, out, crossing<double>);
    case ClipArithmetic::Float32Linear: return clipAgainst<float, true>(plane, volume, in, out, crossing<float>);
    case ClipArithmetic::Float32Weighted: return clipAgainst<float, false>(plane, volume, in, out, weighted);
  }
  return false;
}

int planeInOrder(ClipArithmetic arithmetic, int step) {
  if (arithmetic != ClipArithmetic::Float32Weighted || step >= kVolumePlanes) return step;
  constexpr std::array<int, kVolumePlanes> kNearFirst{Near, Far, MinusX, PlusX, PlusY, MinusY};
  return kNearFirst[static_cast<size_t>(step)];
}

ClipVertex clipVertex(const ClipInput& input, const ClipVolume& volume, size_t corner) {
  ClipVertex vertex;
  const ClipPosition& p = input.position;
  vertex.position = {p.x, p.y, p.z, p.w};
  vertex.smoothWeights[corner] = vertex.linearWeights[corner] = 1;
  for (size_t i = 0; i < volume.distances; ++i) {
    const float d = input.distances[i];
    const bool zeroOut = d == 0 && volume.error == DeliberateError::ClipDistanceExclusive;
    vertex.distances[i] = zeroOut ? -std::numeric_limits<float>::min() : d;
  }
  return vertex;
}

// The end of a line that is farther along on the inner side of every plane: its parameter from `base` to `other`.
template <class T>
void clipEnds(unsigned planes, const ClipVolume& volume, ClipPolygon& line) {
  T t0 = 0, t1 = 0;
  for (int plane = 0; plane < kClipPlanes; ++plane) {
    if ((planes & (1U << plane)) == 0) continue;
    const T d0 = distance<T>(line.vertices[0], plane, volume), d1 = distance<T>(line.vertices[1], plane, volume);
    if (!std::isfinite(d0) || !std::isfinite(d1)) {
      line.size = 0;
      return;
    }
    if (d1 < 0) t1 = std::max<T>(t1, d1 / (d1 - d0));
    if (d0 < 0) t0 = std::max<T>(t0, d0 / (d0 - d1));
    if (t0 + t1 >= 1) {
      line.size = 0;
      return;
    }
  }
  const ClipVertex first = line.vertices[0], second = line.vertices[1];
  if (t0 > 0) line.vertices[0] = between<T>(first, second, t0);
  if (t1 > 0) line.vertices[1] = between<T>(second, first, t1);
}

}  // namespace

ClipVolume clipVolume(const State& state, const Draw& draw, DeliberateError error) {
  ClipVolume volume;
  volume.nearAtMinusW = state.negativeOneToOne != (error == DeliberateError::WrongNearPlane);
  volume.nearAndFar = state.depthClipEnable.value_or(!state.depthClampEnable);
  if (error == DeliberateError::DepthClipIgnored) volume.nearAndFar = false;
  if (error == DeliberateError::DepthClipForced) volume.nearAndFar = true;
  volume.distances = error == DeliberateError::ClipDistanceIgnored ? 0 : draw.clipDistanceCount;
  volume.error = error;
  return volume;
}

unsigned outcode(const ClipInput& vertex, const ClipVolume& volume) {
  const ClipPosition& p = vertex.position;
  unsigned code = 0;
  if (volume.error != DeliberateError::SideClipIgnored) {
    if (p.x > p.w) code |= 1U << PlusX;
    if (0 > p.x + p.w) code |= 1U << MinusX;
    if (p.y > p.w) code |= 1U << PlusY;
    if (0 > p.y + p.w) code |= 1U << MinusY;
  }
  if (volume.nearAndFar) {
    if (volume.nearAtMinusW ? 0 > p.z + p.w : 0 > p.z) code |= 1U << Near;
    if (p.z > p.w && volume.error != DeliberateError::NoFarClip) code |= 1U << Far;
  }
  for (uint32_t i = 0; i < volume.distances; ++i) {
    const float d = vertex.distances[i];
    // [vk:vertexpostproc-clipping] a distance of exactly 0 is inside; NaN and infinity are outside.
    const bool zeroOut = volume.error == DeliberateError::ClipDistanceExclusive && d == 0;
    if (!(d >= 0) || zeroOut || std::isinf(d)) code |= 1U << (kVolumePlanes + static_cast<int>(i));
  }
  return code;
}

ClipOutcome clipTriangle(std::span<const ClipInput, 3> triangle, ClipArithmetic arithmetic, const ClipVolume& volume,
                         ClipPolygon& polygon) {
  unsigned any = 0, all = ~0U;
  polygon.size = 3;
  for (size_t i = 0; i < 3; ++i) {
    const unsigned code = outcode(triangle[i], volume);
    any |= code;
    all &= code;
    polygon.vertices[i] = clipVertex(triangle[i], volume, i);
  }
  if (any == 0) return ClipOutcome::Inside;
  if (all != 0) return ClipOutcome::Rejected;

  ClipPolygon other;
  for (int step = 0; step < kClipPlanes && polygon.size >= 3; ++step) {
    const int plane = planeInOrder(arithmetic, step);
    if ((any & (1U << plane)) == 0) continue;
    if (!clipAgainst(arithmetic, plane, volume, polygon, other)) {
      polygon.size = 0;
      return ClipOutcome::Cut;
    }
    std::swap(polygon, other);
  }
  weighOnScreen(polygon, triangle);
  if (volume.error != DeliberateError::None) mistakeClipped(polygon, volume.error, any >> kVolumePlanes != 0);
  return ClipOutcome::Cut;
}

void clipPolygon(std::span<const ClipPosition> corners, ClipArithmetic arithmetic, const ClipVolume& volume, ClipPolygon& polygon) {
  polygon.size = 0;
  for (const ClipPosition& p : corners) {
    ClipVertex& vertex = polygon.vertices[static_cast<size_t>(polygon.size++)];
    vertex = {};
    vertex.position = {p.x, p.y, p.z, p.w};
  }
  ClipPolygon other;
  for (int step = 0; step < kVolumePlanes && polygon.size >= 3; ++step) {
    const int plane = planeInOrder(arithmetic, step);
    if (!volume.nearAndFar && (plane == Near || plane == Far)) continue;
    if (!clipAgainst(arithmetic, plane, volume, polygon, other)) other.size = 0;
    std::swap(polygon, other);
  }
}

ClipOutcome clipLine(std::span<const ClipInput, 2> line, ClipArithmetic arithmetic, const ClipVolume& volume,
                     ClipPolygon& polygon) {
  const unsigned first = outcode(line[0], volume), second = outcode(line[1], volume);
  polygon.size = 2;
  for (size_t i = 0; i < 2; ++i) polygon.vertices[i] = clipVertex(line[i], volume, i);
  if ((first | second) == 0) return ClipOutcome::Inside;
  if ((first & second) != 0) {
    polygon.size = 0;
    return ClipOutcome::Rejected;
  }
  if (arithmetic != ClipArithmetic::Exact) {
    clipEnds<float>(first | second, volume, polygon);
  } else {
    clipEnds<double>(first | second, volume, polygon);
  }
  weighOnScreen(polygon, line);
  if (volume.error != DeliberateError::None) mistakeClipped(polygon, volume.error, (first | second) >> kVolumePlanes != 0);
  return ClipOutcome::Cut;
}

}  // namespace rasterdiff::rasterizer
