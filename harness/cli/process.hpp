// One child process with a pipe each way and its stderr kept in memory. Linux.
#pragma once

#include <sys/types.h>

#include <functional>
#include <span>
#include <string>

namespace rasterdiff::harness::cli {

struct Child {
  pid_t pid = -1;
  int jobs = -1;      ///< we write
  int messages = -1;  ///< we read
  int errors = -1;    ///< memory file that holds the child's stderr
};

/// Forks; the child runs `body(jobs, messages)` and ends. `siblings` are closed in the child. pid < 0: fork failed.
[[nodiscard]] Child startChild(std::span<const Child> siblings, const std::function<void(int jobs, int messages)>& body);

/// Kills the child if it still runs, collects it, closes its pipes. Returns how it ended: "ended by signal 11
/// (Segmentation fault)", "ended with exit status 3"; empty after a good end.
[[nodiscard]] std::string endChild(Child& child);

/// The last line that the child wrote to stderr, at most 200 bytes. Valid until endChild.
[[nodiscard]] std::string lastWords(const Child& child);

}  // namespace rasterdiff::harness::cli
