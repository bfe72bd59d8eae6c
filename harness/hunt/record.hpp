// What a worker tells of a hunt, as text over a pipe. Reading never trusts the text.
#pragma once

#include <string>
#include <string_view>

#include "harness/hunt/lane.hpp"
#include "harness/hunt/shrink.hpp"

namespace rasterdiff::harness::hunt {

[[nodiscard]] std::string recordOf(const LaneResult& lane);
[[nodiscard]] std::string recordOf(const Shrunk& shrunk);
[[nodiscard]] std::string recordOf(const Judgement& judgement);

/// Error of each: BadInput, the record cannot be read.
[[nodiscard]] Result<LaneResult> readLaneRecord(std::string_view text);
[[nodiscard]] Result<Shrunk> readShrunkRecord(std::string_view text);
[[nodiscard]] Result<Judgement> readJudgementRecord(std::string_view text);

}  // namespace rasterdiff::harness::hunt
