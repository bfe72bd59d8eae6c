// Scenes designed so that answers to one question draw different pictures. One function a question; who draws them, and
// what is concluded, is the engine's business (elimination.hpp).
#pragma once

#include "harness/infer/elimination.hpp"

namespace rasterdiff::harness {

/// Sample counts among 1, 2, 4, 8, 16 that the device offers.
[[nodiscard]] std::vector<uint32_t> sampleCounts(const Limits& limits);

/// Triangles on the grid of 1/16 pixel, whose edges run through samples in all directions: who owns them?
[[nodiscard]] Scene tieScene(Prng& random, uint32_t samples, const rasterizer::Rules& rules);

/// Edges whose middle is a sample if one end is snapped one way, and beside it if the other way. The end is halfway between
/// two grid points (`halves`) or anywhere, also at negative coordinates. Every float32 viewport transform is exact here.
[[nodiscard]] Scene snapScene(Prng& random, uint32_t samples, bool halves, const rasterizer::Rules& rules);

/// Edges that the contenders' arithmetic puts on different sides of a sample: viewports and w of all kinds, which hold the
/// whole target. None if no vertex was found that two of them snap to different places.
[[nodiscard]] std::optional<Scene> viewportScene(Prng& random, uint32_t samples, std::span<const rasterizer::Rules> contenders);

/// Triangles that leave the view volume through its sides, near and far. None if all contenders draw the same.
[[nodiscard]] std::optional<Scene> clipScene(Prng& random, uint32_t samples, std::span<const rasterizer::Rules> contenders);

/// Slivers about a grid step wide that leave through planes, seen from both sides, some of them culled: clipping and snapping
/// fold what is left of them, or turn it over. None as above.
[[nodiscard]] std::optional<Scene> sliverScene(Prng& random, uint32_t samples, std::span<const rasterizer::Rules> contenders);

/// Triangles inside of the view volume, at all w, with one clip distance or two. None as above.
[[nodiscard]] std::optional<Scene> distanceScene(Prng& random, uint32_t samples, std::span<const rasterizer::Rules> contenders);

/// Triangles as lines or points, which leave the view volume, and through a clip distance if there are `distances`.
/// None as above.
[[nodiscard]] std::optional<Scene> outlineScene(Prng& random, uint32_t samples, bool distances,
                                                std::span<const rasterizer::Rules> contenders);

/// Triangles in a viewport with fractions, cut by a scissor. None as above.
[[nodiscard]] std::optional<Scene> regionScene(Prng& random, uint32_t samples, std::span<const rasterizer::Rules> contenders);

/// Points of sizes between those that the device offers, granular or not, below one pixel too; the sides of half of them lie
/// within a grid step of a sample.
[[nodiscard]] Scene pointScene(Prng& random, uint32_t samples, const rasterizer::Rules& rules);

/// Points whose vertices lie outside of the view volume, a little or far.
[[nodiscard]] Scene outerPointScene(Prng& random, uint32_t samples, const rasterizer::Rules& rules);

/// Lines of a mode and width that the device offers; none if it offers no such mode. `bresenham`: which mode.
[[nodiscard]] std::optional<Scene> lineScene(Prng& random, uint32_t samples, bool bresenham, const Limits& limits);

/// Bresenham lines from and to the corners and edges of pixels' diamonds, in all octants. None as above.
[[nodiscard]] std::optional<Scene> diamondScene(Prng& random, uint32_t samples, const Limits& limits);

/// Slanted triangles with depth bias on a fixed-point or a float format.
[[nodiscard]] Scene biasScene(Prng& random, DepthFormat format);

/// Partly covered pixels with an input whose value is the place where it was evaluated, in pixels.
[[nodiscard]] Scene placeScene(Prng& random, uint32_t samples, Interpolation interpolation, bool perspective);

/// Small triangles between grid points with steep values.
[[nodiscard]] Scene steepScene(Prng& random);

/// Perspective values over triangles that leave the view volume, some behind the eye.
[[nodiscard]] Scene steepCutScene(Prng& random);

/// Overlapping constant triangles, whose samples are averaged.
[[nodiscard]] Scene resolveScene(Prng& random, uint32_t samples);

/// Depth and inputs of both interpolations, in perspective.
[[nodiscard]] Scene valueScene(Prng& random);

}  // namespace rasterdiff::harness
