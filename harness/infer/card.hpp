// An inference for people (one line a property) and for programs.
#pragma once

#include <string>

#include "harness/infer/finding.hpp"

namespace rasterdiff::harness {

/// One line a property: the answer, how sure it is, from how many deciding events, what was excluded; and what is open.
[[nodiscard]] std::string inferenceCard(const Inference& inference);

/// The same as JSON (docs/profiles.md), indented.
[[nodiscard]] std::string inferenceJson(const Inference& inference);

/// How sure a finding is: "certain" from 100 deciding events on, "sure" from 10, "likely" below.
[[nodiscard]] std::string_view sureness(uint64_t decidingEvents);

}  // namespace rasterdiff::harness
