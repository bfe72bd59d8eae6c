#include "harness/infer/finding.hpp"

#include <algorithm>

namespace rasterdiff::harness {

uint64_t Finding::decidingEvents() const {
  uint64_t least = 0;
  for (const Rival& rival : rivals) {
    if (rival.contradictions > 0 && (least == 0 || rival.contradictions < least)) least = rival.contradictions;
  }
  return least;
}

std::vector<uint32_t> Finding::alike() const {
  std::vector<uint32_t> answers;
  for (const Rival& rival : rivals) {
    if (rival.contradictions == 0) answers.push_back(rival.answer);
  }
  return answers;
}

const Finding& Inference::of(rasterizer::Choice choice) const {
  return *std::ranges::find(findings, choice, &Finding::choice);
}

}  // namespace rasterdiff::harness
