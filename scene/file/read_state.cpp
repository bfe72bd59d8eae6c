// Target, viewports, scissors, built-ins and pipeline state of a scene file.
#include <array>

#include "scene/file/read_scene.hpp"

namespace rasterdiff {

namespace {

/// `samples` of the target are known.
bool readSampleLocations(Reader& reader, const JsonValue& value, uint32_t samples, SampleLocationsInfo& out) {
  static constexpr std::array<std::string_view, 3> kFields{"sampleLocationsPerPixel", "sampleLocationGridSize",
                                                           "sampleLocations"};
  if (!reader.object(value, "sample locations", kFields, {"sampleLocations"})) return false;
  if (const auto v = value.member("sampleLocationsPerPixel")) {
    uint32_t perPixel = 0;
    if (!reader.unsigned32(*v, perPixel)) return false;
    if (perPixel != samples) {
      return reader.fail(*v, fmt::format("{} locations a pixel of {} samples", perPixel, samples), "as many as samples");
    }
  }
  if (const auto v = value.member("sampleLocationGridSize")) {
    if (!reader.array(*v, "a grid size")) return false;
    if (v->size() != 2) return reader.fail(*v, fmt::format("a grid size of {} numbers", v->size()), "[width, height]");
    if (!reader.unsigned32(v->first(), out.gridWidth) || !reader.unsigned32(v->first().next(), out.gridHeight)) return false;
  }
  const JsonValue list = *value.member("sampleLocations");
  if (!reader.array(list, "sampleLocations")) return false;
  JsonValue location = list.first();
  for (uint32_t i = 0; i < list.size(); ++i, location = location.next()) {
    if (!reader.array(location, "a sample location")) return false;
    if (location.size() != 2) return reader.fail(location, fmt::format("a location of {} numbers", location.size()), "[x, y]");
    SampleLocationEXT& to = out.sampleLocations.emplace_back();
    if (!reader.float32(location.first(), to.x) || !reader.float32(location.first().next(), to.y)) return false;
  }
  return true;
}

}  // namespace

bool readTarget(Reader& reader, const JsonValue& value, Target& target) {
  static constexpr std::array<std::string_view, 9> kFields{
      "width",       "height",          "samples",          "supersample",    "resolve",
      "depthFormat", "depthClearValue", "depthResolveMode", "sampleLocations"};
  if (!reader.object(value, "target", kFields, {"width", "height"})) return false;
  if (!reader.unsigned32(*value.member("width"), target.width)) return false;
  if (!reader.unsigned32(*value.member("height"), target.height)) return false;
  if (const auto v = value.member("samples"); v && !reader.unsigned32(*v, target.samples)) return false;
  if (const auto v = value.member("supersample"); v && !reader.unsigned32(*v, target.supersample)) return false;
  if (const auto v = value.member("resolve"); v && !reader.boolean(*v, target.resolve)) return false;
  if (const auto v = value.member("depthFormat")) {
    if (!reader.enumerant(*v, "depthFormat", target.depthFormat.emplace())) return false;
  }
  if (const auto v = value.member("depthResolveMode")) {
    if (!reader.enumerant(*v, "depthResolveMode", target.depthResolveMode.emplace())) return false;
  }
  if (const auto v = value.member("depthClearValue"); v && !reader.float32(*v, target.depthClearValue)) return false;
  if (const auto v = value.member("sampleLocations")) {
    return readSampleLocations(reader, *v, target.samples, target.sampleLocations.emplace());
  }
  return true;
}

bool readViewport(Reader& reader, const JsonValue& value, Viewport& viewport) {
  static constexpr std::array<std::string_view, 6> kFields{"x", "y", "width", "height", "minDepth", "maxDepth"};
  if (!reader.object(value, "viewport", kFields, {"width", "height"})) return false;
  const std::array<float*, 6> to{&viewport.x,      &viewport.y,        &viewport.width,
                                 &viewport.height, &viewport.minDepth, &viewport.maxDepth};
  for (size_t i = 0; i < kFields.size(); ++i) {
    if (const auto v = value.member(kFields[i]); v && !reader.float32(*v, *to[i])) return false;
  }
  return true;
}

bool readScissor(Reader& reader, const JsonValue& value, Rect2D& scissor) {
  static constexpr std::array<std::string_view, 4> kFields{"x", "y", "width", "height"};
  if (!reader.object(value, "scissor", kFields, {"width", "height"})) return false;
  if (const auto v = value.member("x"); v && !reader.signed32(*v, scissor.x)) return false;
  if (const auto v = value.member("y"); v && !reader.signed32(*v, scissor.y)) return false;
  return reader.unsigned32(*value.member("width"), scissor.width) &&
         reader.unsigned32(*value.member("height"), scissor.height);
}

bool readFurtherViewports(Reader& reader, const JsonValue& value, std::vector<ViewportAndScissor>& out) {
  static constexpr std::array<std::string_view, 2> kFields{"viewport", "scissor"};
  if (!reader.array(value, "furtherViewports")) return false;
  JsonValue element = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, element = element.next()) {
    ViewportAndScissor& further = out.emplace_back();
    if (!reader.object(element, "further viewport", kFields, {"viewport"})) return false;
    if (!readViewport(reader, *element.member("viewport"), further.viewport)) return false;
    if (const auto v = element.member("scissor"); v && !readScissor(reader, *v, further.scissor.emplace())) return false;
  }
  return true;
}

