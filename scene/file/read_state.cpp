// Target, viewport, scissor and pipeline state of a scene file.
#include <array>

#include "scene/file/read_scene.hpp"

namespace rasterdiff {

bool readTarget(Reader& reader, const JsonValue& value, Target& target) {
  static constexpr std::array<std::string_view, 5> kFields{"width", "height", "samples", "depthFormat",
                                                           "depthClearValue"};
  if (!reader.object(value, "target", kFields, {"width", "height"})) return false;
  if (!reader.unsigned32(*value.member("width"), target.width)) return false;
  if (!reader.unsigned32(*value.member("height"), target.height)) return false;
  if (const auto v = value.member("samples"); v && !reader.unsigned32(*v, target.samples)) return false;
  if (const auto v = value.member("depthFormat")) {
    if (!reader.enumerant(*v, "depthFormat", target.depthFormat.emplace())) return false;
  }
  if (const auto v = value.member("depthClearValue"); v && !reader.float32(*v, target.depthClearValue)) return false;
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

bool readState(Reader& reader, const JsonValue& value, State& state) {
  static constexpr std::array<std::string_view, 8> kFields{
      "topology",        "cullMode",         "frontFace",      "provokingVertexMode",
      "depthTestEnable", "depthWriteEnable", "depthCompareOp", "negativeOneToOne"};
  if (!reader.object(value, "state", kFields)) return false;
  const auto named = [&](std::string_view field, auto& out) {
    const auto v = value.member(field);
    return !v || reader.enumerant(*v, field, out);
  };
  const auto flag = [&](std::string_view field, bool& out) {
    const auto v = value.member(field);
    return !v || reader.boolean(*v, out);
  };
  return named("topology", state.topology) && named("cullMode", state.cullMode) &&
         named("frontFace", state.frontFace) && named("provokingVertexMode", state.provokingVertexMode) &&
         flag("depthTestEnable", state.depthTestEnable) && flag("depthWriteEnable", state.depthWriteEnable) &&
         named("depthCompareOp", state.depthCompareOp) && flag("negativeOneToOne", state.negativeOneToOne);
}

}  // namespace rasterdiff
