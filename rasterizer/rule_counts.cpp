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
}};

}  // namespace

std::span<const RuleInfo> countedRules() { return kRules; }

}  // namespace rasterdiff::rasterizer
