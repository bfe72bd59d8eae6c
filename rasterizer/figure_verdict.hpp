// Legal coverage of one sample by a figure: what its shape leaves open, and whether the figure has to be drawn at all.
#pragma once

#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

/// `px`, `py`: the sample, 1/256 pixel. Open rules only.
[[nodiscard]] inline BandVerdict legalVerdict(const Figure& figure, int64_t px, int64_t py) {
  const BandVerdict verdict = figure.shape->classify(px, py);
  if (figure.existence == Freedom::None || verdict.coverage != Coverage::In) return verdict;
  return {Coverage::Either, figure.existence, std::nullopt};
}

}  // namespace rasterdiff::rasterizer
