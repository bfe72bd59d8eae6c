#include "scene/sample_locations.hpp"

namespace rasterdiff {
namespace {

constexpr std::array<SampleLocation, 1> k1{{{8, 8}}};
constexpr std::array<SampleLocation, 2> k2{{{12, 12}, {4, 4}}};
constexpr std::array<SampleLocation, 4> k4{{{6, 2}, {14, 6}, {2, 10}, {10, 14}}};
constexpr std::array<SampleLocation, 8> k8{{{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}}};
constexpr std::array<SampleLocation, 16> k16{{{9, 9}, {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
                                              {6, 14}, {8, 1}, {4, 2}, {2, 12}, {0, 8}, {15, 4}, {14, 15}, {1, 0}}};

}  // namespace

std::span<const SampleLocation> standardSampleLocations(uint32_t samples) {
  switch (samples) {
    case 1: return k1;
    case 2: return k2;
    case 4: return k4;
    case 8: return k8;
    case 16: return k16;
    default: return {};
  }
}

}  // namespace rasterdiff
