// One band of rows of a frame through the kernels: its triangles drawn into planes that stay in the cache, then settled: numbers of
// pieces become primitives, and depths get the bounds of what a float32 evaluation may give. Bounds equal LateValues'.
#pragma once

#include <vector>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/kernel_inputs.hpp"
#include "rasterizer/kernel_pieces.hpp"
#include "rasterizer/kernels/depth_planes.hpp"
#include "rasterizer/kernels/row_tally.hpp"
#include "rasterizer/kernels/settle_row.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

/// What came of a band, for rule counts.
struct BandTally {
  RowTally rows;
  uint64_t met = 0;      ///< fragments that met exactly the depth that was there
  uint64_t drawn = 0;    ///< fragments that passed
  uint64_t covered = 0;  ///< samples with a primitive
  uint64_t ofCut = 0, ofMany = 0;  ///< samples inside of pieces of cut primitives; of those with more than three corners; with inputs
  BandTally& operator+=(const BandTally& other);
};

/// Draws bands of one frame, one after the other.
class BandDrawer {
 public:
  /// All that is given must outlive this object; the planes of `frame` need not be written yet. `clear`: of depth. `inputs`: null
  /// where there are none.
  BandDrawer(const KernelGeometry& geometry, Frame& frame, std::span<const SubpixelPosition> pattern, const Interpolated& clear, BandRows rows,
             std::unique_ptr<KernelInputs> inputs);

  /// Writes all planes of the band's rows; counts rows only where `counted`.
  BandTally draw(uint32_t band, bool counted);

 private:
  /// Fetches the band's pieces: those of all parts in a row, so that number n is element n - 1.
  void gather(uint32_t band);
  /// Runs of rows [0, rows) of the target, and planes of the pieces that are seen.
  void findRuns(uint32_t rows);
  /// 1 + the place of the planes of piece `number`.
  [[nodiscard]] uint32_t planeOf(uint32_t number);
  void countCut(const TallyArea& area, BandTally& tally);
  void settleRow(uint32_t bandRow, uint32_t y, bool last);
  /// What settleRow made of several samples a pixel, samples beside one another. kSamples: 0 if it is not known when compiling.
  template <size_t kSamples>
  void interleave(uint32_t y);
  /// Counts and depths.
  void copyRow(uint32_t bandRow, uint32_t y, BandTally& tally);

  const KernelGeometry& geometry_;
  Frame& frame_;
  const std::span<const SubpixelPosition> pattern_;
  const Interpolated clear_;
  const BandRows rows_;
  ValueTarget target_;
  const std::unique_ptr<KernelInputs> inputs_;
  // The band's pieces.
  std::vector<SnappedTriangle> positions_;
  std::vector<DepthCorners> corners_;
  std::vector<uint32_t> primitives_;
  std::vector<CornerErrors> errors_;
  std::vector<PieceOrigin> origins_;
  std::vector<uint32_t> seen_;  ///< of each piece: 1 + the place of its planes, 0: nowhere seen
  std::vector<uint32_t> seenNumbers_;
  std::vector<LinearFunction> planes_;  ///< of depth, where there are no inputs
  // Runs of equal numbers, row by row, samples below one another.
  std::vector<uint32_t> starts_;
  std::vector<SettledRun> runs_;
  std::vector<size_t> rowRuns_;  ///< first run of each row of the target; one more at the end
  // A row, pixels beside one another, samples below one another with kRowSlack between them.
  std::vector<uint32_t> rowPrimitives_;
  std::vector<Bounds> rowBounds_;
};

}  // namespace rasterdiff::rasterizer
