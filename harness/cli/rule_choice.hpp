// `--rules` to Rules: auto, spec, a profile or the file of one, for the driver that was opened.
#pragma once

#include <string>

#include "harness/cli/options.hpp"
#include "harness/subject.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::harness::cli {

/// Error: BadInput, no such profile; what is wrong with its file. Found before any driver is opened.
[[nodiscard]] Result<void> checkRulesName(const std::string& rules);

/// Options for openSubject. Mutants and faults are made of the profile that they are judged by.
[[nodiscard]] SubjectOptions subjectOptions(const DriverChoice& choice);

/// auto = the driver's own profile where one is known, "reference" for mutants and faults, else the specification.
[[nodiscard]] Result<rasterizer::Rules> rulesFor(const DriverChoice& choice, const Subject& subject);

/// The same where there is no driver: auto = "reference".
[[nodiscard]] Result<rasterizer::Rules> rulesWithoutDriver(const std::string& rules);

}  // namespace rasterdiff::harness::cli
