#include "harness/hunt/traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rasterizer/assembly.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness::hunt {
namespace {

constexpr std::array<std::string_view, static_cast<size_t>(Trait::Count_)> kNames{
    "points", "lines", "triangles", "strip", "fan", "indexed", "restart", "several-draws", "several-primitives", "no-area", "between-no-area", "alone-of-three",
    "multisampled", "polygon-line", "polygon-point", "culled", "clockwise", "last-provoking",
    "scissor", "viewport-elsewhere", "viewport-flipped", "depth-range", "several-viewports",
    "leaves-sides", "leaves-depth", "no-positive-w", "perspective", "negative-one-to-one",
    "depth", "depth-unorm", "depth-test", "depth-bias", "depth-clamp", "depth-clip-stated",
    "wide-line", "bresenham", "rectangular", "smooth-line", "second-alpha", "stipple", "large-point", "small-point",
    "clip-distance", "cull-distance", "cull-behind-clip", "sample-mask", "sample-mask-at-one-sample", "shader-mask", "shader-mask-shifted", "sample-shading", "alpha-to-coverage", "resolve", "sample-locations",
    "smooth", "noperspective", "flat", "centroid", "sample", "offset",
    "frag-coord", "front-facing", "point-coord", "sample-mask-in", "sample-id", "sample-position",
    "non-finite"};

class Collector {
 public:
  explicit Collector(const Scene& scene) : scene_(scene) {}

  Traits collect() {
    primitives();
    views();
    depth();
    samples();
    for (const Draw& draw : scene_.draws) vertices(draw);
    inputs();
    return traits_;
  }

 private:
  void set(Trait trait, bool on = true) {
    if (on) traits_.set(static_cast<size_t>(trait));
  }

  void primitives() {
    using enum PrimitiveTopology;
    const State& state = scene_.state;
    const PrimitiveTopology topology = state.topology;
    const bool triangles = topologyClassOf(topology) == TopologyClass::Triangle;
    set(Trait::Points, topology == POINT_LIST);
    set(Trait::Lines, topology == LINE_LIST || topology == LINE_STRIP);
    set(Trait::Triangles, triangles);
    set(Trait::Strip, topology == LINE_STRIP || topology == TRIANGLE_STRIP);
    set(Trait::Fan, topology == TRIANGLE_FAN);
    set(Trait::PolygonLine, state.polygonMode == PolygonMode::LINE);
    set(Trait::PolygonPoint, state.polygonMode == PolygonMode::POINT);
    set(Trait::Culled, triangles && state.cullMode != CullMode::NONE);
    set(Trait::Clockwise, state.frontFace == FrontFace::CLOCKWISE);
    set(Trait::LastProvoking, state.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX);
    set(Trait::SeveralDraws, scene_.draws.size() > 1);
    uint32_t primitives = 0;
    bool ownSizes = false;
    for (const Draw& draw : scene_.draws) {
      primitives += primitiveCount(state, draw);
      set(Trait::Indexed, draw.indices.has_value());
      if (triangles) areas(draw);
      const auto indices = draw.indices.value_or(std::vector<uint32_t>{});
      set(Trait::Restart, std::find(indices.begin(), indices.end(), kRestartIndex) != indices.end());
      ownSizes = ownSizes || !draw.pointSizes.empty();
      for (const float size : draw.pointSizes) pointSize(size);
    }
    set(Trait::SeveralPrimitives, primitives > 1);
    if (topology == POINT_LIST || state.polygonMode == PolygonMode::POINT) {
      if (!ownSizes) pointSize(state.pointSize);
    }
    if (!traits_[static_cast<size_t>(Trait::Lines)] && state.polygonMode != PolygonMode::LINE) return;
    set(Trait::WideLine, state.lineWidth != 1);
    set(Trait::Bresenham, state.lineRasterizationMode == LineRasterizationMode::BRESENHAM);
    set(Trait::Rectangular, state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR);
    set(Trait::SmoothLine, state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH);
    set(Trait::Stipple, state.stippledLineEnable);
  }

  // Triangles with two corners in one place; of a list of three, two that have all three there.
  void areas(const Draw& draw) {
    const auto same = [&](uint32_t a, uint32_t b) { return draw.positions[a] == draw.positions[b]; };
    bool before = false, between = false;
    const std::vector<rasterizer::AssembledTriangle> all = rasterizer::assemble(draw, scene_.state);
    const auto inOnePlace = [&](const rasterizer::AssembledTriangle& t) { return same(t.vertices[0], t.vertices[1]) && same(t.vertices[1], t.vertices[2]); };
    set(Trait::AloneOfThree, scene_.state.topology == PrimitiveTopology::TRIANGLE_LIST && all.size() == 3 && std::ranges::count_if(all, inOnePlace) == 2);
    for (const rasterizer::AssembledTriangle& t : all) {
      const bool noArea = same(t.vertices[0], t.vertices[1]) || same(t.vertices[1], t.vertices[2]) || same(t.vertices[2], t.vertices[0]);
      set(Trait::BetweenNoArea, noArea && between);
      before = before || noArea;
      between = between || (before && !noArea);
    }
    set(Trait::NoArea, before);
  }

  void pointSize(float size) {
    set(Trait::LargePoint, size > 1);
    set(Trait::SmallPoint, size < 1);
  }

