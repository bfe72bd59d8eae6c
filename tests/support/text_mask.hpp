// Expected masks as text, so that a failing test can be read: '#' covered, '.' not; rows from the top.
#pragma once

#include <string>

#include "scene/frame.hpp"

namespace rasterdiff::testing {

inline std::string textMask(const Frame& frame, uint32_t sample = 0) {
  std::string text;
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) text += frame.primitive.at(x, y, sample) != 0 ? '#' : '.';
    text += '\n';
  }
  return text;
}

/// Digits instead of '#': the overdraw count.
inline std::string textCounts(const Frame& frame, uint32_t sample = 0) {
  std::string text;
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) {
      const uint32_t count = frame.count.at(x, y, sample);
      text += count == 0 ? '.' : static_cast<char>('0' + count);
    }
    text += '\n';
  }
  return text;
}

}  // namespace rasterdiff::testing
