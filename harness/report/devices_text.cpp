// `devices` for people: each driver with the limits that matter, and a block for bug reports.
#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <iterator>

#include "harness/report/listing.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;

std::string sampleCounts(uint32_t bits) {
  std::string counts;
  for (uint32_t count = 1; count <= 64; count *= 2) {
    if ((bits & count) != 0) counts += fmt::format("{}{}", counts.empty() ? "" : " ", count);
  }
  return counts;
}

std::string_view yesNo(bool value) { return value ? "yes" : "no"; }

std::vector<std::pair<std::string, std::string>> limitRows(const Limits& limits) {
  return {{"subPixelPrecisionBits", std::to_string(limits.subPixelPrecisionBits)},
          {"viewportSubPixelBits", std::to_string(limits.viewportSubPixelBits)},
          {"samples", sampleCounts(limits.framebufferSampleCounts)},
          {"standardSampleLocations", std::string(yesNo(limits.standardSampleLocations))},
          {"sampleLocationSampleCounts", limits.sampleLocationSampleCounts == 0 ? "none" : sampleCounts(limits.sampleLocationSampleCounts)},
          {"maxFramebuffer", fmt::format("{} x {}", limits.maxFramebufferWidth, limits.maxFramebufferHeight)},
          {"provokingVertexLast", std::string(yesNo(limits.provokingVertexLast))},
          {"depthClipControl", std::string(yesNo(limits.depthClipControl))}};
}

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string systemName() {
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("PRETTY_NAME=\"")) return line.substr(13, line.size() - 14);
  }
  return "unknown";
}

void writeCandidate(Out out, const vkref::DriverCandidate& candidate) {
  if (!candidate.usable) {
    fmt::format_to(out, "{:<13} refused: {}\n", candidate.name, candidate.refusal);
    if (!candidate.manifest.empty()) fmt::format_to(out, "    {:<34} {}\n", "manifest", candidate.manifest);
    fmt::format_to(out, "\n");
    return;
  }
  const vkref::DriverInfo& driver = candidate.driver;
  fmt::format_to(out, "{:<13} {}: {}\n", candidate.name, driver.name, driver.info);
  std::vector<std::pair<std::string, std::string>> rows{
      {"device", driver.deviceName}, {"Vulkan", driver.apiVersion}, {"manifest", candidate.manifest}};
  for (auto& row : limitRows(candidate.limits)) rows.push_back(std::move(row));
  rows.insert(rows.end(), candidate.facts.begin(), candidate.facts.end());
  for (const auto& [name, value] : rows) fmt::format_to(out, "    {:<34} {}\n", name, value);
  fmt::format_to(out, "\n");
}

}  // namespace

std::string devicesText(std::span<const vkref::DriverCandidate> candidates) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const vkref::DriverCandidate& candidate : candidates) writeCandidate(out, candidate);
  utsname kernel{};
  uname(&kernel);
  fmt::format_to(out, "paste this into a bug report:\n\n    rasterdiff {}\n    {}, {} {}\n    {}\n", RASTERDIFF_VERSION,
                 systemName(), kernel.sysname, kernel.release, cpuName());
  for (const vkref::DriverCandidate& candidate : candidates) {
    fmt::format_to(out, "    {}: {}\n", candidate.name,
                   candidate.usable ? fmt::format("{} {}, {}, Vulkan {}", candidate.driver.name, candidate.driver.info,
                                                  candidate.driver.deviceName, candidate.driver.apiVersion)
                                    : candidate.refusal);
  }
  return text;
}

}  // namespace rasterdiff::harness
