// Which rules had a part in the answer at one sample: those that decided a primitive there, then those of the scene's
// state that every such answer went through.
#include <algorithm>
#include <cmath>

#include "rasterizer/explain.hpp"
#include "rasterizer/lines/smooth_line.hpp"
#include "scene/needs.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Kind = PrimitiveExplanation::Kind;

class RuleList {
 public:
  void add(Rule rule) {
    if (std::ranges::find(rules, rule) == rules.end()) rules.push_back(rule);
  }
  void addIf(bool condition, Rule rule) {
    if (condition) add(rule);
  }
  std::vector<Rule> rules;
};

bool leavesViewport(const Scene& scene, const PrimitiveExplanation& point) {
  const Viewport& v = scene.viewport;
  const double half = point.size / 2, x = point.ends[0].x, y = point.ends[0].y;
  const double low = std::min(v.y, v.y + v.height), high = std::max(v.y, v.y + v.height);
  return x - half < v.x || x + half > double{v.x} + v.width || y - half < low || y + half > high;
}

void addGeometry(RuleList& list, const Scene& scene, const PrimitiveExplanation& e) {
  const State& state = scene.state;
  for (const Rule rule : e.shapeRules) list.add(rule);
  list.addIf(e.kind == Kind::Triangle, Rule::SampleCoverage);
  list.addIf(e.kind == Kind::Triangle && !e.covered, Rule::HelperInvocation);
  list.addIf(e.kind != Kind::Point && state.stippledLineEnable, Rule::LineStipple);
  list.addIf(e.kind == Kind::Point && leavesViewport(scene, e), Rule::PointClip);
  list.addIf(e.clipped, e.vertices == 2 ? Rule::LineClip : Rule::ViewVolume);
  list.addIf(e.clipped && needsOf(scene).varyings > 0, Rule::ClipAttribute);
  list.addIf(e.clipped && e.vertices == 3 && needsOf(scene).varyings > 0, Rule::CutPolygon);
  const auto vertices = std::span(e.clip).first(e.vertices);
  list.addIf(std::ranges::any_of(vertices, [](const ClipPosition& p) { return p.w != 1; }), Rule::Division);
}

bool leavesDepthRange(const Draw& draw) {
  return std::ranges::any_of(draw.positions, [](const ClipPosition& p) { return p.z < 0 || p.z > p.w; });
}

void addState(RuleList& list, const Scene& scene) {
  const State& state = scene.state;
  const bool triangles = topologyClassOf(state.topology) == TopologyClass::Triangle;
  const auto anyDraw = [&](auto&& is) { return std::ranges::any_of(scene.draws, is); };
  list.addIf(!isList(state.topology) || anyDraw([](const Draw& draw) { return draw.indices.has_value(); }), Rule::ProvokingVertex);
  list.addIf(triangles && state.cullMode != CullMode::NONE, Rule::Facing);
  list.addIf(triangles && state.cullMode != CullMode::NONE, Rule::Culling);
  list.addIf(triangles && state.polygonMode != PolygonMode::FILL, Rule::PolygonMode);
  list.addIf(anyDraw([](const Draw& draw) { return draw.clipDistanceCount + draw.cullDistanceCount > 0; }), Rule::UserDistance);
  list.addIf(anyDraw([](const Draw& draw) { return draw.clipDistanceCount > 0; }), Rule::Partition);
  list.addIf(state.depthClampEnable || state.depthClipEnable.has_value() || anyDraw(leavesDepthRange), Rule::DepthClip);
  list.addIf(state.negativeOneToOne || needsClipping(scene), Rule::ViewVolume);
  list.addIf(scene.target.samples > 1, Rule::SamplePattern);
  list.addIf(scene.scissor.has_value() || !scene.furtherViewports.empty(), Rule::Scissor);
  list.addIf(state.sampleMask != State{}.sampleMask, Rule::SampleMask);
  list.addIf(state.shaderSampleMask != ShaderSampleMask::NONE, Rule::ShaderSampleMask);
  list.addIf(state.alphaToCoverageEnable, Rule::AlphaToCoverage);
  list.addIf(scene.target.depthFormat.has_value(), Rule::DepthTest);
  list.addIf(scene.scissor.has_value() || state.depthTestEnable, Rule::Invariance);
  // What is drawn too large or too far away by a driver need not be near in the reference.
  const bool bresenham = state.lineRasterizationMode == LineRasterizationMode::BRESENHAM;
  list.addIf(drawsPoints(state), Rule::PointSquare);
  list.addIf(drawsLines(state), bresenham ? Rule::LineBresenham : Rule::LineRectangle);
  list.addIf(drawsSmoothLines(state), Rule::SmoothLine);
  list.add(Rule::ViewportMap);
}

