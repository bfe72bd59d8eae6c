// Why a sample is covered, or not, and by whom: the exact numbers behind one sample of one scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rasterizer/render.hpp"

namespace rasterdiff::rasterizer {

struct EdgeExplanation {
  std::array<SubpixelPosition, 2> ends;  ///< snapped, 1/256 pixel
  int64_t value = 0;      ///< edge function at the sample, 1/65536 pixel²; > 0 inside
  bool ownsTies = false;  ///< an edge of this direction owns samples that lie on it
  int64_t lowest = 0, highest = 0;  ///< over all legal placements (equal to value under a profile)
};

/// One piece of one primitive (clipping can make several) whose bounds reach the pixel.
struct PrimitiveExplanation {
  uint32_t primitive = 0;  ///< 1-based
  std::array<ClipPosition, 3> clip;
  std::array<SubpixelPosition, 3> snapped;
  bool clipped = false;      ///< a piece made by clipping
  int64_t doubleArea = 0;    ///< 1/65536 pixel², > 0 = counter-clockwise as Vulkan's formula has it
  bool frontFacing = false, culled = false;
  std::array<EdgeExplanation, 3> edges;
  bool covered = false;      ///< nominal
  Coverage coverage = Coverage::Out;
  Freedom freedom = Freedom::None;
  Rule decidedBy = Rule::SampleCoverage;
  double depth = 0;          ///< at the sample, where the scene has depth
};

struct SampleExplanation {
  SubpixelPosition position;  ///< of the sample, 1/256 pixel
  bool insideScissor = true;
  std::vector<PrimitiveExplanation> primitives;  ///< in drawing order
  uint32_t owner = 0;                            ///< nominal winner, 1-based; 0 = none
};

[[nodiscard]] Result<SampleExplanation> explain(const Scene& scene, const Rules& rules, SampleQuery query);

}  // namespace rasterdiff::rasterizer
