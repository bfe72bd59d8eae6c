// What kind of primitive a scene assembles and how many, and what kinds reach the rasterizer: polygons may be drawn as lines or points.
#pragma once

#include "scene/scene.hpp"

namespace rasterdiff {

/// Of all draws, as they are numbered in a Frame: before clipping and culling.
[[nodiscard]] inline uint64_t primitiveCount(const Scene& scene) {
  uint64_t primitives = 0;
  for (const Draw& draw : scene.draws) primitives += primitiveCount(scene.state, draw);
  return primitives;
}

/// [vk:drawing-primitive-topology-class]
enum class TopologyClass : uint8_t { Point, Line, Triangle };

[[nodiscard]] inline TopologyClass topologyClassOf(PrimitiveTopology topology) {
  if (topology == PrimitiveTopology::POINT_LIST) return TopologyClass::Point;
  const bool lines = topology == PrimitiveTopology::LINE_LIST || topology == PrimitiveTopology::LINE_STRIP;
  return lines ? TopologyClass::Line : TopologyClass::Triangle;
}

[[nodiscard]] inline bool isList(PrimitiveTopology topology) {
  return topology == PrimitiveTopology::POINT_LIST || topology == PrimitiveTopology::LINE_LIST ||
         topology == PrimitiveTopology::TRIANGLE_LIST;
}

/// The mode of polygons; FILL where there are none.
[[nodiscard]] inline PolygonMode polygonModeOf(const State& state) {
  return topologyClassOf(state.topology) == TopologyClass::Triangle ? state.polygonMode : PolygonMode::FILL;
}

[[nodiscard]] inline bool fillsTriangles(const State& state) {
  return topologyClassOf(state.topology) == TopologyClass::Triangle && state.polygonMode == PolygonMode::FILL;
}

[[nodiscard]] inline bool drawsPoints(const State& state) {
  return state.topology == PrimitiveTopology::POINT_LIST || polygonModeOf(state) == PolygonMode::POINT;
}

[[nodiscard]] inline bool drawsLines(const State& state) {
  return topologyClassOf(state.topology) == TopologyClass::Line || polygonModeOf(state) == PolygonMode::LINE;
}

}  // namespace rasterdiff
