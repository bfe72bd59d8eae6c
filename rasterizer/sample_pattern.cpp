#include "rasterizer/sample_pattern.hpp"

#include <utility>

#include "scene/sample_locations.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr int32_t kSixteenth = kSubpixelOne / 16;  // Q0.4 → Q0.8

void mistakePattern(std::vector<SubpixelPosition>& pattern, DeliberateError error) {
  const bool mirrors = (error == DeliberateError::TwoSamplesMirrored && pattern.size() == 2) ||
                       (error == DeliberateError::FourSamplesMirrored && pattern.size() == 4);
  for (SubpixelPosition& at : pattern) at.x = mirrors ? kSubpixelOne - at.x : at.x;
  if (error == DeliberateError::EightSamplesExchanged && pattern.size() == 8) std::swap(pattern[6], pattern[7]);
  if (error == DeliberateError::SixteenSamplesInside && pattern.size() == 16) pattern[12].x += kSixteenth;
  if (error == DeliberateError::SampleMoved) pattern[0].x += kSixteenth;
}

}  // namespace

Result<std::vector<SubpixelPosition>> samplePattern(uint32_t samples, const Rules& rules) {
  const std::span<const SampleLocation> table = standardSampleLocations(samples);
  if (table.empty()) {
    return fail(ErrorCode::NotOffered, "target.samples",
                "there are no standard sample locations for " + std::to_string(samples) + " samples",
                "use 1, 2, 4, 8 or 16");
  }
  std::vector<SubpixelPosition> pattern;
  if (rules.choices.sampleLocations) {
    for (const SampleTables::Offset& offset : rules.choices.sampleLocations->of(samples)) pattern.push_back({offset.x, offset.y});
  } else {
    for (const SampleLocation& location : table) pattern.push_back({location.x * kSixteenth, location.y * kSixteenth});
  }
  if (rules.error != DeliberateError::None) mistakePattern(pattern, rules.error);
  return pattern;
}

}  // namespace rasterdiff::rasterizer
