#include "harness/report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "harness/report/npy.hpp"

namespace rasterdiff::harness {
namespace {

struct Rgb {
  float r = 0, g = 0, b = 0;  ///< 0..1
};

uint8_t byteOf(float value) {
  if (!(value > 0)) return 0;  // NaN too
  return static_cast<uint8_t>(std::lround(std::min(value, 1.0F) * 255));
}

/// Averages the covered samples of each pixel; alpha is the share of samples covered. `colourOf` gets the index of a
/// covered sample, in the frame's sample order.
template <class ColourOf>
Image resolved(const Frame& frame, ColourOf&& colourOf) {
  Image image{frame.width, frame.height, std::vector<uint8_t>(size_t{frame.width} * frame.height * 4)};
  const size_t pixels = size_t{frame.width} * frame.height;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    Rgb sum;
    uint32_t covered = 0;
    for (uint32_t s = 0; s < frame.samples; ++s) {
      const size_t sample = pixel * frame.samples + s;
      if (frame.primitive.data[sample] == 0) continue;
      const Rgb colour = colourOf(sample);
      sum = {sum.r + colour.r, sum.g + colour.g, sum.b + colour.b};
      ++covered;
    }
    if (covered == 0) continue;
    const auto n = static_cast<float>(covered);
    uint8_t* out = &image.rgba[pixel * 4];
    out[0] = byteOf(sum.r / n);
    out[1] = byteOf(sum.g / n);
    out[2] = byteOf(sum.b / n);
    out[3] = byteOf(n / static_cast<float>(frame.samples));
  }
  return image;
}

Rgb fromHue(float hue, float saturation, float value) {
  const auto channel = [&](float offset) {
    const float k = std::fmod(offset + hue * 6, 6.0F);
    return value - value * saturation * std::max(0.0F, std::min({k, 4 - k, 1.0F}));
  };
  return {channel(5), channel(3), channel(1)};
}

/// Neighbouring indices get hues a golden angle apart.
Rgb primitiveColour(uint32_t primitive) {
  const float hue = std::fmod(static_cast<float>(primitive % 65536) * 0.61803399F, 1.0F);
  return fromHue(hue, 0.45F + 0.1F * static_cast<float>(primitive % 3), 0.95F - 0.12F * static_cast<float>(primitive % 4));
}

/// Two lights from above, one warm, one cool, wrapped around so that nothing is black.
Rgb shaded(float x, float y, float z) {
  const float length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 0)) return {0.5F, 0.5F, 0.5F};
  const auto light = [&](float lx, float ly, float lz) {
    const float cosine = (x * lx + y * ly + z * lz) / length;
    return std::pow(std::clamp(0.5F + 0.5F * cosine, 0.0F, 1.0F), 1.7F);
  };
  const float key = light(0.48F, 0.64F, 0.6F), fill = light(-0.8F, 0.36F, 0.48F), rim = light(0, -0.28F, -0.96F);
  return {0.05F + 0.88F * key + 0.10F * fill, 0.06F + 0.74F * key + 0.20F * fill + 0.02F * rim,
          0.08F + 0.58F * key + 0.36F * fill + 0.10F * rim};
}

/// Smallest and largest finite value where something was drawn.
Bounds rangeOf(const Frame& frame, const Plane<float>& plane, uint32_t component) {
  Bounds range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (size_t sample = 0; sample < frame.primitive.data.size(); ++sample) {
    const float value = plane.data[sample * plane.components + component];
    if (frame.primitive.data[sample] == 0 || !std::isfinite(value)) continue;
    range.lo = std::min(range.lo, value);
    range.hi = std::max(range.hi, value);
  }
  return range;
}

float stretched(float value, const Bounds& range) {
  return range.hi > range.lo ? (value - range.lo) / (range.hi - range.lo) : 0.5F;
}

bool isNormal(const VaryingPlane& v) { return v.name.starts_with("normal") && v.values.components >= 3; }
bool isColour(const VaryingPlane& v) {
  return (v.name.starts_with("color") || v.name.starts_with("colour")) && v.values.components >= 3;
}

}  // namespace

