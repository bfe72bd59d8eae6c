// One pass over samples of two frames: what is the same is counted, values are judged by their intervals, and what takes
// knowledge of the scene's primitives is left as questions.
#pragma once

#include <string>
#include <vector>

#include "harness/compare/value_accumulator.hpp"
#include "rasterizer/render.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::harness {

/// One plane of values of both frames.
struct ValuePlanes {
  const Plane<float>*expected = nullptr, *actual = nullptr;
  const Plane<Bounds>* legal = nullptr;
};

/// Depth, if there is any, then each varying and built-in.
[[nodiscard]] std::vector<ValuePlanes> valuePlanesOf(const Frame& reference, const Frame& actual);

/// Have both frames the same planes?
[[nodiscard]] bool alike(const Frame& a, const Frame& b);

/// Lines and points that outline one triangle may cover a sample together, and which of them do is a freedom.
[[nodiscard]] bool mayOverlapItself(const Scene& scene, const rasterizer::Rules& rules);

/// More samples are judged one part after the other, which bounds the memory of questions.
inline constexpr size_t kSamplesAtOnce = size_t{1} << 22;

class SamplePass {
 public:
  /// `mayOverlapItself`: parts of one primitive may cover a sample together, so that a value outside of its interval is a question, too.
  SamplePass(const Frame& reference, const Frame& actual, bool mayOverlapItself);

  /// Judges the samples [first, end).
  void run(size_t first, size_t end);
  /// Adds what a pass over later samples found.
  void append(const SamplePass& later);
  /// Judges the values of a sample; `also`: what else is legal there.
  void compareValues(const rasterizer::SampleQuery& place, size_t index, bool drawn, const rasterizer::Candidate* also = nullptr);

  uint64_t same = 0, coveredSamples = 0;
  std::vector<ValueAccumulator> values;             ///< one a plane of valuePlanesOf(), then resolved ones, which are left to others
  std::vector<rasterizer::SampleQuery> questions;  ///< winner or count is another
  std::vector<rasterizer::SampleQuery> overlaps;   ///< values are others, and another part of the winner may be there

 private:
  [[nodiscard]] bool runStretch(size_t first);
  void runOneByOne(size_t first, size_t end);
  void addValues(size_t plane, size_t first, size_t drawn);
  [[nodiscard]] bool valuesFit(size_t index) const;
  [[nodiscard]] rasterizer::SampleQuery placeOf(size_t index) const;

  const Frame& reference_;
  const Frame& actual_;
  std::vector<ValuePlanes> planes_;
  bool mayOverlapItself_;
  std::vector<uint32_t> drawnValues_;  ///< of a stretch, a word a value
};

/// The smallest interval that holds both.
[[nodiscard]] Bounds hull(Bounds a, Bounds b);

}  // namespace rasterdiff::harness
