// One scene on both sides, reduced to what a search needs: the verdict, which kinds of samples differ and where, and
// which rules decided.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/compare/verdict.hpp"
#include "harness/subject.hpp"
#include "rasterizer/rule_counts.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::harness::hunt {

/// A kind of wrong answer and the first sample that gives it.
struct Difference {
  std::string kind;  ///< "coverage/missing", "depth", "smooth", "FrontFacing", "resolved/flat", "crash", "hang"
  uint32_t x = 0, y = 0, sample = 0;
};

struct Judgement {
  Verdict verdict = Verdict::Same;
  std::string reason;
  std::vector<Difference> differences;  ///< of Differs: one a kind; of Crashed and TimedOut: one
  uint64_t samples = 0, values = 0;
  rasterizer::RuleCounts counts;
};

/// The difference of `kind`, or null.
[[nodiscard]] const Difference* find(const Judgement& judgement, std::string_view kind);

/// The part of a kind before '/': "coverage", "depth", "smooth", "resolved".
[[nodiscard]] std::string_view planeKind(std::string_view kind);

/// How a plane's name in a scene is called as a kind: the interpolation of a varying, else the name itself.
[[nodiscard]] std::string kindOfPlane(const Scene& scene, std::string_view plane);

/// Judges a scene; one that cannot be drawn is Skipped.
using Judge = std::function<Judgement(const Scene&)>;

/// Draws and compares in this process. Error codes DeviceLost and TimedOut become Crashed and TimedOut.
[[nodiscard]] Judgement judge(const Scene& scene, Subject& subject, const rasterizer::Rules& rules);

}  // namespace rasterdiff::harness::hunt
