// Scene to text: clip space, one vertex a line, only fields that differ from their defaults.
#include <fmt/format.h>

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

void writeTarget(std::string& out, const Target& target) {
  out += fmt::format("{{\"width\": {}, \"height\": {}, \"samples\": {}", target.width, target.height, target.samples);
  if (target.depthFormat) {
    out += fmt::format(", \"depthFormat\": \"{}\", \"depthClearValue\": {}", enumName(*target.depthFormat),
                       jsonNumber(target.depthClearValue));
  }
  out += "}";
}

void writeState(std::string& out, const State& state) {
  const State defaults;
  Fields field(out, ", ");
  const auto flag = [&](const char* name, bool value) {
    if (value) field(name) += "true";
  };
  out += "{";
  field("topology") += quoted(enumName(state.topology));
  if (state.cullMode != defaults.cullMode) field("cullMode") += quoted(enumName(state.cullMode));
  if (state.frontFace != defaults.frontFace) field("frontFace") += quoted(enumName(state.frontFace));
  if (state.provokingVertexMode != defaults.provokingVertexMode) {
    field("provokingVertexMode") += quoted(enumName(state.provokingVertexMode));
  }
  flag("depthTestEnable", state.depthTestEnable);
  flag("depthWriteEnable", state.depthWriteEnable);
  if (state.depthCompareOp != defaults.depthCompareOp)
    field("depthCompareOp") += quoted(enumName(state.depthCompareOp));
  flag("negativeOneToOne", state.negativeOneToOne);
  out += "}";
}

void writeVarying(std::string& out, const Varying& varying) {
  out += fmt::format("\n      {{\"name\": {}, \"interpolation\": {}, \"values\": [", quoted(varying.name),
                     quoted(enumName(varying.interpolation)));
  for (size_t i = 0; i < varying.values.size(); ++i) {
    const size_t component = i % varying.components;
    out += i == 0 ? "[" : component == 0 ? "], [" : ", ";
    out += jsonNumber(varying.values[i]);
  }
  out += varying.values.empty() ? "]}" : "]]}";
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
    field("indices") += "[";
    for (size_t i = 0; i < draw.indices->size(); ++i) {
      fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : ", ", (*draw.indices)[i]);
    }
    out += "]";
  }
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
  const Viewport& v = scene.viewport;
  field("viewport") += fmt::format(
      "{{\"x\": {}, \"y\": {}, \"width\": {}, \"height\": {}, \"minDepth\": {}, \"maxDepth\": {}}}", jsonNumber(v.x),
      jsonNumber(v.y), jsonNumber(v.width), jsonNumber(v.height), jsonNumber(v.minDepth), jsonNumber(v.maxDepth));
  if (const auto& s = scene.scissor) {
    field("scissor") +=
        fmt::format("{{\"x\": {}, \"y\": {}, \"width\": {}, \"height\": {}}}", s->x, s->y, s->width, s->height);
  }
  writeState(field("state"), scene.state);
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
