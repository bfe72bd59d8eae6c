// What a joint placement has to satisfy: vertices with their legal boxes, and for each primitive the samples that the
// frame shows it to cover or to leave.
#pragma once

#include <array>
#include <vector>

#include "harness/compare/placement/placement.hpp"
#include "rasterizer/render.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::harness {

struct PlacedVertex {
  uint32_t draw = 0, vertex = 0;
  FramebufferPosition position;               ///< unsnapped, pixels
  double deviationX = 0, deviationY = 0;      ///< legal uncertainty of `position` before snapping, pixels
  SubpixelPosition nominal, lowest, highest;  ///< 1/256 pixel, on the advertised grid
};

/// A sample that decides between placements.
struct Requirement {
  int64_t px = 0, py = 0;  ///< 1/256 pixel
  bool covered = false;
  uint8_t strictEdges = 0;  ///< bit e: it may not lie within edge e (corner e to e + 1), for the other side has the same answer
};

struct PlacedPrimitive {
  uint32_t number = 0;
  std::array<uint32_t, 3> vertices{};  ///< indices into PlacementProblem::vertices
  std::vector<Requirement> requirements;
};

struct PlacementProblem {
  CullMode cullMode = CullMode::NONE;
  FrontFace frontFace = FrontFace::COUNTER_CLOCKWISE;
  int advertisedBits = kSubpixelBits;
  std::vector<PlacedVertex> vertices;
  std::vector<PlacedPrimitive> primitives;
  uint64_t leftOut = 0;
  bool tooLarge = false;
};

/// All primitives that share vertices, directly or through others, with one that is free at a sample of `seeds`.
[[nodiscard]] Result<PlacementProblem> placementProblem(const Scene& scene, const rasterizer::Rules& rules,
                                                        const Frame& actual,
                                                        std::span<const rasterizer::SampleQuery> seeds);

}  // namespace rasterdiff::harness
