// Checks of one draw: its arrays fit its vertices, its numbers are finite, and it is like the first draw.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <string_view>

#include "scene/built_ins.hpp"
#include "scene/checks.hpp"
#include "scene/file/enum_names.hpp"

namespace rasterdiff::checks {
namespace {

constexpr const char* kLetThrough = "\"allowNonFinite\": true lets it through";
constexpr const char* kSameVaryings = "all draws of a scene have the same varyings";

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

Check checkVaryingName(const std::string& where, const std::string& name, std::span<const BuiltIn> builtIns) {
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), isNameCharacter)) {
    return bad(where, fmt::format("'{}' is no varying name", name), "1 to 64 letters, digits, '_' or '-'");
  }
  constexpr std::array<std::string_view, 4> kTaken{"coverage", "count", "depth", "primitive"};
  const bool observed = std::any_of(builtIns.begin(), builtIns.end(), [&](BuiltIn b) { return builtInName(b) == name; });
  if (observed || std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end()) {
    return bad(where, fmt::format("'{}' is the name of another plane", name), "choose another name");
  }
  return {};
}

/// Without branches, many numbers at a time: the exponent of what is not finite is all ones.
bool areFinite(std::span<const float> values) {
  constexpr uint32_t kExponent = 0x7F800000;
  uint32_t found = 0;
  for (const float value : values) found |= (std::bit_cast<uint32_t>(value) & kExponent) == kExponent ? 1U : 0U;
  return found == 0;
}

/// `count` numbers a vertex, all finite.
Check checkFinite(const std::string& where, std::span<const float> values, uint32_t count, bool allowNonFinite) {
  if (allowNonFinite || areFinite(values)) return {};
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      return bad(fmt::format("{}[{}][{}]", where, i / count, i % count), fmt::format("{} is not finite", values[i]),
                 kLetThrough);
    }
  }
  return {};
}

/// [vk:limits-minInterpolationOffset] every device offers -0.5 .. 0.5 less one step of its grid.
Check checkOffset(const std::string& where, const Varying& varying) {
  const bool offset = varying.interpolation == Interpolation::offset;
  if (!offset && (varying.offsetX != 0 || varying.offsetY != 0)) {
    return bad(where, fmt::format("an offset where the interpolation is {}", enumName(varying.interpolation)),
               "set \"interpolation\": \"offset\"");
  }
  for (float value : {varying.offsetX, varying.offsetY}) {
    if (!(value >= -0.5f && value < 0.5f)) {
      return bad(where, fmt::format("{} is outside [-0.5, 0.5)", value), "pixels from the centre");
    }
  }
  return {};
}

Check checkVarying(const std::string& where, const Varying& varying, size_t vertices, const Scene& scene) {
  if (auto ok = checkVaryingName(where + ".name", varying.name, scene.builtIns); !ok) return ok;
  if (enumName(varying.interpolation).empty()) {
    return bad(where + ".interpolation", "no such interpolation",
               "smooth, noperspective, flat, centroid, sample or offset");
  }
  if (auto ok = checkOffset(where + ".offset", varying); !ok) return ok;
  if (varying.components < 1 || varying.components > 4) {
    return bad(where + ".values", fmt::format("{} components a vertex", varying.components), "1 to 4");
  }
  if (varying.values.size() != vertices * varying.components) {
    return bad(
        where + ".values",
        fmt::format("{} values for {} vertices of {} components", varying.values.size(), vertices, varying.components),
        "one value (of 1 to 4 components) for every position");
  }
  return checkFinite(where + ".values", varying.values, varying.components, scene.allowNonFinite);
}

Check checkVaryings(const std::string& where, const Draw& draw, const Scene& scene) {
  if (draw.varyings.size() > kMaxVaryings) {
    return bad(where + ".varyings", fmt::format("{} varyings; at most {}", draw.varyings.size(), kMaxVaryings));
  }
  for (size_t i = 0; i < draw.varyings.size(); ++i) {
    const std::string at = fmt::format("{}.varyings[{}]", where, i);
    if (auto ok = checkVarying(at, draw.varyings[i], draw.positions.size(), scene); !ok) return ok;
    for (size_t j = 0; j < i; ++j) {
      if (draw.varyings[j].name == draw.varyings[i].name) {
        return bad(at + ".name", fmt::format("a second varying named '{}'", draw.varyings[i].name));
      }
    }
  }
  return {};
}

Check checkIndices(const std::string& where, const Draw& draw, bool restart) {
  if (!draw.indices) return {};
  const auto positions = static_cast<uint32_t>(draw.positions.size());
  uint32_t beyond = 0;
  for (const uint32_t index : *draw.indices) beyond |= index >= positions ? 1U : 0U;
  if (beyond == 0) return {};
  for (size_t i = 0; i < draw.indices->size(); ++i) {
    const uint32_t index = (*draw.indices)[i];
    if (index < draw.positions.size() || (restart && index == kRestartIndex)) continue;
    const std::string at = fmt::format("{}.indices[{}]", where, i);
    if (index == kRestartIndex) {
      return bad(at, fmt::format("the restart index {} without primitive restart", index),
                 "set state.primitiveRestartEnable");
    }
    return bad(at, fmt::format("index {} but only {} positions", index, draw.positions.size()), "indices count from 0");
  }
  return {};
}

