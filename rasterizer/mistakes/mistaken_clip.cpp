#include "rasterizer/mistakes/mistaken_clip.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

std::span<ClipVertex> verticesOf(ClipPolygon& polygon) {
  return std::span(polygon.vertices).first(static_cast<size_t>(polygon.size));
}

void copyNearestCorner(ClipVertex& vertex) {
  const auto nearest = std::max_element(vertex.smoothWeights.begin(), vertex.smoothWeights.end());
  std::array<double, 3> copied{};
  copied[static_cast<size_t>(nearest - vertex.smoothWeights.begin())] = 1;
  vertex.smoothWeights = vertex.linearWeights = copied;
}

// New vertices move by a fiftieth of their way to the middle.
void shrink(std::span<ClipVertex> polygon) {
  std::array<double, 4> middle{};
  for (const ClipVertex& vertex : polygon) {
    for (size_t i = 0; i < 4; ++i) middle[i] += vertex.position[i] / static_cast<double>(polygon.size());
  }
  for (ClipVertex& vertex : polygon) {
    if (!vertex.made) continue;
    for (size_t i = 0; i < 4; ++i) vertex.position[i] += (middle[i] - vertex.position[i]) / 50;
  }
}

void rotateValues(std::span<ClipVertex> polygon) {
  for (size_t i = 0; i + 1 < polygon.size(); ++i) {
    std::swap(polygon[i].smoothWeights, polygon[i + 1].smoothWeights);
    std::swap(polygon[i].linearWeights, polygon[i + 1].linearWeights);
  }
}

}  // namespace

void mistakeClipped(ClipPolygon& left, DeliberateError error, bool byDistance) {
  const std::span<ClipVertex> vertices = verticesOf(left);
  if (error == DeliberateError::ClipDistanceGap && byDistance) shrink(vertices);
  if (error == DeliberateError::CutValuesRotated && vertices.size() > 3) rotateValues(vertices);
  const DeliberateError unadjusted =
      vertices.size() == 2 ? DeliberateError::LineClipValues : DeliberateError::ClipAttributeUnadjusted;
  for (ClipVertex& vertex : vertices) {
    if (!vertex.made) continue;
    if (error == unadjusted) copyNearestCorner(vertex);
    if (error == DeliberateError::NoperspectiveCutByW) vertex.linearWeights = vertex.smoothWeights;
  }
}

}  // namespace rasterdiff::rasterizer
