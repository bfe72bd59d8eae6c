// Whole messages through pipes between processes: reads and writes that go on until all bytes are there.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

namespace rasterdiff::harness {

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/// False at the end of the pipe, on an error, and after `until`.
[[nodiscard]] bool readFully(int fd, char* into, size_t size, Deadline until = std::nullopt);

/// False on an error, as when nobody reads any longer (SIGPIPE has to be ignored).
[[nodiscard]] bool writeFully(int fd, const char* from, size_t size);

}  // namespace rasterdiff::harness