Check checkDistances(const std::string& where, const Draw& draw, bool allowNonFinite) {
  const auto one = [&](const std::string& at, uint32_t count, const std::vector<float>& values) -> Check {
    if (count > kMaxDistances) return bad(at, fmt::format("{} distances a vertex; at most {}", count, kMaxDistances));
    if (values.size() != draw.positions.size() * count) {
      return bad(at, fmt::format("{} distances for {} vertices of {}", values.size(), draw.positions.size(), count),
                 "one array of distances for every position");
    }
    return checkFinite(at, values, count, allowNonFinite);
  };
  if (auto ok = one(where + ".clipDistances", draw.clipDistanceCount, draw.clipDistances); !ok) return ok;
  if (auto ok = one(where + ".cullDistances", draw.cullDistanceCount, draw.cullDistances); !ok) return ok;
  const uint32_t together = draw.clipDistanceCount + draw.cullDistanceCount;
  if (together <= kMaxDistances) return {};
  return bad(where + ".cullDistances",
             fmt::format("{} clip and cull distances a vertex; at most {} together", together, kMaxDistances));
}

Check checkPointSizes(const std::string& where, const Draw& draw) {
  if (draw.pointSizes.empty()) return {};
  if (draw.pointSizes.size() != draw.positions.size()) {
    return bad(where, fmt::format("{} sizes for {} vertices", draw.pointSizes.size(), draw.positions.size()),
               "one size for every position");
  }
  for (size_t i = 0; i < draw.pointSizes.size(); ++i) {
    if (!(std::isfinite(draw.pointSizes[i]) && draw.pointSizes[i] > 0)) {
      return bad(fmt::format("{}[{}]", where, i),
                 fmt::format("{} pixels; a size is finite and above 0", draw.pointSizes[i]));
    }
  }
  return {};
}

Check checkAlike(const std::string& where, const Draw& draw, const Draw& first) {
  if (draw.varyings.size() != first.varyings.size()) {
    return bad(where + ".varyings",
               fmt::format("{} varyings where draws[0] has {}", draw.varyings.size(), first.varyings.size()),
               kSameVaryings);
  }
  for (size_t i = 0; i < draw.varyings.size(); ++i) {
    const Varying &a = draw.varyings[i], &b = first.varyings[i];
    const std::string at = fmt::format("{}.varyings[{}]", where, i);
    if (a.name != b.name || a.interpolation != b.interpolation || a.components != b.components) {
      return bad(at,
                 fmt::format("'{}' differs from draws[0]'s '{}' in name, interpolation or components", a.name, b.name),
                 kSameVaryings);
    }
    if (a.offsetX != b.offsetX || a.offsetY != b.offsetY) {
      return bad(at + ".offset", fmt::format("'{}' has another offset in draws[0]", a.name), kSameVaryings);
    }
  }
  const auto count = [&](const char* field, uint32_t own, uint32_t theirs) -> Check {
    if (own == theirs) return {};
    return bad(where + field, fmt::format("{} distances a vertex where draws[0] has {}", own, theirs),
               "all draws of a scene have as many");
  };
  if (auto ok = count(".clipDistances", draw.clipDistanceCount, first.clipDistanceCount); !ok) return ok;
  return count(".cullDistances", draw.cullDistanceCount, first.cullDistanceCount);
}

}  // namespace

Check checkDraw(const Scene& scene, size_t index) {
  const Draw& draw = scene.draws[index];
  const std::string where = fmt::format("draws[{}]", index);
  if (draw.positions.empty()) return bad(where + ".positions", "a draw without positions");
  if (draw.positions.size() >= UINT32_MAX || (draw.indices && draw.indices->size() >= UINT32_MAX)) {
    return bad(where, "more than 2^32 - 2 vertices");
  }
  static_assert(sizeof(ClipPosition) == 4 * sizeof(float));
  const std::span<const float> coordinates(&draw.positions[0].x, 4 * draw.positions.size());
  const bool finite = scene.allowNonFinite || areFinite(coordinates);
  for (size_t i = 0; i < draw.positions.size() && !finite; ++i) {
    const ClipPosition& p = draw.positions[i];
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w))) {
      return bad(fmt::format("{}.positions[{}]", where, i),
                 fmt::format("({}, {}, {}, {}) is not finite", p.x, p.y, p.z, p.w), kLetThrough);
    }
  }
  if (auto ok = checkIndices(where, draw, scene.state.primitiveRestartEnable); !ok) return ok;
  if (auto ok = checkPointSizes(where + ".pointSizes", draw); !ok) return ok;
  if (auto ok = checkDistances(where, draw, scene.allowNonFinite); !ok) return ok;
  if (draw.viewportIndex > scene.furtherViewports.size()) {
    return bad(where + ".viewportIndex",
               fmt::format("viewport {} but only {}", draw.viewportIndex, 1 + scene.furtherViewports.size()),
               "0 is viewport, 1 the first of furtherViewports");
  }
  if (draw.shaderSampleMaskBits != Draw{}.shaderSampleMaskBits && scene.state.shaderSampleMask == ShaderSampleMask::NONE) {
    return bad(where + ".shaderSampleMaskBits", "bits that no shader writes", "set state.shaderSampleMask to CONSTANT");
  }
  if (auto ok = checkVaryings(where, draw, scene); !ok) return ok;
  return checkAlike(where, draw, scene.draws.front());
}

}  // namespace rasterdiff::checks
