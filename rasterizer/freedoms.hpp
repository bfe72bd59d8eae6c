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
