// The machine-readable result of `check`: stable, described by results.schema.json and docs/json.md.
#pragma once

#include <string>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string jsonReport(const Report& report);

}  // namespace rasterdiff::harness
