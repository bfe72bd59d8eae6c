#include "rasterizer/freedoms.hpp"

#include <array>

namespace rasterdiff::rasterizer {
namespace {

using enum Freedom;

// In the order of the enumeration, so that info() is an index.
constexpr std::array kFreedoms{
    FreedomInfo{None, "none", "", "no freedom: there is one answer"},
    FreedomInfo{TieOwner, "tie-owner", "vk:primsrast-polygons-basic",
                "the sample lies exactly on an edge, and which polygon owns it is not stated"},
    FreedomInfo{SnapRounding, "snap-rounding", "vk:limits-subPixelPrecisionBits",
                "a vertex may go to a neighbouring point of the subpixel grid"},
    FreedomInfo{ViewportArithmetic, "viewport-arithmetic", "vk:vertexpostproc-viewport",
                "division by w and the viewport transform have no stated precision"},
    FreedomInfo{ViewportBounds, "viewport-bounds", "vk:limits-viewportSubPixelBits",
                "viewport bounds are honoured only to viewportSubPixelBits"},
    FreedomInfo{ClipVertexPosition, "clip-vertex-position", "vk:vertexpostproc-clipping",
                "vertices that clipping makes have no stated precision"},
    FreedomInfo{NearZeroArea, "near-zero-area", "vk:primsrast-polygons-basic",
                "the sign of the area, and so the facing, depends on a legal snapping"},
    FreedomInfo{DivisionByZero, "division-by-zero", "vk:vertexpostproc-coord-transform",
                "a vertex at the origin of clip space is inside the view volume, but dividing by its w is undefined"},
    FreedomInfo{AttributePosition, "attribute-position", "vk:shaders-interpolation-decorations",
                "an undecorated input may be evaluated anywhere in the fragment's area"},
    FreedomInfo{Evaluation, "evaluation", "vk:primsrast-polygon-barycentrics",
                "interpolation has no stated precision: within the derived float32 evaluation bound"},
};

}  // namespace

std::span<const FreedomInfo> freedoms() { return kFreedoms; }

const FreedomInfo& info(Freedom freedom) { return kFreedoms[static_cast<size_t>(freedom)]; }

}  // namespace rasterdiff::rasterizer
