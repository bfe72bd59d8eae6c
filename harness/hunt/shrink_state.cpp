// Fewer inputs, and state back at its defaults.
#include <array>
#include <cmath>

#include "harness/hunt/shrink.hpp"

namespace rasterdiff::harness::hunt {
namespace {

using Change = void (*)(Scene&);

const std::array kChanges{
    Change{[](Scene& s) { s.state = State{.topology = s.state.topology}; }},
    Change{[](Scene& s) { s.target.depthFormat.reset(); }},
    Change{[](Scene& s) { s.target.sampleLocations.reset(); }},
    Change{[](Scene& s) {
      if (!s.target.sampleLocations) return;
      SampleLocationsInfo& info = *s.target.sampleLocations;
      info.gridWidth = info.gridHeight = 1;
      info.sampleLocations.resize(s.target.samples);
    }},
    Change{[](Scene& s) { s.target.samples = 1; }},
    Change{[](Scene& s) { if (s.target.samples > 4) s.target.samples = 4; }},
    Change{[](Scene& s) { s.target.resolve = false; }},
    Change{[](Scene& s) { s.target.supersample = 1; }},
    Change{[](Scene& s) { s.target.depthClearValue = 1; }},
    Change{[](Scene& s) { if (s.target.depthFormat) s.target.depthFormat = DepthFormat::D32_SFLOAT; }},
    Change{[](Scene& s) { s.scissor.reset(); }},
    Change{[](Scene& s) {
      s.furtherViewports.clear();
      for (Draw& draw : s.draws) draw.viewportIndex = 0;
    }},
    Change{[](Scene& s) {
      if (s.furtherViewports.empty()) return;
      s.viewport = s.furtherViewports.front().viewport;
      s.scissor = s.furtherViewports.front().scissor;
      s.furtherViewports.clear();
      for (Draw& draw : s.draws) draw.viewportIndex = 0;
    }},
    Change{[](Scene& s) { if (!s.furtherViewports.empty()) s.furtherViewports.pop_back(); }},
    Change{[](Scene& s) { for (ViewportAndScissor& v : s.furtherViewports) v.scissor.reset(); }},
    Change{[](Scene& s) { s.state.cullMode = CullMode::NONE; }},
    Change{[](Scene& s) { s.state.frontFace = FrontFace::COUNTER_CLOCKWISE; }},
    Change{[](Scene& s) { s.state.provokingVertexMode = ProvokingVertexMode::FIRST_VERTEX; }},
    Change{[](Scene& s) { s.state.depthTestEnable = false; }},
    Change{[](Scene& s) { s.state.depthWriteEnable = false; }},
    Change{[](Scene& s) { s.state.depthCompareOp = CompareOp::LESS; }},
    Change{[](Scene& s) { s.state.negativeOneToOne = false; }},
    Change{[](Scene& s) { s.state.primitiveRestartEnable = false; }},
    Change{[](Scene& s) { s.state.polygonMode = PolygonMode::FILL; }},
    Change{[](Scene& s) { s.state.depthClampEnable = false; }},
    Change{[](Scene& s) { s.state.depthClipEnable.reset(); }},
    Change{[](Scene& s) { s.state.depthBiasEnable = false; }},
    Change{[](Scene& s) { s.state.depthBiasConstantFactor = 0; }},
    Change{[](Scene& s) { s.state.depthBiasSlopeFactor = 0; }},
    Change{[](Scene& s) { s.state.depthBiasClamp = 0; }},
    Change{[](Scene& s) { s.state.lineWidth = 1; }},
    Change{[](Scene& s) { s.state.lineWidth = std::ceil(s.state.lineWidth); }},
    Change{[](Scene& s) { s.state.lineRasterizationMode = LineRasterizationMode::DEFAULT; }},
    Change{[](Scene& s) { s.state.stippledLineEnable = false; }},
    Change{[](Scene& s) { s.state.lineStippleFactor = 1; }},
    Change{[](Scene& s) { if (!s.state.stippledLineEnable) s.state.lineStipplePattern = 0xFFFF; }},
    Change{[](Scene& s) { s.state.pointSize = 1; }},
    Change{[](Scene& s) { s.state.pointSize = std::ceil(s.state.pointSize); }},
    Change{[](Scene& s) { s.state.sampleMask = ~uint32_t{0}; }},
    Change{[](Scene& s) { s.state.shaderSampleMask = ShaderSampleMask::NONE; }},
    Change{[](Scene& s) {
      if (s.state.shaderSampleMask == ShaderSampleMask::INPUT_SHIFTED) s.state.shaderSampleMask = ShaderSampleMask::CONSTANT;
    }},
    Change{[](Scene& s) { for (Draw& draw : s.draws) draw.shaderSampleMaskBits = Draw{}.shaderSampleMaskBits; }},
    Change{[](Scene& s) { s.state.sampleShadingEnable = false; }},
    Change{[](Scene& s) { s.state.minSampleShading = s.state.sampleShadingEnable ? 1.0F : 0.0F; }},
    Change{[](Scene& s) { s.state.alphaToCoverageEnable = false; }},
    Change{[](Scene& s) { s.viewport.minDepth = 0; s.viewport.maxDepth = 1; }},
    Change{[](Scene& s) {
      s.viewport = {0, 0, static_cast<float>(s.target.width), static_cast<float>(s.target.height), s.viewport.minDepth, s.viewport.maxDepth};
    }},
    Change{[](Scene& s) {
      if (s.viewport.height > 0) return;
      s.viewport.y += s.viewport.height;
      s.viewport.height = -s.viewport.height;
    }},
    Change{[](Scene& s) {
      for (float* f : {&s.viewport.x, &s.viewport.y, &s.viewport.width, &s.viewport.height}) *f = std::round(*f);
    }},
};

/// Column `gone` of `count` numbers a vertex.
void dropColumn(std::vector<float>& values, uint32_t count, uint32_t gone) {
  std::vector<float> rest;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i % count != gone) rest.push_back(values[i]);
  }
  values = std::move(rest);
}

