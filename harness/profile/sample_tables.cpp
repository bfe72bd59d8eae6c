#include "harness/profile/sample_tables.hpp"

#include "scene/sample_locations.hpp"

namespace rasterdiff::harness {

rasterizer::SampleTables standardTables() {
  rasterizer::SampleTables tables;
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    const std::span<const SampleLocation> table = standardSampleLocations(samples);
    for (uint32_t s = 0; s < samples; ++s) {
      tables.of(samples)[s] = {static_cast<uint8_t>(table[s].x * 16), static_cast<uint8_t>(table[s].y * 16)};  // Q0.4 → Q0.8
    }
  }
  return tables;
}

}  // namespace rasterdiff::harness
