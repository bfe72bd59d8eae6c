#include "scene/frame.hpp"

namespace rasterdiff {
namespace {

template <class T>
size_t bytes(const Plane<T>& plane) {
  return plane.data.size() * sizeof(T);
}

template <class T>
size_t bytes(const std::optional<Plane<T>>& plane) {
  return plane ? bytes(*plane) : 0;
}

}  // namespace

size_t planeBytes(const Frame& frame) {
  size_t total = bytes(frame.primitive) + bytes(frame.count) + bytes(frame.depth) + bytes(frame.coverage) +
                 bytes(frame.depthBounds);
  for (const VaryingPlane& varying : frame.varyings) total += bytes(varying.values) + bytes(varying.bounds);
  for (const VaryingPlane& varying : frame.resolved) total += bytes(varying.values) + bytes(varying.bounds);
  return total;
}

}  // namespace rasterdiff
