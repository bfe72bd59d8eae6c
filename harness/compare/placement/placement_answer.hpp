// What came of the joint question (placement.hpp): plain data for verdicts and reports.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterdiff::harness {

/// Grids from subPixelPrecisionBits to this many bits are tried; positions here are in 1/4096 pixel.  // Q.12
inline constexpr int kFinestGridBits = 12;

struct VertexPlacement {
  uint32_t draw = 0, vertex = 0;  ///< index into the draw's positions; the first of equal ones
  double nominalX = 0, nominalY = 0, x = 0, y = 0;  ///< pixels
};

struct PlacementAnswer {
  enum class State : uint8_t {
    Explained,   ///< `moved` names the placement; all other vertices are at their nominal place
    Impossible,  ///< no grid has one; `conflict` are primitives that no placement explains together
    Undecided,   ///< the search was given up; `why`
  };
  State state = State::Explained;
  int gridBits = 0;            ///< the coarsest grid with a placement (Explained)
  uint64_t primitives = 0;     ///< joined by shared vertices to a sample that differs from the nominal answer
  uint64_t vertices = 0;       ///< of those primitives
  uint64_t requirements = 0;   ///< (primitive, sample) pairs whose coverage the frame tells and a placement decides
  uint64_t leftOut = 0;        ///< primitives that clipping cut, and samples that do not tell whose turn it was
  uint64_t movedVertices = 0;
  std::vector<VertexPlacement> moved;  ///< the first kListedVertices
  std::vector<uint32_t> conflict;      ///< 1-based primitives
  std::string why;
};

inline constexpr size_t kListedVertices = 16;

[[nodiscard]] std::string_view toString(PlacementAnswer::State state);
/// One line for people: "one placement on the 1/256 grid explains all 12 samples: 3 of 40 vertices moved".
[[nodiscard]] std::string describe(const PlacementAnswer& answer);

}  // namespace rasterdiff::harness
