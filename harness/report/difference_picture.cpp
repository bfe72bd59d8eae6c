// Where two frames differ, as a picture, and pictures made small without losing a single differing sample.
#include <algorithm>
#include <array>

#include "harness/report/picture.hpp"
#include "harness/report/sample_mark.hpp"

namespace rasterdiff::harness {
namespace {

using Rgba = std::array<uint8_t, 4>;
constexpr std::array<Rgba, 7> kColours{{{0, 0, 0, 0},
                                        {128, 132, 140, 70},
                                        {152, 140, 110, 110},
                                        {164, 128, 60, 160},
                                        {186, 128, 20, 215},
                                        {245, 197, 24, 255},
                                        {226, 32, 48, 255}}};

void put(Image& image, size_t pixel, SampleMark mark) {
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
  const SampleMarker marker(reference, actual, result);
  const size_t pixels = size_t{reference.width} * reference.height;
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    SampleMark mark = marker.markOfResolved(pixel);
    for (uint32_t s = 0; s < reference.samples; ++s) mark = std::max(mark, marker.markOf(pixel * reference.samples + s));
    put(image, pixel, mark);
  }
  for (const SampleDifference& difference : result.differences) {
    if (difference.verdict != Verdict::Differs) continue;
    put(image, size_t{difference.y} * reference.width + difference.x, SampleMark::Differs);
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
