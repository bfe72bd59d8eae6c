// Scene to text: clip space, one vertex a line, only fields that differ from their defaults.
#include <fmt/format.h>

#include <bit>
#include <iterator>

#include "scene/file/enum_names.hpp"
#include "scene/file/number.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// An object's fields, with commas between them.
class Fields {
 public:
  Fields(std::string& out, std::string_view separator) : out_(out), separator_(separator) {}
  std::string& operator()(std::string_view name) {
    if (!first_) out_ += separator_;
    first_ = false;
    return out_ += fmt::format("\"{}\": ", name);
  }

 private:
  std::string& out_;
  std::string_view separator_;
  bool first_ = true;
};

void writeSampleLocations(std::string& out, const SampleLocationsInfo& info) {
  out += fmt::format(",\n    \"sampleLocations\": {{\"sampleLocationGridSize\": [{}, {}], \"sampleLocations\": [",
                     info.gridWidth, info.gridHeight);
  for (size_t i = 0; i < info.sampleLocations.size(); ++i) {
    const SampleLocationEXT& at = info.sampleLocations[i];
    out += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", jsonNumber(at.x), jsonNumber(at.y));
  }
  out += "]}";
}

void writeTarget(std::string& out, const Target& target) {
  out += fmt::format("{{\"width\": {}, \"height\": {}, \"samples\": {}", target.width, target.height, target.samples);
  if (target.supersample != 1) out += fmt::format(", \"supersample\": {}", target.supersample);
  if (target.resolve) out += ", \"resolve\": true";
  if (target.depthFormat) {
    out += fmt::format(", \"depthFormat\": \"{}\", \"depthClearValue\": {}", enumName(*target.depthFormat),
                       jsonNumber(target.depthClearValue));
  }
  if (target.depthResolveMode) out += fmt::format(", \"depthResolveMode\": \"{}\"", enumName(*target.depthResolveMode));
  if (target.sampleLocations) writeSampleLocations(out, *target.sampleLocations);
  out += "}";
}

void writeViewport(std::string& out, const Viewport& v) {
  out += fmt::format("{{\"x\": {}, \"y\": {}, \"width\": {}, \"height\": {}, \"minDepth\": {}, \"maxDepth\": {}}}",
                     jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.width), jsonNumber(v.height),
                     jsonNumber(v.minDepth), jsonNumber(v.maxDepth));
}

void writeScissor(std::string& out, const Rect2D& s) {
  out += fmt::format("{{\"x\": {}, \"y\": {}, \"width\": {}, \"height\": {}}}", s.x, s.y, s.width, s.height);
}

void writeFurtherViewports(std::string& out, const std::vector<ViewportAndScissor>& viewports) {
  out += "[";
  for (size_t i = 0; i < viewports.size(); ++i) {
    out += i == 0 ? "\n    {\"viewport\": " : ",\n    {\"viewport\": ";
    writeViewport(out, viewports[i].viewport);
    if (const auto& scissor = viewports[i].scissor) {
      out += ", \"scissor\": ";
      writeScissor(out, *scissor);
    }
    out += "}";
  }
  out += "]";
}

void writeState(std::string& out, const State& state) {
  const State defaults;
  Fields field(out, ", ");
  const auto named = [&](const char* name, auto value, auto usual) {
    if (value != usual) field(name) += quoted(enumName(value));
  };
  const auto flag = [&](const char* name, bool value) {
    if (value) field(name) += "true";
  };
  // By its bits: a negative zero is written too.
  const auto number = [&](const char* name, float value, float usual) {
    if (std::bit_cast<uint32_t>(value) != std::bit_cast<uint32_t>(usual)) field(name) += jsonNumber(value);
  };
  const auto integer = [&](const char* name, uint32_t value, uint32_t usual) {
    if (value != usual) field(name) += fmt::format("{}", value);
  };
  out += "{";
  field("topology") += quoted(enumName(state.topology));
  named("cullMode", state.cullMode, defaults.cullMode);
  named("frontFace", state.frontFace, defaults.frontFace);
  named("provokingVertexMode", state.provokingVertexMode, defaults.provokingVertexMode);
  flag("depthTestEnable", state.depthTestEnable);
  flag("depthWriteEnable", state.depthWriteEnable);
  named("depthCompareOp", state.depthCompareOp, defaults.depthCompareOp);
  flag("negativeOneToOne", state.negativeOneToOne);
  flag("primitiveRestartEnable", state.primitiveRestartEnable);
  named("polygonMode", state.polygonMode, defaults.polygonMode);
  flag("depthClampEnable", state.depthClampEnable);
  if (state.depthClipEnable) field("depthClipEnable") += *state.depthClipEnable ? "true" : "false";
  flag("depthBiasEnable", state.depthBiasEnable);
  number("depthBiasConstantFactor", state.depthBiasConstantFactor, defaults.depthBiasConstantFactor);
  number("depthBiasClamp", state.depthBiasClamp, defaults.depthBiasClamp);
  number("depthBiasSlopeFactor", state.depthBiasSlopeFactor, defaults.depthBiasSlopeFactor);
  number("lineWidth", state.lineWidth, defaults.lineWidth);
  named("lineRasterizationMode", state.lineRasterizationMode, defaults.lineRasterizationMode);
  flag("stippledLineEnable", state.stippledLineEnable);
  integer("lineStippleFactor", state.lineStippleFactor, defaults.lineStippleFactor);
  integer("lineStipplePattern", state.lineStipplePattern, defaults.lineStipplePattern);
  number("pointSize", state.pointSize, defaults.pointSize);
  integer("sampleMask", state.sampleMask, defaults.sampleMask);
  flag("sampleShadingEnable", state.sampleShadingEnable);
  number("minSampleShading", state.minSampleShading, defaults.minSampleShading);
  flag("alphaToCoverageEnable", state.alphaToCoverageEnable);
  named("shaderSampleMask", state.shaderSampleMask, defaults.shaderSampleMask);
  out += "}";
}