std::string primitiveColourText(uint32_t primitive) {
  const Rgb colour = primitiveColour(primitive);
  return fmt::format("#{:02x}{:02x}{:02x}", byteOf(colour.r), byteOf(colour.g), byteOf(colour.b));
}

Image primitiveImage(const Frame& frame) {
  // Neighbours often have the same primitive, samples of a pixel above all.
  uint32_t last = 0;
  Rgb colour;
  return resolved(frame, [&](size_t sample) {
    const uint32_t primitive = frame.primitive.data[sample];
    if (primitive != last) colour = primitiveColour(last = primitive);
    return colour;
  });
}

Image overdrawImage(const Frame& frame) {
  constexpr std::array<Rgb, 5> kHeat{{{0.16F, 0.07F, 0.36F}, {0.55F, 0.10F, 0.47F}, {0.89F, 0.32F, 0.24F},
                                      {0.99F, 0.68F, 0.19F}, {1.0F, 0.98F, 0.85F}}};
  return resolved(frame, [&](size_t sample) {
    const float at = std::min(static_cast<float>(frame.count.data[sample] - 1) / 7, 1.0F) * (kHeat.size() - 1);
    const auto below = std::min(static_cast<size_t>(at), kHeat.size() - 2);
    const float t = at - static_cast<float>(below);
    const Rgb &a = kHeat[below], &b = kHeat[below + 1];
    return Rgb{a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
  });
}

Image depthImage(const Frame& frame) {
  const Bounds range = rangeOf(frame, *frame.depth, 0);
  return resolved(frame, [&](size_t sample) {
    const float grey = 0.95F - 0.8F * stretched(frame.depth->data[sample], range);
    return Rgb{grey, grey, grey};
  });
}

Image varyingImage(const Frame& frame, const VaryingPlane& varying) {
  const Plane<float>& plane = varying.values;
  const auto component = [&](size_t sample, uint32_t c) { return plane.data[sample * plane.components + c]; };
  if (isNormal(varying)) {
    // Samples of a pixel often have the same normal.
    std::array<float, 3> last{};
    Rgb colour = shaded(0, 0, 0);
    return resolved(frame, [&](size_t s) {
      const std::array<float, 3> normal{component(s, 0), component(s, 1), component(s, 2)};
      if (normal != last) colour = shaded(normal[0], normal[1], normal[2]), last = normal;
      return colour;
    });
  }
  if (isColour(varying)) {
    return resolved(frame, [&](size_t s) { return Rgb{component(s, 0), component(s, 1), component(s, 2)}; });
  }
  std::array<Bounds, 3> ranges{};
  for (uint32_t c = 0; c < std::min(plane.components, 3U); ++c) ranges[c] = rangeOf(frame, plane, c);
  return resolved(frame, [&](size_t s) {
    std::array<float, 3> rgb{};
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t from = plane.components == 1 ? 0 : c;
      rgb[c] = from < plane.components ? stretched(component(s, from), ranges[from]) : 0.5F;
    }
    return Rgb{rgb[0], rgb[1], rgb[2]};
  });
}

std::vector<std::pair<std::string, Image>> allImages(const Frame& frame) {
  std::vector<std::pair<std::string, Image>> images;
  images.emplace_back("primitive", primitiveImage(frame));
  images.emplace_back("count", overdrawImage(frame));
  if (frame.depth) images.emplace_back("depth", depthImage(frame));
  for (const VaryingPlane& varying : frame.varyings) {
    images.emplace_back(planeFileName(varying.name), varyingImage(frame, varying));
  }
  return images;
}

Image glanceImage(const Frame& frame) {
  const auto& all = frame.varyings;
  auto shown = std::find_if(all.begin(), all.end(), isNormal);
  if (shown == all.end()) shown = std::find_if(all.begin(), all.end(), isColour);
  return shown == all.end() ? primitiveImage(frame) : varyingImage(frame, *shown);
}

}  // namespace rasterdiff::harness
