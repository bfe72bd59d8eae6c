// Why a sample is covered, or not, and by whom: the exact numbers behind one sample of one scene.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/render.hpp"
#include "rasterizer/shape_facts.hpp"

namespace rasterdiff::rasterizer {

struct EdgeExplanation {
  std::array<SubpixelPosition, 2> ends;  ///< snapped, 1/256 pixel
  int64_t value = 0;      ///< edge function at the sample, 1/65536 pixel²; > 0 inside
  bool ownsTies = false;  ///< an edge of this direction owns samples that lie on it
  int64_t lowest = 0, highest = 0;  ///< over all legal placements (equal to value under a profile)
};

/// What became of a primitive's fragment at the sample, after rasterization.
struct FragmentFate {
  enum class End : uint8_t {
    NotCovered,
    OutsideScissor,
    Masked,        ///< by the pipeline's sample mask
    ShaderMasked,  ///< by the mask that the shader writes
    AlphaDropped,  ///< by alpha to coverage
    DepthFailed,
    Written,
  };
  End end = End::NotCovered;
  float depth = 0, stored = 0;  ///< what the depth test compared, where there is a depth attachment
  float alpha = 1;              ///< where alpha to coverage is on
  uint32_t shaderMask = 0;      ///< what the shader writes to SampleMask, where it does
  uint32_t replaced = 0;        ///< the primitive that had the sample until then; 0 = none
};

/// One piece of one primitive (clipping can make several), or one of its lines or points, whose bounds reach the pixel.
struct PrimitiveExplanation {
  enum class Kind : uint8_t { Triangle, Line, Point };
  Kind kind = Kind::Triangle;
  uint32_t primitive = 0;  ///< 1-based
  uint32_t vertices = 3;   ///< of the primitive: a triangle drawn as lines or points has 3
  std::array<ClipPosition, 3> clip;
  bool clipped = false;      ///< a piece made by clipping
  bool frontFacing = false, culled = false;
  bool unprojectable = false;  ///< some w is 0: it has no place on the screen (open rules), and none of the next three members

  std::array<SubpixelPosition, 3> snapped;  ///< of a triangle
  int64_t doubleArea = 0;                   ///< 1/65536 pixel², > 0 = counter-clockwise as Vulkan's formula has it
  std::array<EdgeExplanation, 3> edges;

  std::array<FramebufferPosition, 2> ends;  ///< of a line, or twice a point's centre; pixels, unrounded
  double requested = 0, size = 0;           ///< line width or point size, pixels: as asked for, and as drawn
  ShapeFacts facts;                         ///< of a line or point
  std::vector<Rule> shapeRules;             ///< that make its shape (FigureRules)
  bool dropped = false;                     ///< inside, but for the stipple pattern

  bool covered = false;      ///< nominal
  Coverage coverage = Coverage::Out;
  Freedom freedom = Freedom::None;
  FragmentFate fate;
  Rule decidedBy = Rule::SampleCoverage;
  double depth = 0;          ///< at the sample, where the scene has depth
};

/// Primitives that never reached rasterization, by the reason.
struct Rejection {
  Rule rule = Rule::ViewVolume;
  std::string_view by;              ///< "the near plane"
  uint32_t first = 0, count = 0;    ///< number of the first one, and how many
};

struct SampleExplanation {
  SubpixelPosition position;  ///< of the sample, 1/256 pixel
  bool insideScissor = true;  ///< of some viewport
  std::vector<PrimitiveExplanation> primitives;  ///< in drawing order
  std::vector<Rejection> rejections;
  std::vector<Rule> rules;                       ///< that had a part in the answer: those that decided first
  uint32_t owner = 0;                            ///< nominal winner, 1-based; 0 = none
};

[[nodiscard]] Result<SampleExplanation> explain(const Scene& scene, const Rules& rules, SampleQuery query);

// The parts of it, each in its own file.

/// Why the primitives that `reached` does not list (ascending numbers) were not rasterized.
[[nodiscard]] std::vector<Rejection> explainRejections(const Scene& scene, const Rules& rules,
                                                       const std::vector<uint32_t>& reached);
/// Rules that had a part in `sample` (whose other members are filled in).
[[nodiscard]] std::vector<Rule> rulesAtWork(const Scene& scene, const SampleExplanation& sample);

}  // namespace rasterdiff::rasterizer
