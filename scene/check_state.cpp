// Checks of the pipeline state and of what it asks of target, topology, varyings and built-ins.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/built_ins.hpp"
#include "scene/checks.hpp"
#include "scene/file/enum_names.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::checks {
namespace {

template <class E>
Check checkEnumerant(const char* field, E value) {
  if (!enumName(value).empty()) return {};
  return bad(fmt::format("state.{}", field), fmt::format("{} is no enumerant", static_cast<uint32_t>(value)));
}

Check checkEnumerants(const State& state) {
  if (auto ok = checkEnumerant("topology", state.topology); !ok) return ok;
  if (auto ok = checkEnumerant("cullMode", state.cullMode); !ok) return ok;
  if (auto ok = checkEnumerant("frontFace", state.frontFace); !ok) return ok;
  if (auto ok = checkEnumerant("provokingVertexMode", state.provokingVertexMode); !ok) return ok;
  if (auto ok = checkEnumerant("depthCompareOp", state.depthCompareOp); !ok) return ok;
  if (auto ok = checkEnumerant("polygonMode", state.polygonMode); !ok) return ok;
  if (auto ok = checkEnumerant("shaderSampleMask", state.shaderSampleMask); !ok) return ok;
  return checkEnumerant("lineRasterizationMode", state.lineRasterizationMode);
}

Check checkSize(const char* field, float value) {
  if (std::isfinite(value) && value > 0) return {};
  return bad(fmt::format("state.{}", field), fmt::format("{} pixels; a size is finite and above 0", value));
}

Check checkFinite(const char* field, float value) {
  if (std::isfinite(value)) return {};
  return bad(fmt::format("state.{}", field), fmt::format("{} is not finite", value));
}

Check checkPrimitives(const State& state, uint32_t supersample) {
  if (state.polygonMode != PolygonMode::FILL && topologyClassOf(state.topology) != TopologyClass::Triangle) {
    return bad("state.polygonMode",
               fmt::format("{} where {} makes no polygons", enumName(state.polygonMode), enumName(state.topology)),
               "choose a TRIANGLE_ topology or leave polygonMode out");
  }
  if (auto ok = checkSize("lineWidth", state.lineWidth); !ok) return ok;
  if (auto ok = checkSize("pointSize", state.pointSize); !ok) return ok;
  // [vk:VkPipelineRasterizationLineStateCreateInfo] 1..256
  if (state.lineStippleFactor < 1 || state.lineStippleFactor > kMaxLineStippleFactor) {
    return bad("state.lineStippleFactor",
               fmt::format("{} is outside 1..{}", state.lineStippleFactor, kMaxLineStippleFactor));
  }
  if (!state.stippledLineEnable) return {};
  if (!drawsLines(state)) {
    return bad("state.stippledLineEnable", "a stipple pattern without lines",
               "choose a LINE_ topology or polygonMode LINE");
  }
  if (state.lineStippleFactor * supersample > kMaxLineStippleFactor) {
    return bad("state.lineStippleFactor", fmt::format("{}, supersampled {} times, exceeds {}", state.lineStippleFactor,
                                                      supersample, kMaxLineStippleFactor));
  }
  return {};
}

Check checkDepth(const Scene& scene) {
  const State& state = scene.state;
  if (!scene.target.depthFormat && (state.depthTestEnable || state.depthWriteEnable)) {
    return bad(state.depthTestEnable ? "state.depthTestEnable" : "state.depthWriteEnable",
               "depth state without a depth attachment", "set target.depthFormat to D32_SFLOAT");
  }
  if (auto ok = checkFinite("depthBiasConstantFactor", state.depthBiasConstantFactor); !ok) return ok;
  if (auto ok = checkFinite("depthBiasClamp", state.depthBiasClamp); !ok) return ok;
  return checkFinite("depthBiasSlopeFactor", state.depthBiasSlopeFactor);
}

/// Inputs with `sample` make devices shade samples one by one, in the passes that read them: what those find in SampleMask is then
/// alike in all passes only where every invocation has one sample.
Check checkShaderSampleMask(const Scene& scene) {
  const State& state = scene.state;
  if (state.shaderSampleMask != ShaderSampleMask::INPUT_SHIFTED || scene.target.samples == 1) return {};
  if (state.sampleShadingEnable && state.minSampleShading == 1) return {};
  const std::vector<Varying>& varyings = scene.draws.front().varyings;
  const auto atSample = [](const Varying& varying) { return varying.interpolation == Interpolation::sample; };
  if (std::none_of(varyings.begin(), varyings.end(), atSample)) return {};
  return bad("state.shaderSampleMask",
             "INPUT_SHIFTED with an input of interpolation sample: how many samples an invocation finds in SampleMask is not stated",
             "set sampleShadingEnable and \"minSampleShading\": 1, or shaderSampleMask to CONSTANT");
}

Check checkSamples(const Scene& scene) {
  const State& state = scene.state;
  if (!(state.minSampleShading >= 0 && state.minSampleShading <= 1)) {
    return bad("state.minSampleShading", fmt::format("{} is outside 0..1", state.minSampleShading));
  }
  if (state.alphaToCoverageEnable && scene.target.samples == 1) {
    return bad("state.alphaToCoverageEnable", "alpha makes no coverage of one sample a pixel",
               "set target.samples to 4");
  }
  if (scene.draws.empty()) return {};
  const std::vector<Varying>& varyings = scene.draws.front().varyings;
  if (state.alphaToCoverageEnable && (varyings.empty() || varyings.front().components != 4)) {
    return bad("state.alphaToCoverageEnable", "alpha is missing", "give the first varying four components");
  }
  if (auto ok = checkShaderSampleMask(scene); !ok) return ok;
  if (scene.target.resolve && varyings.empty()) {
    return bad("target.resolve", "nothing to resolve: the draws have no varyings", "add a varying to every draw");
  }
  return {};
}

}  // namespace

Check checkState(const Scene& scene) {
  if (auto ok = checkEnumerants(scene.state); !ok) return ok;
  if (auto ok = checkPrimitives(scene.state, scene.target.supersample); !ok) return ok;
  if (auto ok = checkDepth(scene); !ok) return ok;
  return checkSamples(scene);
}

Check checkBuiltIns(const Scene& scene) {
  for (size_t i = 0; i < scene.builtIns.size(); ++i) {
    const std::string where = fmt::format("builtIns[{}]", i);
    const BuiltIn builtIn = scene.builtIns[i];
    const std::string_view name = builtInName(builtIn);
    if (name.empty()) return bad(where, fmt::format("{} is no built-in", static_cast<uint32_t>(builtIn)));
    if (std::find(scene.builtIns.begin(), scene.builtIns.begin() + static_cast<ptrdiff_t>(i), builtIn) !=
        scene.builtIns.begin() + static_cast<ptrdiff_t>(i)) {
      return bad(where, fmt::format("{} a second time", name));
    }
    const bool points =
        scene.state.topology == PrimitiveTopology::POINT_LIST || scene.state.polygonMode == PolygonMode::POINT;
    if (builtIn == BuiltIn::PointCoord && !points) {
      return bad(where, "PointCoord has no value where no points are drawn", "choose POINT_LIST or polygonMode POINT");
    }
  }
  return {};
}

}  // namespace rasterdiff::checks
