// Reads /proc; the peak is the kernel's own high-water mark, set back before the work.
#include "harness/bench/machine.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sched.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "rasterizer/kernels/coverage_mask.hpp"

namespace rasterdiff::harness::bench {
namespace {

/// The value behind the first line of `file` that starts with `key` and a colon.
std::string valueIn(const char* file, std::string_view key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(':');
    if (colon == std::string::npos || !line.starts_with(key)) continue;
    const size_t first = line.find_first_not_of(" \t", colon + 1);
    return first == std::string::npos ? "" : line.substr(first);
  }
  return {};
}

/// A line "VmHWM:  1234 kB" of this process, in bytes.
std::optional<uint64_t> statusBytes(std::string_view key) {
  const std::string value = valueIn("/proc/self/status", key);
  if (value.empty()) return std::nullopt;
  return std::strtoull(value.c_str(), nullptr, 10) << 10;
}

}  // namespace

Machine thisMachine() {
  Machine machine;
  machine.cpu = valueIn("/proc/cpuinfo", "model name");
  utsname system{};
  if (uname(&system) == 0) machine.system = fmt::format("{} {}", system.sysname, system.machine);
  if (machine.cpu.empty()) machine.cpu = system.machine;
#if defined(__clang__)
  machine.compiler = fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  machine.compiler = fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char date[32] = {};
  if (gmtime_r(&now, &utc) != nullptr) std::strftime(date, sizeof date, "%Y-%m-%d %H:%M", &utc);
  machine.date = date;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) machine.cores = static_cast<unsigned>(std::max(1, CPU_COUNT(&cores)));
  machine.targets = rasterizer::coverageTargets();
  if (double load = 0; getloadavg(&load, 1) == 1) machine.loadAverage = load;
  return machine;
}

std::string machineLine(const Machine& machine) {
  return fmt::format("{}, {} core{}, {}, {}, {}, {} UTC, load average {:.1f}", machine.cpu, machine.cores,
                     machine.cores == 1 ? "" : "s", machine.targets.empty() ? "scalar" : machine.targets.front(),
                     machine.compiler, machine.system, machine.date, machine.loadAverage);
}

PeakMeter::PeakMeter() {
  malloc_trim(0);
  std::ofstream peak("/proc/self/clear_refs");
  peak << "5";  // sets the high-water mark back to what is resident now
  peak.close();
  if (peak) before_ = statusBytes("VmRSS");
}

std::optional<uint64_t> PeakMeter::growth() const {
  const std::optional<uint64_t> peak = statusBytes("VmHWM");
  if (!before_ || !peak) return std::nullopt;
  return *peak > *before_ ? *peak - *before_ : 0;
}

}  // namespace rasterdiff::harness::bench