void addDepth(RuleList& list, const Scene& scene) {
  const State& state = scene.state;
  if (!scene.target.depthFormat) return;
  list.add(Rule::LinearDepth);
  const bool figures = !fillsTriangles(state);
  list.addIf(state.depthBiasEnable && figures, Rule::DepthBiasMode);
  list.addIf(state.depthBiasEnable && state.depthBiasConstantFactor != 0, Rule::DepthBiasUnit);
  list.addIf(state.depthBiasEnable && (state.depthBiasSlopeFactor != 0 || state.depthBiasClamp != 0), Rule::DepthBiasSlope);
  list.addIf(state.depthClampEnable, Rule::DepthClamp);
  list.addIf(scene.target.depthFormat != DepthFormat::D32_SFLOAT, Rule::DepthConversion);
  list.addIf(scene.draws.size() > 1, Rule::Invariance);
}

void addValues(RuleList& list, const Scene& scene) {
  if (!scene.draws.empty()) {
    for (const Varying& varying : scene.draws[0].varyings) {
      const bool flat = varying.interpolation == Interpolation::flat;
      list.addIf(flat, Rule::ProvokingVertex);
      list.addIf(varying.interpolation == Interpolation::offset, Rule::InterpolationOffset);
      list.addIf(!flat, Rule::Perspective);
      list.addIf(!flat, Rule::AttributeLocation);
    }
  }
  for (const BuiltIn builtIn : scene.builtIns) {
    switch (builtIn) {
      case BuiltIn::FragCoord: list.add(Rule::FragCoord); break;
      case BuiltIn::FrontFacing: list.add(Rule::FrontFacing); list.add(Rule::Facing); break;
      case BuiltIn::PointCoord: list.add(Rule::PointCoord); break;
      case BuiltIn::SampleMask: list.add(Rule::SampleMaskIn); list.add(Rule::CoverageMask); break;
      case BuiltIn::SampleId:
      case BuiltIn::SamplePosition: list.add(Rule::SampleShading); break;
    }
  }
  list.addIf(scene.state.sampleShadingEnable, Rule::SampleShading);
  list.addIf(scene.target.resolve, Rule::Resolve);
}

}  // namespace

std::vector<Rule> rulesAtWork(const Scene& scene, const SampleExplanation& sample) {
  RuleList list;
  // The primitive that has the sample, then the others, the last one first.
  for (const bool owners : {true, false}) {
    for (auto e = sample.primitives.rbegin(); e != sample.primitives.rend(); ++e) {
      if ((e->primitive == sample.owner) == owners) list.add(e->decidedBy);
    }
  }
  size_t covering = 0;
  for (const PrimitiveExplanation& e : sample.primitives) {
    covering += e.covered ? 1U : 0U;
    addGeometry(list, scene, e);
  }
  list.addIf(covering > 1, Rule::Order);
  addDepth(list, scene);
  addValues(list, scene);
  addState(list, scene);
  for (const Rejection& rejection : sample.rejections) {
    list.add(rejection.rule);
    list.addIf(rejection.rule == Rule::DepthClip, Rule::ViewVolume);
  }
  return list.rules;
}

}  // namespace rasterdiff::rasterizer
