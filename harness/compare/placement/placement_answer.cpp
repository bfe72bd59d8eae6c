#include "harness/compare/placement/placement_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace rasterdiff::harness {

using State = PlacementAnswer::State;

std::string_view toString(State state) {
  switch (state) {
    case State::Explained: return "explained";
    case State::Impossible: return "impossible";
    case State::Undecided: return "undecided";
  }
  return "undecided";
}

std::string describe(const PlacementAnswer& answer) {
  switch (answer.state) {
    case State::Explained:
      return fmt::format("one placement on the 1/{} grid explains all samples together: {} of {} vertices moved",
                         1U << static_cast<unsigned>(answer.gridBits), answer.movedVertices, answer.vertices);
    case State::Impossible: {
      const std::span first(answer.conflict.data(), std::min<size_t>(answer.conflict.size(), 8));
      return fmt::format("no placement of the vertices explains primitive{} {}{} together", answer.conflict.size() == 1 ? "" : "s",
                         fmt::join(first, ", "), first.size() < answer.conflict.size() ? ", …" : "");
    }
    case State::Undecided: return "not decided whether one placement explains all samples: " + answer.why;
  }
  return {};
}

}  // namespace rasterdiff::harness
