// The inputs of the samples that are left when all is drawn: along each run of pixels of one piece, values at the pixels' centres with
// the bounds of what a float32 evaluation may give. Values and bounds are linearOver's and quotientOver's (fragment/value_planes.hpp),
// bit for bit.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/kernels/settle_row.hpp"
#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// Where one component of one row goes: that of pixel x is element x · stride.
struct InputRow {
  float* values = nullptr;
  Bounds* bounds = nullptr;
  size_t stride = 1;
};

/// The inputs of pieces: piece n has planes [n · planesEach, (n + 1) · planesEach) and as many constants as there are kinds.
struct InputPlanes {
  std::span<const ValueKind> kinds;         ///< one a component
  std::span<const LinearFunction> planes;   ///< of each piece the last ones are of its components; perspective ones divided by w
  size_t planesEach = 0;
  size_t reciprocalW = 0;                   ///< which of a piece's planes is 1 / w, where something is perspective
  std::span<const float> constants;         ///< of flat components
  bool anywhere = false;                    ///< an input may legally be evaluated anywhere in its pixel
};

/// Evaluates pixels [run.begin, run.end) of row y from piece run.plane - 1, for all runs; rows: one a component.
void settleInputs(std::span<const SettledRun> runs, const InputPlanes& pieces, uint32_t y, std::span<const InputRow> rows);

}  // namespace rasterdiff::rasterizer
