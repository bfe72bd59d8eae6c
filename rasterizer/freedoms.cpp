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
    FreedomInfo{LineCorner, "line-corner", "vk:primsrast-lines-basic",
                "the corners of a line's outline, and the cuts of its stipple, have no stated precision"},
    FreedomInfo{LineWidthStep, "line-width", "vk:limits-lineWidthRange",
                "widths between the advertised ones may be supported too"},
    FreedomInfo{PointSizeStep, "point-size", "vk:limits-pointSizeGranularity",
                "sizes between the advertised ones may be supported too, up to as far away as the nearest advertised one"},
    FreedomInfo{LineAlgorithm, "line-algorithm", "vk:primsrast-lines-basic",
                "without strictLines a line may be a parallelogram or follow the rules for Bresenham lines"},
    FreedomInfo{BresenhamDeviation, "bresenham-deviation", "vk:primsrast-lines-bresenham",
                "fragments may be one pixel aside, and there may be one more or one less"},
    FreedomInfo{SmoothLine, "smooth-line", "vk:primsrast-lines-smooth",
                "which pixels near a smooth line are covered, and how exactly alpha tells their covered area"},
    FreedomInfo{LineClip, "line-clip", "vk:vertexpostproc-clipping",
                "a line that leaves the clip volume may be cut or not, and its stipple may start anywhere"},
    FreedomInfo{StippleCarry, "stipple-carry", "vk:primsrast-lines-stipple",
                "the remainder of a stippled line may be carried to the next segment of its strip; along the edges of a polygon the "
                "pattern may start anywhere"},
    FreedomInfo{LineInterpolation, "line-interpolation", "vk:primsrast-lines-basic",
                "without strictLines, and in wide Bresenham lines, values follow the projection or the major axis"},
    FreedomInfo{CentroidPosition, "centroid-position", "vk:shaders-interpolation-decorations",
                "a centroid input may be evaluated anywhere in the fragment that the primitive covers"},
    FreedomInfo{OffsetRounding, "offset-rounding", "vk:limits-subPixelInterpolationOffsetBits",
                "an interpolation offset may be rounded to the advertised number of bits"},
    FreedomInfo{SampleShadingRate, "sample-shading-rate", "vk:primsrast-sampleshading",
                "how many samples above the minimum an invocation shades, and which, is not stated"},
    FreedomInfo{DepthBias, "depth-bias", "vk:primsrast-depthbias-computation",
                "the slope may be the gradient's length or its larger part, the fixed-point unit up to two steps, and lines and points may be biased or not"},
    FreedomInfo{PrimitiveOrder, "primitive-order", "vk:drawing-primitive-order",
                "the lines or points that a polygon mode makes of one triangle come in any order"},
    FreedomInfo{UndefinedDepth, "undefined-depth", "vk:fragops-depth",
                "a depth outside of the viewport's range is undefined without depth clamping"},
    FreedomInfo{ShaderSampleMask, "shader-sample-mask", "vk:fragops-shader-samplemask",
                "what the shader finds in SampleMask, and writes there, depends on samples whose coverage or invocation is free"},
    FreedomInfo{AlphaToCoverage, "alpha-to-coverage", "vk:fragops-covg",
                "which samples an alpha between 0 and 1 covers is not stated"},
    FreedomInfo{ResolveRounding, "resolve-rounding", "vk:VkResolveModeFlagBits",
                "the average of samples has no stated precision"},
    FreedomInfo{AttributePosition, "attribute-position", "vk:shaders-interpolation-decorations",
                "an undecorated input may be evaluated anywhere in the fragment's area"},
    FreedomInfo{Evaluation, "evaluation", "vk:primsrast-polygon-barycentrics",
                "interpolation has no stated precision: within the derived float32 evaluation bound"},
};

}  // namespace

std::span<const FreedomInfo> freedoms() { return kFreedoms; }

const FreedomInfo& info(Freedom freedom) { return kFreedoms[static_cast<size_t>(freedom)]; }

}  // namespace rasterdiff::rasterizer
