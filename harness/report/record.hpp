// What a worker process tells its parent, as text over a pipe: the driver it opened, one record a scene, an error.
// Reading never trusts the text: a driver that tramples on memory may have written it.
#pragma once

#include <string>
#include <string_view>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string recordOf(const SceneEntry& entry);
[[nodiscard]] std::string recordOf(const RunSubject& subject);
[[nodiscard]] std::string recordOf(const Error& error);

/// Error of each: BadInput, the record cannot be read.
[[nodiscard]] Result<SceneEntry> readSceneRecord(std::string_view text);
[[nodiscard]] Result<RunSubject> readSubjectRecord(std::string_view text);
[[nodiscard]] Result<Error> readErrorRecord(std::string_view text);

}  // namespace rasterdiff::harness
