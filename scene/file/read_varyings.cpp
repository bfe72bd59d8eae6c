// The varyings of a draw in a scene file, and arrays of numbers that have one element a vertex.
#include <algorithm>
#include <array>

#include "scene/file/read_scene.hpp"

namespace rasterdiff {
namespace {

bool readOffset(Reader& reader, const JsonValue& varying, Varying& out) {
  const auto offset = varying.member("offset");
  const bool asked = out.interpolation == Interpolation::offset;
  if (!offset) return !asked || reader.fail(varying, "varying without 'offset'", "[x, y] in pixels from the centre");
  if (!asked) return reader.fail(*offset, "an offset without it as interpolation", "set \"interpolation\": \"offset\"");
  if (!reader.array(*offset, "offset")) return false;
  if (offset->size() != 2) return reader.fail(*offset, fmt::format("an offset of {} numbers", offset->size()), "[x, y]");
  return reader.float32(offset->first(), out.offsetX) && reader.float32(offset->first().next(), out.offsetY);
}

bool readVarying(Reader& reader, const JsonValue& value, const OfferedVaryings* offered, bool allowNonFinite, Varying& varying) {
  static constexpr std::array<std::string_view, 4> kFields{"name", "interpolation", "offset", "values"};
  if (!reader.object(value, "varying", kFields, {"name"})) return false;
  if (!reader.text(*value.member("name"), varying.name)) return false;
  if (const auto v = value.member("interpolation");
      v && !reader.enumerant(*v, "interpolation", varying.interpolation)) {
    return false;
  }
  if (!readOffset(reader, value, varying)) return false;
  const auto values = value.member("values");
  if (offered == nullptr) {
    return values ? readVertexArrays(reader, *values, "a value", 4, allowNonFinite, varying.components, varying.values)
                  : reader.fail(value, "varying without 'values'", "one value for every position");
  }
  if (values) {
    return reader.fail(*values, fmt::format("{} brings its own values", offered->owner), "leave 'values' out");
  }
  if (std::find(offered->names.begin(), offered->names.end(), varying.name) == offered->names.end()) {
    return reader.fail(*value.member("name"), fmt::format("{} has no '{}'", offered->owner, varying.name),
                       Reader::suggest(varying.name, offered->names));
  }
  return true;
}

}  // namespace

bool readVertexArrays(Reader& reader, const JsonValue& value, std::string_view what, uint32_t most, bool allowNonFinite,
                uint32_t& count, std::vector<float>& out) {
  if (!reader.array(value, what)) return false;
  JsonValue vertex = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, vertex = vertex.next()) {
    const bool isArray = vertex.kind() == JsonKind::Array;
    const uint32_t components = isArray ? vertex.size() : 1;
    if (components < 1 || components > most) {
      return reader.fail(vertex, fmt::format("{} of {} components", what, components), fmt::format("1 to {}", most));
    }
    if (i == 0) count = components;
    if (components != count) {
      return reader.fail(vertex, fmt::format("{} components where the first vertex has {}", components, count));
    }
    JsonValue number = isArray ? vertex.first() : vertex;
    for (uint32_t c = 0; c < components; ++c, number = number.next()) {
      if (!reader.float32(number, out.emplace_back(), allowNonFinite)) return false;
    }
  }
  return true;
}

bool readVaryings(Reader& reader, const JsonValue& draw, const OfferedVaryings* offered, bool allowNonFinite, std::vector<Varying>& out) {
  const auto value = draw.member("varyings");
  if (!value) return true;
  if (!reader.array(*value, "varyings")) return false;
  if (value->size() > kMaxVaryings) {
    return reader.fail(*value, fmt::format("{} varyings; at most {}", value->size(), kMaxVaryings));
  }
  JsonValue element = value->first();
  for (uint32_t i = 0; i < value->size(); ++i, element = element.next()) {
    if (!readVarying(reader, element, offered, allowNonFinite, out.emplace_back())) return false;
  }
  return true;
}

}  // namespace rasterdiff
