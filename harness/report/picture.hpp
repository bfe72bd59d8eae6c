// A Frame as pictures for people: samples averaged, background transparent, colours that never change between runs.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "harness/compare/verdict.hpp"
#include "scene/frame.hpp"
#include "scene/result.hpp"

namespace rasterdiff::harness {

/// 8-bit RGBA (straight alpha), row-major, 4 bytes a pixel.
struct Image {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

/// A flat colour per primitive; the index alone decides it.
[[nodiscard]] Image primitiveImage(const Frame& frame);
/// That colour as "#rrggbb".
[[nodiscard]] std::string primitiveColourText(uint32_t primitive);
/// Overdraw as heat: 1 dark violet … 8 and more white.
[[nodiscard]] Image overdrawImage(const Frame& frame);
/// Depth as grey, near = bright, stretched over the depths that were drawn. The frame must have depth.
[[nodiscard]] Image depthImage(const Frame& frame);
/// A varying named like a normal as a shaded surface, like a colour as itself, any other stretched over its range.
[[nodiscard]] Image varyingImage(const Frame& frame, const VaryingPlane& varying);

/// All of them with the file name (without ending) that `render` gives them.
[[nodiscard]] std::vector<std::pair<std::string, Image>> allImages(const Frame& frame);

/// The one picture that shows most at a glance: a normal or colour varying if there is one, else the primitives.
[[nodiscard]] Image glanceImage(const Frame& frame);

/// Same = dim, values inside their bounds but not the same bits = ochre, the stronger the nearer they are to a bound,
/// Allowed coverage = yellow, Differs = red.
/// Where a scene holds both Allowed and Differs, samples that `result` does not list are coloured by the reference's
/// own knowledge (Either, bounds).
[[nodiscard]] Image differenceImage(const Frame& reference, const Frame& actual, const SceneResult& result);

enum class Shrink { Average, Worst };
/// At most `maxWidth` × `maxWidth` pixels: boxes of pixels averaged, or (Worst) the reddest, then yellowest pixel kept.
[[nodiscard]] Image shrunk(Image image, uint32_t maxWidth, Shrink how);

/// The picture as a PNG file in memory. Error: Io, the library's message.
[[nodiscard]] Result<std::string> encodePng(const Image& image);

}  // namespace rasterdiff::harness
