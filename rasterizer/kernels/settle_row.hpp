// What a row of numbered pieces becomes in a frame: where runs of one piece begin, and along each run the piece's primitive and the
// bounds of its depth. Bounds are linearOver's and roundedDepth's (fragment/value_planes.hpp, depth/depth_stage.hpp), bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "rasterizer/fragment/linear_function.hpp"

namespace rasterdiff::rasterizer {

/// Pixels behind a row's last that the functions below may read or write.
inline constexpr size_t kRowSlack = 16;

/// Writes the first pixel of each run of equal numbers to `starts`, which has room for width + kRowSlack; returns how many.
size_t findRuns(const uint32_t* numbers, size_t width, uint32_t* starts);

/// Pixels [begin, end) of a row.
struct SettledRun {
  uint32_t begin = 0, end = 0;
  uint32_t primitive = 0;
  uint32_t plane = 0;  ///< 1 + the place of its planes; 0: `none` are its bounds
};

/// One row at a time, pixels beside one another.
struct SettledRow {
  uint32_t* primitive = nullptr;
  Bounds* bounds = nullptr;  ///< of depth; null for frames without
};

/// Writes the runs, which follow one another from pixel 0 to the row's end. The depth of pixel x is evaluated at (x + offset, y); its
/// plane is the first of the `each` planes of a run's piece.
void settleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, size_t each, double offset, double y, Bounds none, const SettledRow& row);

}  // namespace rasterdiff::rasterizer
