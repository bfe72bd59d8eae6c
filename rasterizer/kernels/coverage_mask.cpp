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
  storage_.assign(size() + kBlockHeight, 0);
  full_.assign((halfColumns_ / 2 + 63) / 64 * fullStride(), 0);
  const auto misplaced = reinterpret_cast<uintptr_t>(storage_.data()) / sizeof(uint64_t) % kBlockHeight;
  words_ = storage_.data() + (kBlockHeight - misplaced) % kBlockHeight;
}

CoverageMask::CoverageMask(const CoverageMask& other) : CoverageMask(other.width_, other.height_, other.locations_) {
  std::copy_n(other.words_, size(), words_);
  full_ = other.full_;
}

CoverageMask& CoverageMask::operator=(const CoverageMask& other) {
  if (this != &other) *this = CoverageMask(other);
  return *this;
}

void CoverageMask::clear() {
  std::fill_n(words_, size(), 0);
  std::ranges::fill(full_, 0);
}

void CoverageMask::merge(const CoverageMask& other) {
  for (size_t i = 0; i < size(); ++i) words_[i] |= other.words_[i];
  for (size_t i = 0; i < full_.size(); ++i) full_[i] |= other.full_[i];
}

uint64_t CoverageMask::count() const {
  uint64_t sum = 0;
  for (size_t i = 0; i < size(); ++i) sum += static_cast<uint64_t>(std::popcount(words_[i]));
  return sum;
}

uint64_t CoverageMask::differing(const CoverageMask& other) const {
  uint64_t sum = 0;
  for (size_t i = 0; i < size(); ++i) sum += static_cast<uint64_t>(std::popcount(words_[i] ^ other.words_[i]));
  return sum;
}

}  // namespace rasterdiff::rasterizer
