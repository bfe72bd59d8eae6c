#include "harness/cli/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "harness/report/numbers.hpp"

namespace rasterdiff::harness::cli {
namespace {

void closeAll(const Child& child) {
  for (const int fd : {child.jobs, child.messages, child.errors}) {
    if (fd >= 0) close(fd);
  }
}

/// The child dies with its parent, dumps no core, reads and writes nothing of the terminal's.
void settleIn(int errors) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (null >= 0) {
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
  }
  if (errors >= 0) dup2(errors, STDERR_FILENO);
}

}  // namespace

Child startChild(std::span<const Child> siblings, const std::function<void(int jobs, int messages)>& body) {
  std::array<int, 2> jobs{-1, -1}, messages{-1, -1};
  if (pipe2(jobs.data(), O_CLOEXEC) != 0) return {};
  if (pipe2(messages.data(), O_CLOEXEC) != 0) {
    closeAll({-1, jobs[0], jobs[1], -1});
    return {};
  }
  Child child{-1, jobs[1], messages[0], memfd_create("stderr", MFD_CLOEXEC)};
  child.pid = fork();
  if (child.pid == 0) {
    for (const Child& sibling : siblings) closeAll(sibling);
    close(child.jobs);
    close(child.messages);
    settleIn(child.errors);
    body(jobs[0], messages[1]);
    _exit(0);
  }
  close(jobs[0]);
  close(messages[1]);
  if (child.pid < 0) closeAll(child);
  return child;
}

std::string endChild(Child& child) {
  kill(child.pid, SIGKILL);  // changes nothing for a child that has ended already
  int status = 0;
  while (waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
  }
  closeAll(child);
  child = {};
  if (WIFSIGNALED(status)) {
    return fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0) {
    return fmt::format("ended with exit status {}", WEXITSTATUS(status));
  }
  return {};
}

std::string lastWords(const Child& child) {
  constexpr off_t kTail = 2000;
  constexpr size_t kLongest = 200;
  const off_t size = lseek(child.errors, 0, SEEK_END);
  if (size <= 0) return {};
  std::string tail(static_cast<size_t>(std::min(size, kTail)), '\0');
  const ssize_t got = pread(child.errors, tail.data(), tail.size(), size - static_cast<off_t>(tail.size()));
  tail.resize(got > 0 ? static_cast<size_t>(got) : 0);
  while (!tail.empty() && (tail.back() == '\n' || tail.back() == ' ')) tail.pop_back();
  const size_t newline = tail.rfind('\n');
  if (newline != std::string::npos) tail.erase(0, newline + 1);
  if (tail.size() > kLongest) tail.resize(kLongest);
  return oneLine(tail);
}

}  // namespace rasterdiff::harness::cli
