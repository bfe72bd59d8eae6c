// Passes over rows of the two frames as soon as the reference has drawn them: its planes are still in a cache then, while reading the
// whole frame once more costs as much as the memory takes.
#pragma once

#include <map>
#include <mutex>

#include "harness/compare/sample_pass.hpp"
#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

class RowPasses {
 public:
  /// `actual` must outlive this object.
  RowPasses(const Scene& scene, const rasterizer::Rules& rules, const Frame& actual);

  /// Judges rows [first, end), which nobody has judged yet; several threads may, each others. Rows of frames that are not alike, or so
  /// large that their questions are asked piece by piece, are left out.
  void judge(const Frame& reference, uint32_t first, uint32_t end);

  /// Adds what has been found, in the order of rows. False, and nothing is added, unless it is about all rows of the frame.
  [[nodiscard]] bool addTo(SamplePass& pass) const;
  /// Time in judge(), of all threads together.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const Frame& actual_;
  const bool mayOverlapItself_;
  std::mutex mutex_;                         // of all below
  std::map<uint32_t, SamplePass> endingAt_;  // row; each goes on where the rows above it end
  uint64_t rows_ = 0;
  double seconds_ = 0;
};

}  // namespace rasterdiff::harness
