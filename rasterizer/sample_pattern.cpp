#include "rasterizer/sample_pattern.hpp"

#include "scene/sample_locations.hpp"

namespace rasterdiff::rasterizer {

Result<std::vector<SubpixelPosition>> samplePattern(uint32_t samples, const Rules& rules) {
  const std::span<const SampleLocation> table = standardSampleLocations(samples);
  if (table.empty()) {
    return fail(ErrorCode::NotOffered, "target.samples",
                "there are no standard sample locations for " + std::to_string(samples) + " samples",
                "use 1, 2, 4, 8 or 16");
  }
  constexpr int32_t kSixteenth = kSubpixelOne / 16;  // Q0.4 → Q0.8
  std::vector<SubpixelPosition> pattern;
  for (const SampleLocation& location : table) pattern.push_back({location.x * kSixteenth, location.y * kSixteenth});
  if (rules.error == DeliberateError::SampleMoved) pattern[0].x += kSixteenth;
  return pattern;
}

}  // namespace rasterdiff::rasterizer
