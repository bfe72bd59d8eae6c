// Random state for a random scene: what is cut off, culled, scissored or moved, by a seed. Each function changes one
// thing and keeps the rest.
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace rasterdiff {

/// Moves all positions away from the middle by a factor, so that primitives leave the volume through its sides.
void spreadOut(Scene& scene, float factor);

/// Gives every vertex a depth from -w/2 to 3w/2: three in a hundred lie exactly on the near or the far plane.
void leaveDepthRange(Scene& scene, uint64_t seed);

/// `count` distances a vertex, multiples of 1/16 in -1..1, one in ten exactly 0; the more distances, the fewer of them
/// are negative. Cull distances are of mixed signs.
void giveClipDistances(Scene& scene, uint64_t seed, uint32_t count);
void giveCullDistances(Scene& scene, uint64_t seed, uint32_t count);

/// A cull mode other than NONE, and a front face.
void giveCulling(Scene& scene, uint64_t seed);

/// A scissor rectangle inside the target; one in eight is a single pixel, row or column.
void giveScissor(Scene& scene, uint64_t seed);

/// A shader that writes a sample mask, of one bit at least, or that of its input; every other scene has a pSampleMask as well.
void giveMasks(Scene& scene, uint64_t seed);

/// A viewport with a fractional origin and size that reaches over borders of the target; every other one is flipped,
/// and one in three has a reversed or partial depth range.
void giveViewport(Scene& scene, uint64_t seed);

/// A depth attachment, tested and written.
void giveDepth(Scene& scene, uint64_t seed, DepthFormat format);

/// Depth bias of each sign, constant and by slope; one in three is clamped.
void giveDepthBias(Scene& scene, uint64_t seed);

/// A stipple pattern and factor. Every fourth pattern is one of few bits.
void giveStipple(Scene& scene, uint64_t seed);

}  // namespace rasterdiff
