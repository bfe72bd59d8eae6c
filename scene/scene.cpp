// What every renderer may rely on: the checks that a scene has to pass, and how many primitives assembly makes.
// Where in a file a field stands is the loader's business (scene/file): errors here name the field.
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace rasterdiff {
namespace {

using Check = Result<void>;

tl::unexpected<Error> bad(std::string where, std::string what, std::string hint = {}) {
  return fail(ErrorCode::BadInput, std::move(where), std::move(what), std::move(hint));
}

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// A scene's name becomes part of file names (dumps, reports): it stays below the folder that it is written to.
Check checkName(const std::string& name) {
  if (name.empty()) return {};
  if (name.size() > 200) return bad("name", "the name is longer than 200 bytes");
  const auto forbidden = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\'; };
  if (std::any_of(name.begin(), name.end(), forbidden)) {
    return bad("name", "the name has a control character or a backslash", "use letters, digits, '-', '_', '.' and '/'");
  }
  for (size_t begin = 0; begin <= name.size();) {
    const size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = std::string_view(name).substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") {
      return bad("name", fmt::format("'{}' is not a relative name: a part is empty, '.' or '..'", name),
                 "write it like fill/shared-diagonal");
    }
    begin = end + 1;
  }
  return {};
}

Check checkExtent(const std::string& where, uint32_t value) {
  if (value >= 1 && value <= kMaxTargetExtent) return {};
  return bad(where, fmt::format("{} is outside 1..{}", value, kMaxTargetExtent));
}

Check checkTarget(const Target& target) {
  if (auto ok = checkExtent("target.width", target.width); !ok) return ok;
  if (auto ok = checkExtent("target.height", target.height); !ok) return ok;
  constexpr std::array<uint32_t, 5> kCounts{1, 2, 4, 8, 16};
  if (std::find(kCounts.begin(), kCounts.end(), target.samples) == kCounts.end()) {
    return bad("target.samples", fmt::format("{} is no sample count", target.samples), "one of 1, 2, 4, 8, 16");
  }
  if (!(target.depthClearValue >= 0 && target.depthClearValue <= 1)) {
    return bad("target.depthClearValue", fmt::format("{} is outside 0..1", target.depthClearValue));
  }
  if (!target.depthFormat && target.depthClearValue != 1) {
    return bad("target.depthClearValue", "a clear value without a depth attachment",
               "set target.depthFormat to D32_SFLOAT");
  }
  if (target.depthFormat && *target.depthFormat != DepthFormat::D32_SFLOAT) {
    return bad("target.depthFormat", fmt::format("unknown format {}", static_cast<uint32_t>(*target.depthFormat)),
               "D32_SFLOAT");
  }
  return {};
}

/// [vk:VkViewport] the bounds that every device has to offer for a viewport of kMaxTargetExtent.
Check checkViewport(const Viewport& v) {
  constexpr float kExtent = kMaxTargetExtent, kBounds = 2 * kExtent;
  if (!(v.width > 0 && v.width <= kExtent)) {
    return bad("viewport.width", fmt::format("{} is outside (0, {}]", v.width, kExtent));
  }
  if (!(std::fabs(v.height) > 0 && std::fabs(v.height) <= kExtent)) {
    return bad("viewport.height", fmt::format("{} is zero or outside [-{}, {}]", v.height, kExtent, kExtent));
  }
  if (!(v.x >= -kBounds && v.x + v.width <= kBounds - 1)) {
    return bad("viewport.x", fmt::format("{} .. {} leaves [-{}, {}]", v.x, v.x + v.width, kBounds, kBounds - 1));
  }
  const float low = std::min(v.y, v.y + v.height), high = std::max(v.y, v.y + v.height);
  if (!(low >= -kBounds && high <= kBounds - 1)) {
    return bad("viewport.y", fmt::format("{} .. {} leaves [-{}, {}]", low, high, kBounds, kBounds - 1));
  }
  if (!(v.minDepth >= 0 && v.minDepth <= 1)) {
    return bad("viewport.minDepth", fmt::format("{} is outside 0..1", v.minDepth));
  }
  if (!(v.maxDepth >= 0 && v.maxDepth <= 1)) {
    return bad("viewport.maxDepth", fmt::format("{} is outside 0..1", v.maxDepth));
  }
  return {};
}

/// [vk:VkRect2D] offsets are not negative and the far corner fits int32.
Check checkScissor(const Rect2D& scissor) {
  const auto axis = [](const char* offsetName, int32_t offset, const char* extentName, uint32_t extent) -> Check {
    if (offset < 0) return bad(offsetName, fmt::format("{} is negative", offset));
    if (extent == 0) return bad(extentName, "a scissor of size zero lets nothing through");
    if (int64_t{offset} + extent > INT32_MAX) return bad(extentName, "offset + extent exceeds 2147483647");
    return {};
  };
  if (auto ok = axis("scissor.x", scissor.x, "scissor.width", scissor.width); !ok) return ok;
  return axis("scissor.y", scissor.y, "scissor.height", scissor.height);
}

Check checkState(const Scene& scene) {
  const State& state = scene.state;
  const auto enumerant = [](const char* field, uint32_t value, uint32_t first, uint32_t last) -> Check {
    if (value >= first && value <= last) return {};
    return bad(fmt::format("state.{}", field), fmt::format("{} is no enumerant", value));
  };
  const auto raw = [](auto value) { return static_cast<uint32_t>(value); };
  if (auto ok = enumerant("topology", raw(state.topology), 3, 5); !ok) return ok;
  if (auto ok = enumerant("cullMode", raw(state.cullMode), 0, 3); !ok) return ok;
  if (auto ok = enumerant("frontFace", raw(state.frontFace), 0, 1); !ok) return ok;
  if (auto ok = enumerant("provokingVertexMode", raw(state.provokingVertexMode), 0, 1); !ok) return ok;
  if (auto ok = enumerant("depthCompareOp", raw(state.depthCompareOp), 0, 7); !ok) return ok;
  if (scene.target.depthFormat) return {};
  if (state.depthTestEnable || state.depthWriteEnable) {
    return bad(state.depthTestEnable ? "state.depthTestEnable" : "state.depthWriteEnable",
               "depth state without a depth attachment", "set target.depthFormat to D32_SFLOAT");
  }
  return {};
}

Check checkVaryingName(const std::string& where, const std::string& name) {
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), isNameCharacter)) {
    return bad(where, fmt::format("'{}' is no varying name", name), "1 to 64 letters, digits, '_' or '-'");
  }
  constexpr std::array<std::string_view, 4> kTaken{"coverage", "count", "depth", "primitive"};
  if (std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end()) {
    return bad(where, fmt::format("'{}' is the name of another plane", name), "choose another name");
  }
  return {};
}