  void view(const Viewport& v) {
    const Target& target = scene_.target;
    set(Trait::ViewportElsewhere, v.x != 0 || v.width != static_cast<float>(target.width) ||
                                      std::min(v.y, v.y + v.height) != 0 ||
                                      std::fabs(v.height) != static_cast<float>(target.height));
    set(Trait::ViewportFlipped, v.height < 0);
    set(Trait::DepthRange, v.minDepth != 0 || v.maxDepth != 1);
  }

  void views() {
    view(scene_.viewport);
    set(Trait::Scissor, scene_.scissor.has_value());
    for (const ViewportAndScissor& further : scene_.furtherViewports) {
      view(further.viewport);
      set(Trait::Scissor, further.scissor.has_value());
    }
    set(Trait::SeveralViewports, !scene_.furtherViewports.empty());
  }

  void depth() {
    const State& state = scene_.state;
    const auto format = scene_.target.depthFormat;
    set(Trait::Depth, format.has_value());
    set(Trait::DepthUnorm, format && *format != DepthFormat::D32_SFLOAT && *format != DepthFormat::D32_SFLOAT_S8_UINT);
    set(Trait::DepthTest, state.depthTestEnable);
    set(Trait::DepthBias, state.depthBiasEnable);
    set(Trait::DepthClamp, state.depthClampEnable);
    set(Trait::DepthClipStated, state.depthClipEnable.has_value());
    set(Trait::NegativeOneToOne, state.negativeOneToOne);
  }

  void samples() {
    const uint32_t samples = scene_.target.samples;
    const uint32_t all = samples >= 32 ? ~uint32_t{0} : (uint32_t{1} << samples) - 1;
    set(Trait::Multisampled, samples > 1);
    set(samples > 1 ? Trait::SampleMask : Trait::SampleMaskAtOneSample, (scene_.state.sampleMask & all) != all);
    set(Trait::ShaderMask, scene_.state.shaderSampleMask == ShaderSampleMask::CONSTANT);
    set(Trait::ShaderMaskShifted, scene_.state.shaderSampleMask == ShaderSampleMask::INPUT_SHIFTED);
    set(Trait::SampleShading, scene_.state.sampleShadingEnable);
    set(Trait::AlphaToCoverage, scene_.state.alphaToCoverageEnable);
    set(Trait::Resolve, scene_.target.resolve);
    set(Trait::SampleLocations, scene_.target.sampleLocations.has_value());
  }

  /// Laid out one after the other, four a location: do cull distances begin behind clip distances in the first one, and end in the second?
  static bool cullLiesAcross(const Draw& draw) {
    return draw.clipDistanceCount > 0 && draw.clipDistanceCount < 4 && draw.clipDistanceCount + draw.cullDistanceCount > 4;
  }

  void vertices(const Draw& draw) {
    set(Trait::ClipDistance, draw.clipDistanceCount > 0);
    set(Trait::CullDistance, draw.cullDistanceCount > 0);
    set(Trait::CullBehindClip, cullLiesAcross(draw));
    for (const ClipPosition& p : draw.positions) {
      set(Trait::NonFinite, !std::isfinite(p.x + p.y + p.z + p.w));
      set(Trait::NoPositiveW, !(p.w > 0));
      set(Trait::Perspective, p.w != draw.positions.front().w);
      set(Trait::LeavesSides, !(std::fabs(p.x) <= p.w && std::fabs(p.y) <= p.w));
      set(Trait::LeavesDepth, !(p.z <= p.w && p.z >= (scene_.state.negativeOneToOne ? -p.w : 0)));
    }
  }

  void inputs() {
    if (scene_.draws.empty()) return;
    const std::vector<Varying>& varyings = scene_.draws.front().varyings;
    for (size_t location = 0; location < varyings.size(); ++location) {
      const Varying& varying = varyings[location];
      set(Trait::SecondAlpha, location > 0 && varying.components == 4);
      set(static_cast<Trait>(static_cast<uint8_t>(Trait::Smooth) + static_cast<uint8_t>(varying.interpolation)));
    }
    for (const BuiltIn builtIn : scene_.builtIns) {
      set(Trait::SecondAlpha, builtIn == BuiltIn::FragCoord);  // location 0 has the primitive's number, or a varying
      set(static_cast<Trait>(static_cast<uint8_t>(Trait::FragCoord) + static_cast<uint8_t>(builtIn)));
    }
  }

  const Scene& scene_;
  Traits traits_;
};

}  // namespace

std::string_view nameOf(Trait trait) { return kNames[static_cast<size_t>(trait)]; }

Traits traitsOf(const Scene& scene) { return Collector(scene).collect(); }

Traits traitsNamed(std::string_view names) {
  Traits traits;
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(' '));
    for (size_t t = 0; t < traits.size(); ++t) {
      if (nameOf(static_cast<Trait>(t)) == name) traits.set(t);
    }
    names.remove_prefix(std::min(names.size(), name.size() + 1));
  }
  return traits;
}

std::string namesOf(const Traits& traits, char separator) {
  std::string names;
  for (size_t t = 0; t < traits.size(); ++t) {
    if (!traits[t]) continue;
    if (!names.empty()) names += separator;
    names += kNames[t];
  }
  return names;
}

}  // namespace rasterdiff::harness::hunt
