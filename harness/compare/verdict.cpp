#include "harness/compare/verdict.hpp"

namespace rasterdiff::harness {

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::Same: return "Same";
    case Verdict::Allowed: return "Allowed";
    case Verdict::Differs: return "Differs";
    case Verdict::Skipped: return "Skipped";
    case Verdict::Crashed: return "Crashed";
    case Verdict::TimedOut: return "TimedOut";
  }
  return "Differs";
}

std::string_view toString(BaselineStatus status) {
  switch (status) {
    case BaselineStatus::None: return "None";
    case BaselineStatus::ExpectedDiff: return "ExpectedDiff";
    case BaselineStatus::Improved: return "Improved";
  }
  return "None";
}

std::vector<std::string> differingPlanes(const SceneResult& result) {
  std::vector<std::string> planes;
  if (result.differing > 0) planes.emplace_back("coverage");
  for (const ValueStats& stats : result.values) {
    if (stats.differing > 0) planes.push_back(stats.name);
  }
  return planes;
}

bool isUnexpected(const SceneResult& result) {
  if (result.baseline == BaselineStatus::Improved) return true;
  const bool bad = result.verdict == Verdict::Differs || result.verdict == Verdict::Crashed || result.verdict == Verdict::TimedOut;
  return bad && result.baseline != BaselineStatus::ExpectedDiff;
}

}  // namespace rasterdiff::harness