bool readBuiltIns(Reader& reader, const JsonValue& value, std::vector<BuiltIn>& out) {
  if (!reader.array(value, "builtIns")) return false;
  JsonValue element = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, element = element.next()) {
    if (!reader.enumerant(element, "built-in", out.emplace_back())) return false;
  }
  return true;
}

bool readState(Reader& reader, const JsonValue& value, State& state) {
  static constexpr std::array kFields = std::to_array<std::string_view>(
      {"topology", "cullMode", "frontFace", "provokingVertexMode", "depthTestEnable", "depthWriteEnable",
       "depthCompareOp", "negativeOneToOne", "primitiveRestartEnable", "polygonMode", "depthClampEnable",
       "depthClipEnable", "depthBiasEnable", "depthBiasConstantFactor", "depthBiasClamp", "depthBiasSlopeFactor",
       "lineWidth", "lineRasterizationMode", "stippledLineEnable", "lineStippleFactor", "lineStipplePattern",
       "pointSize", "sampleMask", "sampleShadingEnable", "minSampleShading", "alphaToCoverageEnable", "shaderSampleMask"});
  if (!reader.object(value, "state", kFields)) return false;
  const auto named = [&](std::string_view field, auto& out) {
    const auto v = value.member(field);
    return !v || reader.enumerant(*v, field, out);
  };
  const auto flag = [&](std::string_view field, bool& out) {
    const auto v = value.member(field);
    return !v || reader.boolean(*v, out);
  };
  const auto number = [&](std::string_view field, float& out) {
    const auto v = value.member(field);
    return !v || reader.float32(*v, out);
  };
  const auto integer = [&](std::string_view field, uint32_t& out) {
    const auto v = value.member(field);
    return !v || reader.unsigned32(*v, out);
  };
  uint32_t pattern = state.lineStipplePattern;
  const bool read =
      named("topology", state.topology) && named("cullMode", state.cullMode) && named("frontFace", state.frontFace) &&
      named("provokingVertexMode", state.provokingVertexMode) && flag("depthTestEnable", state.depthTestEnable) &&
      flag("depthWriteEnable", state.depthWriteEnable) && named("depthCompareOp", state.depthCompareOp) &&
      flag("negativeOneToOne", state.negativeOneToOne) &&
      flag("primitiveRestartEnable", state.primitiveRestartEnable) && named("polygonMode", state.polygonMode) &&
      flag("depthClampEnable", state.depthClampEnable) && flag("depthBiasEnable", state.depthBiasEnable) &&
      number("depthBiasConstantFactor", state.depthBiasConstantFactor) &&
      number("depthBiasClamp", state.depthBiasClamp) && number("depthBiasSlopeFactor", state.depthBiasSlopeFactor) &&
      number("lineWidth", state.lineWidth) && named("lineRasterizationMode", state.lineRasterizationMode) &&
      flag("stippledLineEnable", state.stippledLineEnable) && integer("lineStippleFactor", state.lineStippleFactor) &&
      integer("lineStipplePattern", pattern) && number("pointSize", state.pointSize) &&
      integer("sampleMask", state.sampleMask) && flag("sampleShadingEnable", state.sampleShadingEnable) &&
      number("minSampleShading", state.minSampleShading) && flag("alphaToCoverageEnable", state.alphaToCoverageEnable) &&
      named("shaderSampleMask", state.shaderSampleMask);
  if (!read) return false;
  if (pattern > UINT16_MAX) {
    return reader.fail(*value.member("lineStipplePattern"), fmt::format("{} has more than 16 bits", pattern),
                       "0 .. 65535");
  }
  state.lineStipplePattern = static_cast<uint16_t>(pattern);
  const auto clip = value.member("depthClipEnable");
  return !clip || reader.boolean(*clip, state.depthClipEnable.emplace());
}

}  // namespace rasterdiff
