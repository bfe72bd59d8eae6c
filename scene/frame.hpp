// What came out: one value per sample and plane, only the planes that the scene needs. Both renderers fill the same
// type; the bounds are what the reference knows to be free, so that compare needs no geometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/plane_memory.hpp"

namespace rasterdiff {

/// height × width × samples × components, row-major.
template <class T>
struct Plane {
  uint32_t width = 0, height = 0, samples = 1, components = 1;
  std::vector<T, ZeroedAllocator<T>> data;

  Plane() = default;
  /// All zero.
  Plane(uint32_t w, uint32_t h, uint32_t s, uint32_t c = 1) : width(w), height(h), samples(s), components(c), data(size_t{w} * h * s * c) {}
  Plane(uint32_t w, uint32_t h, uint32_t s, uint32_t c, T fill)
      : width(w), height(h), samples(s), components(c), data(size_t{w} * h * s * c, fill) {}

  /// Whatever the memory holds: for planes that are written as a whole.
  [[nodiscard]] static Plane unwritten(uint32_t w, uint32_t h, uint32_t s, uint32_t c = 1) {
    Plane plane;
    plane.width = w, plane.height = h, plane.samples = s, plane.components = c;
    plane.data = std::vector<T, ZeroedAllocator<T>>(size_t{w} * h * s * c, ZeroedAllocator<T>::unwritten());
    return plane;
  }

  [[nodiscard]] size_t index(uint32_t x, uint32_t y, uint32_t sample, uint32_t component = 0) const {
    return ((size_t{y} * width + x) * samples + sample) * components + component;
  }
  T& at(uint32_t x, uint32_t y, uint32_t s, uint32_t c = 0) { return data[index(x, y, s, c)]; }
  const T& at(uint32_t x, uint32_t y, uint32_t s, uint32_t c = 0) const { return data[index(x, y, s, c)]; }
};

/// Is a sample covered by a primitive, in every legal outcome, in none, or in some?
enum class Coverage : uint8_t { Out, In, Either };

/// Closed interval of legal values.
struct Bounds {
  float lo = 0, hi = 0;
};

struct VaryingPlane {
  std::string name;
  Plane<float> values;               ///< 0 where nothing was drawn
  std::optional<Plane<Bounds>> bounds;  ///< reference only
};

struct Frame {
  uint32_t width = 0, height = 0, samples = 1;
  Plane<uint32_t> primitive;  ///< 1 + index of the last primitive that wrote the sample, over all draws; 0 = none
  Plane<uint32_t> count;      ///< how many primitives wrote the sample (passed its tests)
  std::optional<Plane<float>> depth;  ///< as stored; the clear value where nothing was drawn
  std::vector<VaryingPlane> varyings;  ///< the scene's varyings, then its built-ins
  std::vector<VaryingPlane> resolved;  ///< one sample a pixel: the varyings, then "depth", resolved (scenes that ask for it)

  std::optional<Plane<Coverage>> coverage;   ///< reference only: Either where a freedom decides the sample
  std::optional<Plane<Bounds>> depthBounds;  ///< reference only
};

/// Bytes held by all planes: how a test knows that a coverage-only scene holds nothing else.
[[nodiscard]] size_t planeBytes(const Frame& frame);

}  // namespace rasterdiff