/// [[1, 2], [3, 4]] for two vertices of two components.
void writeArrays(std::string& out, const std::vector<float>& values, uint32_t components) {
  out += "[";
  for (size_t i = 0; i < values.size(); ++i) {
    out += i == 0 ? "[" : i % components == 0 ? "], [" : ", ";
    out += jsonNumber(values[i]);
  }
  out += values.empty() ? "]" : "]]";
}

void writeVarying(std::string& out, const Varying& varying) {
  out += fmt::format("\n      {{\"name\": {}, \"interpolation\": {}, ", quoted(varying.name),
                     quoted(enumName(varying.interpolation)));
  if (varying.interpolation == Interpolation::offset) {
    out += fmt::format("\"offset\": [{}, {}], ", jsonNumber(varying.offsetX), jsonNumber(varying.offsetY));
  }
  out += "\"values\": ";
  writeArrays(out, varying.values, varying.components);
  out += "}";
}

/// Elements with commas between them, each as `write` puts it.
template <class T, class Write>
void writeList(std::string& out, const std::vector<T>& list, const Write& write) {
  out += "[";
  for (size_t i = 0; i < list.size(); ++i) {
    if (i > 0) out += ", ";
    write(list[i]);
  }
  out += "]";
}

void writeDraw(std::string& out, const Draw& draw) {
  Fields field(out, ",\n     ");
  out += "\n    {";
  field("positions") += "[";
  for (size_t i = 0; i < draw.positions.size(); ++i) {
    const ClipPosition& p = draw.positions[i];
    out += fmt::format("{}\n      [{}, {}, {}, {}]", i == 0 ? "" : ",", jsonNumber(p.x), jsonNumber(p.y),
                       jsonNumber(p.z), jsonNumber(p.w));
  }
  out += "]";
  if (draw.indices) {
    const auto write = [&](uint32_t index) { fmt::format_to(std::back_inserter(out), "{}", index); };
    writeList(field("indices"), *draw.indices, write);
  }
  if (draw.viewportIndex != 0) field("viewportIndex") += fmt::format("{}", draw.viewportIndex);
  if (draw.shaderSampleMaskBits != Draw{}.shaderSampleMaskBits) {
    field("shaderSampleMaskBits") += fmt::format("{}", draw.shaderSampleMaskBits);
  }
  if (!draw.pointSizes.empty()) {
    writeList(field("pointSizes"), draw.pointSizes, [&](float size) { out += jsonNumber(size); });
  }
  if (draw.clipDistanceCount > 0) writeArrays(field("clipDistances"), draw.clipDistances, draw.clipDistanceCount);
  if (draw.cullDistanceCount > 0) writeArrays(field("cullDistances"), draw.cullDistances, draw.cullDistanceCount);
  if (!draw.varyings.empty()) {
    field("varyings") += "[";
    for (size_t i = 0; i < draw.varyings.size(); ++i) {
      if (i > 0) out += ",";
      writeVarying(out, draw.varyings[i]);
    }
    out += "]";
  }
  out += "}";
}

}  // namespace

std::string writeScene(const Scene& scene) {
  std::string out = "{\n  ";
  Fields field(out, ",\n  ");
  field("name") += quoted(scene.name);
  writeTarget(field("target"), scene.target);
  writeViewport(field("viewport"), scene.viewport);
  if (scene.scissor) writeScissor(field("scissor"), *scene.scissor);
  if (!scene.furtherViewports.empty()) writeFurtherViewports(field("furtherViewports"), scene.furtherViewports);
  writeState(field("state"), scene.state);
  if (!scene.builtIns.empty()) {
    writeList(field("builtIns"), scene.builtIns, [&](BuiltIn builtIn) { out += quoted(enumName(builtIn)); });
  }
  if (scene.allowNonFinite) field("allowNonFinite") += "true";
  field("draws") += "[";
  for (size_t i = 0; i < scene.draws.size(); ++i) {
    if (i > 0) out += ",";
    writeDraw(out, scene.draws[i]);
  }
  out += "]\n}\n";
  return out;
}

}  // namespace rasterdiff