Check checkVarying(const std::string& where, const Varying& varying, size_t vertices, bool allowNonFinite) {
  if (auto ok = checkVaryingName(where + ".name", varying.name); !ok) return ok;
  if (static_cast<uint32_t>(varying.interpolation) > static_cast<uint32_t>(Interpolation::flat)) {
    return bad(where + ".interpolation", "no such interpolation", "smooth, noperspective or flat");
  }
  if (varying.components < 1 || varying.components > 4) {
    return bad(where + ".values", fmt::format("{} components a vertex", varying.components), "1 to 4");
  }
  if (varying.values.size() != vertices * varying.components) {
    return bad(
        where + ".values",
        fmt::format("{} values for {} vertices of {} components", varying.values.size(), vertices, varying.components),
        "one value (of 1 to 4 components) for every position");
  }
  if (allowNonFinite) return {};
  for (size_t i = 0; i < varying.values.size(); ++i) {
    if (!std::isfinite(varying.values[i])) {
      return bad(fmt::format("{}.values[{}][{}]", where, i / varying.components, i % varying.components),
                 fmt::format("{} is not finite", varying.values[i]), "\"allowNonFinite\": true lets it through");
    }
  }
  return {};
}

Check checkVaryings(const std::string& where, const Draw& draw, bool allowNonFinite) {
  if (draw.varyings.size() > kMaxVaryings) {
    return bad(where + ".varyings", fmt::format("{} varyings; at most {}", draw.varyings.size(), kMaxVaryings));
  }
  for (size_t i = 0; i < draw.varyings.size(); ++i) {
    const std::string at = fmt::format("{}.varyings[{}]", where, i);
    if (auto ok = checkVarying(at, draw.varyings[i], draw.positions.size(), allowNonFinite); !ok) return ok;
    for (size_t j = 0; j < i; ++j) {
      if (draw.varyings[j].name == draw.varyings[i].name) {
        return bad(at + ".name", fmt::format("a second varying named '{}'", draw.varyings[i].name));
      }
    }
  }
  return {};
}

