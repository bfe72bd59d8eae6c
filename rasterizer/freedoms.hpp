// The freedoms of the specification, each a named object with its anchor: what a verdict of Allowed has to cite.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

enum class Freedom : uint8_t {
  None,
  TieOwner,            ///< a sample exactly on an edge
  SnapRounding,        ///< a vertex may go to a neighbouring point of the subpixel grid
  ViewportArithmetic,  ///< NDC and viewport transform have no stated precision
  ViewportBounds,      ///< viewport bounds are honoured to viewportSubPixelBits only
  ClipVertexPosition,  ///< position of vertices that clipping makes has no stated precision
  NearZeroArea,        ///< facing of a triangle whose area changes sign under legal snapping
  DivisionByZero,      ///< a vertex with w = 0 inside the view volume has no place on the screen
  LineCorner,          ///< corners of a line's outline have no stated precision
  LineWidthStep,       ///< widths between the advertised ones may be supported too
  PointSizeStep,       ///< the same of point sizes
  LineAlgorithm,       ///< without strictLines: a parallelogram or a Bresenham line
  BresenhamDeviation,  ///< Bresenham lines: one pixel aside, one fragment more or less
  SmoothLine,          ///< which pixels near a smooth line are covered, and how exactly their area is told
  LineClip,            ///< a line that leaves the clip volume may be cut or not
  StippleCarry,        ///< the remainder of a stippled line may be carried to the next segment
  LineInterpolation,  ///< values of non-strict and wide Bresenham lines: by projection or along the major axis
  CentroidPosition,   ///< centroid inputs: anywhere the primitive covers
  OffsetRounding,     ///< interpolation offsets may be rounded
  SampleShadingRate,  ///< which samples share an invocation
  DepthBias,          ///< slope, unit and scope of depth bias
  PrimitiveOrder,     ///< the order of the lines and points that polygon modes make of one triangle
  UndefinedDepth,     ///< depths outside of the viewport's range, unclamped
  ShaderSampleMask,   ///< a mask that the shader makes of SampleMask, where the fragment's other samples are free
  AlphaToCoverage,    ///< which samples an alpha between 0 and 1 covers
  ResolveRounding,    ///< the average has no stated precision
  AttributePosition,   ///< undecorated inputs: anywhere in the fragment area
  Evaluation,          ///< interpolation has no stated precision: derived float32 evaluation bound
};

struct FreedomInfo {
  Freedom freedom;
  std::string_view id;      ///< "tie-owner"
  std::string_view anchor;  ///< "vk:primsrast-polygons-basic"
  std::string_view what;    ///< one sentence
};

[[nodiscard]] std::span<const FreedomInfo> freedoms();
[[nodiscard]] const FreedomInfo& info(Freedom freedom);

}  // namespace rasterdiff::rasterizer