bool dropDistances(Shrinking& s, uint32_t Draw::*count, std::vector<float> Draw::*distances) {
  bool any = false;
  for (uint32_t gone = s.scene().draws.front().*count; gone-- > 0;) {
    any |= s.edit([&](Scene& scene) {
      for (Draw& draw : scene.draws) {
        dropColumn(draw.*distances, draw.*count, gone);
        --(draw.*count);
      }
    });
  }
  return any;
}

bool dropVaryings(Shrinking& s) {
  bool any = false;
  for (size_t v = s.scene().draws.front().varyings.size(); v-- > 0;) {
    any |= s.edit([v](Scene& scene) {
      for (Draw& draw : scene.draws) draw.varyings.erase(draw.varyings.begin() + static_cast<std::ptrdiff_t>(v));
    });
  }
  for (size_t v = 0; v < s.scene().draws.front().varyings.size(); ++v) {
    for (uint32_t gone = s.scene().draws.front().varyings[v].components; gone-- > 0;) {
      if (s.scene().draws.front().varyings[v].components == 1) break;
      any |= s.edit([&](Scene& scene) {
        for (Draw& draw : scene.draws) dropColumn(draw.varyings[v].values, draw.varyings[v].components--, gone);
      });
    }
  }
  return any;
}

}  // namespace

bool dropInputs(Shrinking& s) {
  bool any = dropVaryings(s);
  for (size_t b = s.scene().builtIns.size(); b-- > 0;) {
    any |= s.edit([b](Scene& scene) { scene.builtIns.erase(scene.builtIns.begin() + static_cast<std::ptrdiff_t>(b)); });
  }
  any |= dropDistances(s, &Draw::clipDistanceCount, &Draw::clipDistances);
  any |= dropDistances(s, &Draw::cullDistanceCount, &Draw::cullDistances);
  any |= s.edit([](Scene& scene) { for (Draw& draw : scene.draws) draw.pointSizes.clear(); });
  return s.edit([](Scene& scene) {
    for (Draw& draw : scene.draws) {
      if (draw.pointSizes.empty()) continue;
      scene.state.pointSize = draw.pointSizes.front();
      draw.pointSizes.clear();
    }
  }) || any;
}

bool dropState(Shrinking& s) {
  bool any = false;
  for (const Change change : kChanges) any |= s.edit(change);
  return any;
}

}  // namespace rasterdiff::harness::hunt
