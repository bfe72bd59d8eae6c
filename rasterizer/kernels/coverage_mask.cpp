// The mask's storage; its folding is in mask_settle.cpp, drawing in span_kernel.cpp.
#include "rasterizer/kernels/coverage_mask.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace rasterdiff::rasterizer {

Result<CoverageMask> CoverageMask::create(uint32_t width, uint32_t height, uint32_t samples) {
  constexpr uint32_t kLargest = 32768;
  if (width == 0 || height == 0 || width > kLargest || height > kLargest)
    return fail(ErrorCode::BadInput, "coverage mask", "width and height must be 1 to 32768 pixels");
  const auto locations = standardSampleLocations(samples);
  if (locations.empty())
    return fail(ErrorCode::NotOffered, "coverage mask", "no standard sample locations for this sample count",
                "use 1, 2, 4, 8 or 16 samples");
  return CoverageMask(width, height, locations);
}

CoverageMask::CoverageMask(uint32_t width, uint32_t height, std::span<const SampleLocation> locations)
    : width_(width), height_(height), halfColumns_((width + kBlockWidth - 1) / kBlockWidth * 2), locations_(locations) {
  storage_.resize((size_t{blockRows()} * halfColumns_ + 2) * locations_.size());
  full_.assign((halfColumns_ / 2 + 63) / 64 * fullStride(), 0);
}

uint64_t* CoverageMask::tall() {
  if (tall_.empty()) tall_.resize((size_t{blockRows()} + 1) / 2 * tallStride() * locations_.size());
  return reinterpret_cast<uint64_t*>(tall_.data());
}

void CoverageMask::clear() {
  std::ranges::fill(storage_, Line{});
  std::ranges::fill(full_, 0);
  std::ranges::fill(tall_, Line{});
}

void CoverageMask::merge(const CoverageMask& other) {
  const auto add = [](std::vector<Line>& to, const std::vector<Line>& from) {
    for (size_t i = 0; i < from.size(); ++i)
      for (size_t k = 0; k < kBlockHeight; ++k) to[i].words[k] |= from[i].words[k];
  };
  add(storage_, other.storage_);
  for (size_t i = 0; i < full_.size(); ++i) full_[i] |= other.full_[i];
  if (other.tall_.empty()) return;
  (void)tall();
  add(tall_, other.tall_);
}

uint64_t CoverageMask::count() const {
  uint64_t sum = 0;
  for (const Line& line : storage_)
    for (const uint64_t word : line.words) sum += static_cast<uint64_t>(std::popcount(word));
  return sum;
}

uint64_t CoverageMask::differing(const CoverageMask& other) const {
  uint64_t sum = 0;
  for (size_t i = 0; i < storage_.size(); ++i)
    for (size_t k = 0; k < kBlockHeight; ++k)
      sum += static_cast<uint64_t>(std::popcount(storage_[i].words[k] ^ other.storage_[i].words[k]));
  return sum;
}

}  // namespace rasterdiff::rasterizer
