// What all contenders share: which are wanted, how often each is run, and the clock.
#include "harness/bench/contender.hpp"

#include <fnmatch.h>
#include <hwy/targets.h>

#include <chrono>
#include <sstream>

#include "rasterizer/kernels/coverage_mask.hpp"

namespace rasterdiff::harness::bench {

bool chosen(const Settings& settings, const std::string& method) {
  std::istringstream globs(settings.kernels);
  for (std::string glob; std::getline(globs, glob, ',');)
    if (fnmatch(glob.c_str(), method.c_str(), 0) == 0) return true;
  return false;
}

std::vector<Run> runsOf(const Settings& settings, bool dispatched) {
  if (!dispatched) return {{}};
  std::vector<Run> runs;
  if (settings.threads > 1) runs.push_back({settings.threads, 0});
  if (!settings.targets) {
    runs.push_back({});
    return runs;
  }
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) runs.push_back({1, target});
  return runs;
}

std::string targetName(const Run& run) {
  return run.target != 0 ? hwy::TargetName(run.target) : rasterizer::coverageTargets().front();
}

TargetScope::TargetScope(const Run& run) : changed_(run.target != 0) {
  if (changed_) hwy::SetSupportedTargetsForTest(run.target);
}

TargetScope::~TargetScope() {
  if (changed_) hwy::SetSupportedTargetsForTest(0);
}

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace rasterdiff::harness::bench
