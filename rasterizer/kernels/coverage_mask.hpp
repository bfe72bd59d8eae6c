// One bit a sample: the target of the coverage kernels, and the fast exact kernel that draws into it. What a sample
// belongs to (int64 edge functions, top-left ties) is defined by coverage_oracle.hpp, which it equals bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "scene/result.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::rasterizer {

/// A bit mask in blocks of 64 pixels × 8 rows: eight words, one cache line, one 512-bit vector.
/// Blocks start every 32 pixels, so that a primitive of up to 33 pixels fits into one; those at odd multiples of 32
/// are scratch that `settle` folds into their two neighbours. Order: block row, block column, sample, row in block.
class CoverageMask {
 public:
  static constexpr uint32_t kBlockWidth = 64, kBlockHeight = 8, kBlockStep = 32;

  /// An empty mask; `width`, `height` in pixels (1 to 32768), `samples` 1, 2, 4, 8 or 16 at the standard locations.
  /// Error: BadInput for another size, NotOffered for another sample count.
  [[nodiscard]] static Result<CoverageMask> create(uint32_t width, uint32_t height, uint32_t samples);

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  [[nodiscard]] uint32_t samples() const { return static_cast<uint32_t>(locations_.size()); }
  [[nodiscard]] std::span<const SampleLocation> locations() const { return locations_; }

  /// Is sample `s` of pixel (x, y) covered? Only after `settle`.
  [[nodiscard]] bool at(uint32_t x, uint32_t y, uint32_t s) const { return (word(x / 64, y, s) >> (x % 64) & 1) != 0; }
  /// 64 pixels of row y from pixel 64·column, lowest bit leftmost. Only after `settle`.
  [[nodiscard]] uint64_t word(uint32_t column, uint32_t y, uint32_t s) const {
    return words()[blockOffset(y / 8, 2 * column, s) + y % 8];
  }
  void set(uint32_t x, uint32_t y, uint32_t s) {
    words()[blockOffset(y / 8, x / 64 * 2, s) + y % 8] |= uint64_t{1} << (x % 64);
  }
  void clear();
  /// Number of covered samples. Only after `settle`.
  [[nodiscard]] uint64_t count() const;
  /// Number of samples in which two masks of the same shape differ. Only after `settle` of both.
  [[nodiscard]] uint64_t differing(const CoverageMask& other) const;

  /// For kernels: first word of a block; `halfColumn` counts steps of 32 pixels.
  [[nodiscard]] size_t blockOffset(uint32_t blockRow, uint32_t halfColumn, uint32_t s) const {
    return ((size_t{blockRow} * halfColumns_ + halfColumn) * locations_.size() + s) * kBlockHeight;
  }
  [[nodiscard]] uint64_t* words() { return reinterpret_cast<uint64_t*>(storage_.data()); }
  [[nodiscard]] const uint64_t* words() const { return reinterpret_cast<const uint64_t*>(storage_.data()); }
  [[nodiscard]] uint32_t halfColumns() const { return halfColumns_; }
  [[nodiscard]] uint32_t blockRows() const { return (height_ + kBlockHeight - 1) / kBlockHeight; }
  /// For kernels: bit w % 64 of word (w / 64) · fullStride() + block row says that window w, a block at an even half column,
  /// is full in every sample. Readable and writable for eight block rows beyond the target.
  [[nodiscard]] uint64_t* full() { return full_.data(); }
  [[nodiscard]] size_t fullStride() const { return size_t{blockRows()} + kBlockHeight; }
  /// For kernels: scratch too, tall blocks of 32 pixels × 16 rows, 16 words of 32 bits each. They start every 16 pixels.
  /// Order: row of blocks (tallStride of them), column, sample. Made at the first call; 64-byte aligned.
  [[nodiscard]] uint64_t* tall();
  [[nodiscard]] size_t tallStride() const { return 2 * size_t{halfColumns_} + 2; }
  /// Windows [first, end) of the block rows [firstRow, endRow).
  struct Windows {
    uint32_t firstRow = 0, endRow = 0, first = 0, end = 0;
  };
  /// For kernels: folds full bits and scratch blocks of all that was drawn since the last time, which are these triangles,
  /// and clears what lies beyond the target. Few triangles cost no pass over the whole mask.
  void settle(std::span<const SnappedTriangle> triangles);
  /// For kernels: `this |= other`, scratch included.
  void merge(const CoverageMask& other);

 private:
  CoverageMask(uint32_t width, uint32_t height, std::span<const SampleLocation> locations);
  void settle(const Windows& windows);

  struct alignas(64) Line {
    uint64_t words[kBlockHeight] = {};
  };

  uint32_t width_ = 0, height_ = 0, halfColumns_ = 0;
  std::span<const SampleLocation> locations_;
  std::vector<Line> storage_, tall_;  ///< storage_: two columns longer, where kernels may write zeros
  std::vector<uint64_t> full_;
};

/// Adds the coverage of all triangles to the mask, exactly, for any int32 vertices. The same mask for every instruction
/// set and thread count (1 = on the calling thread; 0 = one for each core).
void drawCoverage(std::span<const SnappedTriangle> triangles, CoverageMask& mask, unsigned threads = 1);

/// Instruction sets that `drawCoverage` was built for and this machine has, best first, as Highway names them.
[[nodiscard]] std::vector<std::string> coverageTargets();

}  // namespace rasterdiff::rasterizer
