// The coverage kernels as contenders: all by name, the SIMD one with threads and on each instruction set if that is asked.
#include <fmt/format.h>
#include <fnmatch.h>
#include <hwy/targets.h>

#include <chrono>
#include <memory>
#include <sstream>

#include "harness/bench/contender.hpp"
#include "harness/bench/machine.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"

namespace rasterdiff::harness::bench {
namespace {

using rasterizer::CoverageMask;
using rasterizer::CoverageMethod;
using rasterizer::SnappedTriangle;
using Triangles = std::span<const SnappedTriangle>;

constexpr const char* kDispatched = "spans";  ///< the method that chooses an instruction set and can use threads

/// A method, and how it is to be run.
struct Variant {
  const CoverageMethod* method;
  unsigned threads = 1;
  int64_t target = 0;  ///< 0: the best

  void draw(Triangles triangles, CoverageMask& mask) const {
    if (target != 0) hwy::SetSupportedTargetsForTest(target);
    if (threads > 1) {
      rasterizer::drawCoverage(triangles, mask, threads);
    } else {
      method->draw(triangles, mask);
    }
    if (target != 0) hwy::SetSupportedTargetsForTest(0);
  }
};

std::vector<Variant> variants(const Settings& settings) {
  std::vector<Variant> all;
  for (const CoverageMethod& method : rasterizer::coverageMethods()) {
    if (!chosen(settings, method.name)) continue;
    if (method.name != kDispatched) {
      all.push_back({&method});
      continue;
    }
    if (settings.threads > 1) all.push_back({&method, settings.threads});
    if (!settings.targets) {
      all.push_back({&method});
      continue;
    }
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) all.push_back({&method, 1, target});
  }
  return all;
}

Row rowOf(const Variant& variant) {
  Row row;
  row.method = variant.method->name;
  row.what = variant.method->what;
  row.exact = variant.method->exact;
  row.threads = variant.threads;
  if (variant.target != 0) {
    row.target = hwy::TargetName(variant.target);
  } else if (row.method == kDispatched) {
    row.target = rasterizer::coverageTargets().front();
  }
  return row;
}

Contender contenderOf(const Variant& variant, const Load& load, const ErrorCount& error, const Settings& settings) {
  Contender contender;
  contender.mostSeconds = settings.kernelSeconds;
  Row row = rowOf(variant);
  row.error = error;
  if (row.exact && error.wrong > 0) row.refused = fmt::format("{} wrong samples in an exact method", error.wrong);
  contender.rows.push_back(std::move(row));
  const auto target = std::make_shared<std::optional<CoverageMask>>();
  contender.draw = [variant, &load, target](size_t triangles) -> Result<std::vector<double>> {
    if (!*target) {
      Result<CoverageMask> made = CoverageMask::create(load.width, load.height, load.samples);
      if (!made) return tl::unexpected(made.error());
      *target = std::move(*made);
    }
    (*target)->clear();
    return std::vector<double>{secondsOf([&] { variant.draw(Triangles(load.triangles).first(triangles), **target); })};
  };
  contender.peak = [variant, &load](size_t triangles) {
    const PeakMeter meter;
    if (auto mask = CoverageMask::create(load.width, load.height, load.samples))
      variant.draw(Triangles(load.triangles).first(triangles), *mask);
    return meter.growth();
  };
  return contender;
}

}  // namespace

bool chosen(const Settings& settings, const std::string& method) {
  std::istringstream globs(settings.kernels);
  for (std::string glob; std::getline(globs, glob, ',');)
    if (fnmatch(glob.c_str(), method.c_str(), 0) == 0) return true;
  return false;
}

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<std::vector<Contender>> maskContenders(const Load& load, const Truth& truth, const Settings& settings) {
  const std::vector<Variant> all = variants(settings);
  std::vector<DrawMask> draws;
  for (const Variant& variant : all)
    draws.push_back([&variant](Triangles triangles, CoverageMask& mask) { variant.draw(triangles, mask); });
  const Result<std::vector<ErrorCount>> errors = truth.masks(draws);
  if (!errors) return tl::unexpected(errors.error());
  std::vector<Contender> contenders;
  for (size_t i = 0; i < all.size(); ++i) contenders.push_back(contenderOf(all[i], load, (*errors)[i], settings));
  return contenders;
}

}  // namespace rasterdiff::harness::bench
