// One band of rows of a frame through the kernels: its triangles drawn into planes that stay in the cache, then settled: numbers of
// pieces become primitives, and depths get the bounds of what a float32 evaluation may give. Bounds equal LateValues'.
#pragma once

#include <vector>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/kernels/row_tally.hpp"
#include "rasterizer/kernels/settle_row.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

/// How well a triangle's corners are known.
struct CornerErrors {
  double deviation = 0;   ///< pixels, in x and in y
  double inputError = 0;  ///< of the depths
};

/// Pieces that reach into a band, in drawing order: oriented, so that their double area is positive. The last two are empty
/// for frames without depth.
struct BandPieces {
  std::vector<SnappedTriangle> positions;
  std::vector<uint32_t> primitives;
  std::vector<DepthCorners> corners;
  std::vector<CornerErrors> errors;
};

/// What came of a band, for rule counts.
struct BandTally {
  RowTally rows;
  uint64_t met = 0;      ///< fragments that met exactly the depth that was there
  uint64_t drawn = 0;    ///< fragments that passed
  uint64_t covered = 0;  ///< samples with a primitive
  BandTally& operator+=(const BandTally& other);
};

/// Draws bands of one frame, one after the other, each from the lists of several makers of pieces.
class BandDrawer {
 public:
  /// `frame`, whose planes need not be written yet, and `pattern` must outlive this object; `clear`: of depth. `rows`: most rows
  /// of a band, a multiple of 8.
  BandDrawer(Frame& frame, std::span<const SubpixelPosition> pattern, const Interpolated& clear, uint32_t rows);

  /// Writes all planes of rows [firstRow, endRow); counts rows only where `counted`.
  BandTally draw(std::span<const BandPieces* const> lists, uint32_t firstRow, uint32_t endRow, bool counted);

 private:
  struct Piece {
    uint32_t primitive;
    const LinearFunction* depth;  ///< null without depth
  };

  void settleRow(std::span<const BandPieces* const> lists, uint32_t firstRow, uint32_t y, BandTally& tally);
  /// What settleRow made, samples beside one another. kSamples: 0 if it is not known when compiling.
  template <size_t kSamples>
  void writeRow(uint32_t bandRow, uint32_t y, BandTally& tally);
  /// Of number `piece` of all lists together, from 1 on; 0 is none.
  [[nodiscard]] Piece pieceOf(std::span<const BandPieces* const> lists, uint32_t piece);

  Frame& frame_;
  const std::span<const SubpixelPosition> pattern_;
  const Interpolated clear_;
  ValueTarget target_;
  std::vector<uint32_t> planeOf_;  ///< of each piece: 1 + its place in planes_, 0: not seen yet
  std::vector<LinearFunction> planes_;
  std::vector<uint32_t> starts_;
  std::vector<SettledRun> runs_;
  std::vector<uint32_t> primitives_;  ///< of a row: samples below one another, kRowSlack between them
  std::vector<float> lo_, hi_;
};

}  // namespace rasterdiff::rasterizer
