// Checks of name, target, viewports and scissors.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scene/checks.hpp"
#include "scene/file/enum_names.hpp"

namespace rasterdiff::checks {
namespace {

Check checkExtent(const std::string& where, uint32_t value, uint32_t supersample) {
  if (value < 1 || value > kMaxTargetExtent) {
    return bad(where, fmt::format("{} is outside 1..{}", value, kMaxTargetExtent));
  }
  if (uint64_t{value} * supersample > kMaxTargetExtent) {
    return bad(where, fmt::format("{} pixels, supersampled {} times, exceed {}", value, supersample, kMaxTargetExtent),
               "use a smaller target or fewer samples a pixel");
  }
  return {};
}

/// [vk:VkViewport] the bounds that every device has to offer for a viewport of kMaxTargetExtent.
Check checkViewport(const std::string& where, Viewport v, uint32_t supersample) {
  for (float* f : {&v.x, &v.y, &v.width, &v.height}) *f *= static_cast<float>(supersample);
  constexpr float kExtent = kMaxTargetExtent, kBounds = 2 * kExtent;
  const std::string times = supersample > 1 ? fmt::format(" (supersampled {} times)", supersample) : "";
  if (!(v.width > 0 && v.width <= kExtent)) {
    return bad(where + ".width", fmt::format("{} is outside (0, {}]{}", v.width, kExtent, times));
  }
  if (!(std::fabs(v.height) > 0 && std::fabs(v.height) <= kExtent)) {
    return bad(where + ".height",
               fmt::format("{} is zero or outside [-{}, {}]{}", v.height, kExtent, kExtent, times));
  }
  if (!(v.x >= -kBounds && v.x + v.width <= kBounds - 1)) {
    return bad(where + ".x",
               fmt::format("{} .. {} leaves [-{}, {}]{}", v.x, v.x + v.width, kBounds, kBounds - 1, times));
  }
  const float low = std::min(v.y, v.y + v.height), high = std::max(v.y, v.y + v.height);
  if (!(low >= -kBounds && high <= kBounds - 1)) {
    return bad(where + ".y", fmt::format("{} .. {} leaves [-{}, {}]{}", low, high, kBounds, kBounds - 1, times));
  }
  if (!(v.minDepth >= 0 && v.minDepth <= 1)) {
    return bad(where + ".minDepth", fmt::format("{} is outside 0..1", v.minDepth));
  }
  if (!(v.maxDepth >= 0 && v.maxDepth <= 1)) {
    return bad(where + ".maxDepth", fmt::format("{} is outside 0..1", v.maxDepth));
  }
  return {};
}

/// [vk:VkRect2D] offsets are not negative and the far corner fits int32.
Check checkScissor(const std::string& where, const Rect2D& scissor, uint32_t supersample) {
  const auto axis = [&](const char* offsetName, int32_t offset, const char* extentName, uint32_t extent) -> Check {
    if (offset < 0) return bad(where + offsetName, fmt::format("{} is negative", offset));
    if (extent == 0) return bad(where + extentName, "a scissor of size zero lets nothing through");
    if ((int64_t{offset} + extent) * supersample > INT32_MAX) {
      return bad(where + extentName, supersample == 1 ? "offset + extent exceeds 2147483647"
                                                      : "offset + extent, supersampled, exceeds 2147483647");
    }
    return {};
  };
  if (auto ok = axis(".x", scissor.x, ".width", scissor.width); !ok) return ok;
  return axis(".y", scissor.y, ".height", scissor.height);
}

/// [vk:VkSampleLocationsInfoEXT]
Check checkSampleLocations(const Target& target) {
  if (!target.sampleLocations) return {};
  const SampleLocationsInfo& info = *target.sampleLocations;
  const std::string where = "target.sampleLocations";
  if (target.samples == 1) return bad(where, "one sample a pixel stays at the centre", "set target.samples to 4");
  for (const uint32_t extent : {info.gridWidth, info.gridHeight}) {
    if (extent < 1 || extent > kMaxSampleLocationGrid) {
      return bad(where + ".sampleLocationGridSize", fmt::format("{} is outside 1..{}", extent, kMaxSampleLocationGrid));
    }
  }
  const size_t wanted = size_t{target.samples} * info.gridWidth * info.gridHeight;
  if (info.sampleLocations.size() != wanted) {
    return bad(where + ".sampleLocations", fmt::format("{} locations for {} samples of {} × {} pixels",
                                                       info.sampleLocations.size(), target.samples, info.gridWidth,
                                                       info.gridHeight),
               fmt::format("{} locations", wanted));
  }
  for (size_t i = 0; i < wanted; ++i) {
    const SampleLocationEXT& location = info.sampleLocations[i];
    if (!std::isfinite(location.x) || !std::isfinite(location.y)) {
      return bad(fmt::format("{}.sampleLocations[{}]", where, i), "a location that is not finite");
    }
  }
  return {};
}

}  // namespace

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

Check checkTarget(const Target& target) {
  if (target.supersample < 1 || target.supersample > kMaxSupersample) {
    return bad("target.supersample", fmt::format("{} is outside 1..{}", target.supersample, kMaxSupersample));
  }
  if (auto ok = checkExtent("target.width", target.width, target.supersample); !ok) return ok;
  if (auto ok = checkExtent("target.height", target.height, target.supersample); !ok) return ok;
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
  if (target.depthFormat && enumName(*target.depthFormat).empty()) {
    return bad("target.depthFormat", fmt::format("unknown format {}", static_cast<uint32_t>(*target.depthFormat)),
               "D32_SFLOAT");
  }
  if (target.resolve && target.samples == 1) {
    return bad("target.resolve", "one sample a pixel needs no resolve", "set target.samples to 4");
  }
  if (target.depthResolveMode) {
    if (enumName(*target.depthResolveMode).empty()) {
      return bad("target.depthResolveMode", fmt::format("unknown mode {}", static_cast<uint32_t>(*target.depthResolveMode)),
                 "SAMPLE_ZERO");
    }
    if (target.samples == 1) return bad("target.depthResolveMode", "one sample a pixel needs no resolve", "set target.samples to 4");
    if (!target.depthFormat) {
      return bad("target.depthResolveMode", "no depth attachment to resolve", "set target.depthFormat to D32_SFLOAT");
    }
  }
  return checkSampleLocations(target);
}

Check checkViewports(const Scene& scene) {
  const uint32_t supersample = scene.target.supersample;
  if (auto ok = checkViewport("viewport", scene.viewport, supersample); !ok) return ok;
  if (scene.scissor) {
    if (auto ok = checkScissor("scissor", *scene.scissor, supersample); !ok) return ok;
  }
  if (scene.furtherViewports.size() >= kMaxViewports) {
    return bad("furtherViewports", fmt::format("{} further viewports; at most {}", scene.furtherViewports.size(),
                                               kMaxViewports - 1));
  }
  for (size_t i = 0; i < scene.furtherViewports.size(); ++i) {
    const ViewportAndScissor& further = scene.furtherViewports[i];
    const std::string where = fmt::format("furtherViewports[{}]", i);
    if (auto ok = checkViewport(where + ".viewport", further.viewport, supersample); !ok) return ok;
    if (!further.scissor) continue;
    if (auto ok = checkScissor(where + ".scissor", *further.scissor, supersample); !ok) return ok;
  }
  return {};
}

}  // namespace rasterdiff::checks
