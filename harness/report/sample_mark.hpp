// How the two sides stand to each other at one sample: what difference pictures and close-ups colour.
#pragma once

#include <cstdint>

#include "harness/compare/verdict.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::harness {

/// From harmless to wrong; the order is the rank when several samples share a pixel. A value lies close to the reference's
/// (an error below a tenth of the way to its bound), halfway, or further.
enum class SampleMark : uint8_t { Empty, Same, ValueClose, ValueHalfway, ValueFar, Allowed, Differs };

/// Where a scene holds both Allowed and Differs, samples are told apart by the reference's own knowledge (Either, bounds).
class SampleMarker {
 public:
  SampleMarker(const Frame& reference, const Frame& actual, const SceneResult& result)
      : reference_(reference), actual_(actual), onlyAllowed_(result.differing == 0), onlyDiffers_(result.allowed == 0) {}

  /// `sample`: index into planes of one component.
  [[nodiscard]] SampleMark markOf(size_t sample) const;
  /// Of the values that samples were resolved to; resolved planes have one sample a pixel.
  [[nodiscard]] SampleMark markOfResolved(size_t pixel) const;

 private:
  const Frame& reference_;
  const Frame& actual_;
  bool onlyAllowed_, onlyDiffers_;  ///< the scene's coverage counts leave one answer for every sample
};

}  // namespace rasterdiff::harness
