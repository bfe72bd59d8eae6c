// The result as JUnit XML: a suite a family, a case a scene, for CI systems that know nothing else.
#pragma once

#include <string>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string junitReport(const Report& report);

}  // namespace rasterdiff::harness
