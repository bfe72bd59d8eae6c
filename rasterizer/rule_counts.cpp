#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::rasterizer {
namespace {

// In the order of the enumeration.
constexpr std::array<RuleInfo, static_cast<size_t>(Rule::Count_)> kRules{{
    {Rule::ViewVolume, "R3", "view-volume", "vk:vertexpostproc-clipping"},
    {Rule::ProvokingVertex, "R11", "provoking-vertex", "vk:vertexpostproc-flatshading"},
    {Rule::Facing, "R12", "facing", "vk:primsrast-polygons-basic"},
    {Rule::Culling, "R13", "culling", "vk:primsrast-polygons-basic"},
    {Rule::SampleCoverage, "R14", "sample-coverage", "vk:primsrast-polygons-basic"},
    {Rule::TieBreak, "R15", "tie-break", "vk:primsrast-polygons-basic"},
    {Rule::SamplePattern, "R17", "sample-pattern", "vk:primsrast-multisampling"},
    {Rule::Perspective, "R21", "perspective", "vk:primsrast-polygon-barycentrics"},
    {Rule::DepthTest, "R38", "depth-test", "vk:fragops-depth"},
    {Rule::Scissor, "R39", "scissor", "vk:fragops-scissor"},
    {Rule::Order, "R50", "order", "vk:primsrast-order"},
    {Rule::DepthClip, "R4", "depth-clip", "vk:vertexpostproc-clipping"},
    {Rule::UserDistance, "R5", "user-distance", "vk:vertexpostproc-clipping"},
    {Rule::PointClip, "R7", "point-clip", "vk:vertexpostproc-clipping"},
    {Rule::LineClip, "R8", "line-clip", "vk:vertexpostproc-clipping"},
    {Rule::PointSquare, "R25", "point-square", "vk:primsrast-points"},
    {Rule::LineRectangle, "R27", "line-rectangle", "vk:primsrast-lines-basic"},
    {Rule::LineBresenham, "R29", "line-bresenham", "vk:primsrast-lines-bresenham"},
    {Rule::LineStipple, "R32", "line-stipple", "vk:primsrast-lines-stipple"},
    {Rule::PolygonMode, "R34", "polygon-mode", "vk:primsrast-polygonmode"},
    {Rule::CoverageMask, "R16", "coverage-mask", "vk:primsrast-multisampling-coverage-mask"},
    {Rule::SampleShading, "R19", "sample-shading", "vk:primsrast-sampleshading"},
    {Rule::AttributeLocation, "R20", "attribute-location", "vk:shaders-interpolation-decorations"},
    {Rule::FragCoord, "R23", "frag-coord", "vk:interfaces-builtin-variables-fragcoord"},
    {Rule::SampleMaskIn, "R24", "sample-mask-in", "vk:interfaces-builtin-variables-samplemask"},
    {Rule::PointCoord, "R25", "point-coord", "vk:primsrast-points-basic"},
    {Rule::DepthBiasSlope, "R35", "depth-bias-slope", "vk:primsrast-depthbias-computation"},
    {Rule::DepthBiasUnit, "R36", "depth-bias-unit", "vk:primsrast-depthbias-computation"},
    {Rule::DepthBiasMode, "R37", "depth-bias-mode", "vk:primsrast-depthbias-computation"},
    {Rule::DepthClamp, "R38", "depth-clamp", "vk:fragops-depth"},
    {Rule::DepthConversion, "R38", "depth-conversion", "vk:fundamentals-fpfixedconv"},
    {Rule::SampleMask, "R40", "sample-mask", "vk:fragops-samplemask"},
    {Rule::AlphaToCoverage, "R41", "alpha-to-coverage", "vk:fragops-covg"},
    {Rule::Resolve, "R42", "resolve", "vk:VkResolveModeFlagBits"},
    {Rule::FrontFacing, "R44", "front-facing", "vk:interfaces-builtin-variables-frontfacing"},
    {Rule::InterpolationOffset, "R48", "interpolation-offset", "vk:limits-subPixelInterpolationOffsetBits"},
    {Rule::Division, "R1", "division", "vk:vertexpostproc-coord-transform"},
    {Rule::ViewportMap, "R2", "viewport", "vk:vertexpostproc-viewport"},
    {Rule::Partition, "R6", "partition", "vk:vertexpostproc-clipping"},
    {Rule::ClipAttribute, "R9", "clip-attribute", "vk:vertexpostproc-clipping-shader-outputs"},
    {Rule::CutPolygon, "R10", "cut-polygon", "vk:primsrast-polygons"},
    {Rule::LinearDepth, "R22", "linear-depth", "vk:primsrast-polygon-barycentrics"},
    {Rule::DefaultPointSize, "R26", "default-point-size", "vk:primsrast-points"},
    {Rule::DefaultLine, "R28", "default-line", "vk:primsrast-lines-basic"},
    {Rule::WideBresenham, "R30", "wide-bresenham", "vk:primsrast-lines-bresenham"},
    {Rule::BresenhamSamples, "R31", "bresenham-samples", "vk:primsrast-lines-bresenham"},
    {Rule::HelperInvocation, "R43", "helper-invocation", "vk:shaders-helper-invocations"},
    {Rule::Invariance, "R49", "invariance", "vk:invariance"},
    {Rule::CustomLocations, "R18", "custom-locations", "vk:primsrast-samplelocations"},
    {Rule::SmoothLine, "R33", "smooth-line", "vk:primsrast-lines-smooth"},
    {Rule::SizeGranularity, "R51", "size-granularity", "vk:limits-lineWidthRange"},
    {Rule::ShaderSampleMask, "R40", "shader-sample-mask", "vk:fragops-covg"},
}};

}  // namespace

std::span<const RuleInfo> countedRules() { return kRules; }

}  // namespace rasterdiff::rasterizer
