// Where two frames differ, as a picture, and pictures made small without losing a single differing sample.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "harness/report/picture.hpp"

namespace rasterdiff::harness {
namespace {

/// From harmless to wrong; the order is the rank when several samples share a pixel.
enum class Mark : uint8_t { Empty, Same, ValueClose, ValueHalfway, ValueFar, Allowed, Differs };

using Rgba = std::array<uint8_t, 4>;
constexpr std::array<Rgba, 7> kColours{{{0, 0, 0, 0},
                                        {128, 132, 140, 70},
                                        {152, 140, 110, 110},
                                        {164, 128, 60, 160},
                                        {186, 128, 20, 215},
                                        {245, 197, 24, 255},
                                        {226, 32, 48, 255}}};

/// How far inside its legal interval a value lies: an error below a tenth, below a half, up to the whole of the way.
Mark markOfValue(float expected, float actual, const Bounds& bounds) {
  if (!(actual >= bounds.lo && actual <= bounds.hi)) return Mark::Differs;
  const double room = actual > expected ? double{bounds.hi} - expected : double{expected} - bounds.lo;
  const double share = room > 0 ? std::abs(double{actual} - expected) / room : 0;
  return share < 0.1 ? Mark::ValueClose : share < 0.5 ? Mark::ValueHalfway : Mark::ValueFar;
}

/// Same bits, else by the bounds. Planes without bounds allow nothing but the same bits.
Mark markOfValues(const Plane<float>& expected, const std::optional<Plane<Bounds>>& bounds, const Plane<float>& actual,
                  size_t sample) {
  Mark mark = Mark::Same;
  for (uint32_t c = 0; c < expected.components; ++c) {
    const size_t at = sample * expected.components + c;
    if (std::bit_cast<uint32_t>(expected.data[at]) == std::bit_cast<uint32_t>(actual.data[at])) continue;
    if (!bounds) return Mark::Differs;
    mark = std::max(mark, markOfValue(expected.data[at], actual.data[at], bounds->data[at]));
  }
  return mark;
}

class Marker {
 public:
  Marker(const Frame& reference, const Frame& actual, const SceneResult& result)
      : reference_(reference), actual_(actual), onlyAllowed_(result.differing == 0), onlyDiffers_(result.allowed == 0) {}

  /// Of the values that samples were resolved to; resolved planes have one sample a pixel.
  [[nodiscard]] Mark markOfResolved(size_t pixel) const {
    Mark mark = Mark::Empty;
    const size_t planes = std::min(reference_.resolved.size(), actual_.resolved.size());
    for (size_t v = 0; v < planes; ++v) {
      const VaryingPlane& expected = reference_.resolved[v];
      const Mark value = markOfValues(expected.values, expected.bounds, actual_.resolved[v].values, pixel);
      if (value != Mark::Same) mark = std::max(mark, value);
    }
    return mark;
  }

  [[nodiscard]] Mark markOf(size_t sample) const {
    if (reference_.primitive.data[sample] != actual_.primitive.data[sample] ||
        reference_.count.data[sample] != actual_.count.data[sample]) {
      if (onlyAllowed_) return Mark::Allowed;
      if (onlyDiffers_ || !reference_.coverage) return Mark::Differs;
      return reference_.coverage->data[sample] == Coverage::Either ? Mark::Allowed : Mark::Differs;
    }
    if (reference_.primitive.data[sample] == 0) return Mark::Empty;
    Mark mark = Mark::Same;
    if (reference_.depth && actual_.depth) {
      mark = markOfValues(*reference_.depth, reference_.depthBounds, *actual_.depth, sample);
    }
    const size_t varyings = std::min(reference_.varyings.size(), actual_.varyings.size());
    for (size_t v = 0; v < varyings; ++v) {
      const VaryingPlane& expected = reference_.varyings[v];
      mark = std::max(mark, markOfValues(expected.values, expected.bounds, actual_.varyings[v].values, sample));
    }
    return mark;
  }

 private:
  const Frame& reference_;
  const Frame& actual_;
  bool onlyAllowed_, onlyDiffers_;  ///< the scene's coverage counts leave one answer for every sample
};

void put(Image& image, size_t pixel, Mark mark) {
  const Rgba& colour = kColours[static_cast<size_t>(mark)];
  std::copy(colour.begin(), colour.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(pixel * 4));
}

size_t rankOf(const uint8_t* rgba) {
  for (size_t mark = kColours.size(); mark-- > 0;) {
    if (std::equal(kColours[mark].begin(), kColours[mark].end(), rgba)) return mark;
  }
  return 0;
}

/// One output pixel of the box [x0, x1) × [y0, y1): the mean, each colour weighted by its alpha.
Rgba averageOf(const Image& image, uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
  std::array<uint64_t, 4> sum{};
  for (uint32_t y = y0; y < y1; ++y) {
    for (uint32_t x = x0; x < x1; ++x) {
      const uint8_t* p = &image.rgba[(size_t{y} * image.width + x) * 4];
      for (size_t c = 0; c < 3; ++c) sum[c] += uint64_t{p[c]} * p[3];
      sum[3] += p[3];
    }
  }
  Rgba out{};
  if (sum[3] == 0) return out;
  for (size_t c = 0; c < 3; ++c) out[c] = static_cast<uint8_t>(sum[c] / sum[3]);
  out[3] = static_cast<uint8_t>(sum[3] / (uint64_t{x1 - x0} * (y1 - y0)));
  return out;
}

Rgba worstOf(const Image& image, uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
  size_t worst = 0;
  for (uint32_t y = y0; y < y1; ++y) {
    for (uint32_t x = x0; x < x1; ++x) worst = std::max(worst, rankOf(&image.rgba[(size_t{y} * image.width + x) * 4]));
  }
  return kColours[worst];
}

}  // namespace

Image differenceImage(const Frame& reference, const Frame& actual, const SceneResult& result) {
  Image image{reference.width, reference.height, std::vector<uint8_t>(size_t{reference.width} * reference.height * 4)};
  const Marker marker(reference, actual, result);
  const size_t pixels = size_t{reference.width} * reference.height;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    Mark mark = marker.markOfResolved(pixel);
    for (uint32_t s = 0; s < reference.samples; ++s) mark = std::max(mark, marker.markOf(pixel * reference.samples + s));
    put(image, pixel, mark);
  }
  for (const SampleDifference& difference : result.differences) {
    if (difference.verdict != Verdict::Differs) continue;
    put(image, size_t{difference.y} * reference.width + difference.x, Mark::Differs);
  }
  return image;
}

Image shrunk(Image image, uint32_t maxWidth, Shrink how) {
  const uint32_t longest = std::max(image.width, image.height);
  if (longest <= maxWidth) return image;
  const uint32_t box = (longest + maxWidth - 1) / maxWidth;
  Image small{(image.width + box - 1) / box, (image.height + box - 1) / box, {}};
  small.rgba.resize(size_t{small.width} * small.height * 4);
  for (uint32_t y = 0; y < small.height; ++y) {
    for (uint32_t x = 0; x < small.width; ++x) {
      const uint32_t x0 = x * box, x1 = std::min(x0 + box, image.width);
      const uint32_t y0 = y * box, y1 = std::min(y0 + box, image.height);
      const Rgba colour = how == Shrink::Average ? averageOf(image, x0, x1, y0, y1) : worstOf(image, x0, x1, y0, y1);
      std::copy(colour.begin(), colour.end(), &small.rgba[(size_t{y} * small.width + x) * 4]);
    }
  }
  return small;
}

}  // namespace rasterdiff::harness
