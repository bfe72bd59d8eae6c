// The coverage around one sample as text, reference and driver side by side.
#pragma once

#include <cstdint>
#include <string>

#include "scene/frame.hpp"

namespace rasterdiff::harness {

struct Place {
  uint32_t x = 0, y = 0, sample = 0;
};

/// The same sample of the pixels around `place`: a letter per primitive (explained below the picture), '.' for none,
/// '?' where the reference leaves it open; [ ] around the asked pixel, '*' behind what differs. `actual` may be null.
[[nodiscard]] std::string textPicture(const Frame& reference, const Frame* actual, Place place);

}  // namespace rasterdiff::harness