Check checkDraw(const std::string& where, const Draw& draw, bool allowNonFinite) {
  if (draw.positions.empty()) return bad(where + ".positions", "a draw without positions");
  for (size_t i = 0; i < draw.positions.size() && !allowNonFinite; ++i) {
    const ClipPosition& p = draw.positions[i];
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w))) {
      return bad(fmt::format("{}.positions[{}]", where, i),
                 fmt::format("({}, {}, {}, {}) is not finite", p.x, p.y, p.z, p.w),
                 "\"allowNonFinite\": true lets it through");
    }
  }
  if (draw.indices) {
    for (size_t i = 0; i < draw.indices->size(); ++i) {
      if ((*draw.indices)[i] >= draw.positions.size()) {
        return bad(fmt::format("{}.indices[{}]", where, i),
                   fmt::format("index {} but only {} positions", (*draw.indices)[i], draw.positions.size()),
                   "indices count from 0");
      }
    }
  }
  return checkVaryings(where, draw, allowNonFinite);
}

Check checkAlike(const std::string& where, const Draw& draw, const Draw& first) {
  if (draw.varyings.size() != first.varyings.size()) {
    return bad(where + ".varyings",
               fmt::format("{} varyings where draws[0] has {}", draw.varyings.size(), first.varyings.size()),
               "all draws of a scene have the same varyings");
  }
  for (size_t i = 0; i < draw.varyings.size(); ++i) {
    const Varying &a = draw.varyings[i], &b = first.varyings[i];
    if (a.name != b.name || a.interpolation != b.interpolation || a.components != b.components) {
      return bad(fmt::format("{}.varyings[{}]", where, i),
                 fmt::format("'{}' differs from draws[0]'s '{}' in name, interpolation or components", a.name, b.name),
                 "all draws of a scene have the same varyings");
    }
  }
  return {};
}

/// Bytes of the reference's frame with its bounds: primitive, count, coverage; depth and varyings with bounds.
uint64_t frameBytes(const Scene& scene) {
  uint64_t perSample = 4 + 4 + 1;
  if (scene.target.depthFormat) perSample += 4 + 8;
  for (const Varying& varying : scene.draws.front().varyings) perSample += uint64_t{varying.components} * (4 + 8);
  return uint64_t{scene.target.width} * scene.target.height * scene.target.samples * perSample;
}

}  // namespace

Result<void> validate(const Scene& scene) {
  if (auto ok = checkName(scene.name); !ok) return ok;
  if (auto ok = checkTarget(scene.target); !ok) return ok;
  if (auto ok = checkViewport(scene.viewport); !ok) return ok;
  if (scene.scissor) {
    if (auto ok = checkScissor(*scene.scissor); !ok) return ok;
  }
  if (auto ok = checkState(scene); !ok) return ok;
  if (scene.draws.empty()) return bad("draws", "a scene without draws");
  uint64_t primitives = 0;
  for (size_t i = 0; i < scene.draws.size(); ++i) {
    const std::string where = fmt::format("draws[{}]", i);
    const Draw& draw = scene.draws[i];
    if (draw.positions.size() >= UINT32_MAX || (draw.indices && draw.indices->size() >= UINT32_MAX)) {
      return bad(where, "more than 2^32 - 2 vertices");
    }
    if (auto ok = checkDraw(where, draw, scene.allowNonFinite); !ok) return ok;
    if (auto ok = checkAlike(where, draw, scene.draws.front()); !ok) return ok;
    primitives += primitiveCount(scene.state.topology, vertexCount(draw));
  }
  if (primitives >= UINT32_MAX) return bad("draws", "more than 2^32 - 2 primitives");
  if (frameBytes(scene) > kMaxFrameBytes) {
    return bad("target",
               fmt::format("the planes of this scene would take {} MiB; at most {}", frameBytes(scene) >> 20,
                           kMaxFrameBytes >> 20),
               "use a smaller target, fewer samples or fewer varyings");
  }
  return {};
}

uint32_t vertexCount(const Draw& draw) {
  return static_cast<uint32_t>(draw.indices ? draw.indices->size() : draw.positions.size());
}

uint32_t primitiveCount(PrimitiveTopology topology, uint32_t vertices) {
  if (topology == PrimitiveTopology::TRIANGLE_LIST) return vertices / 3;
  return vertices < 3 ? 0 : vertices - 2;
}

}  // namespace rasterdiff
