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

}  // namespace rasterdiff::harness
