// The coverage kernels as contenders, by name.
#include <fmt/format.h>

#include <memory>

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
  Run run;

  void draw(Triangles triangles, CoverageMask& mask) const {
    const TargetScope scope(run);
    if (run.threads > 1) {
      rasterizer::drawCoverage(triangles, mask, run.threads);
    } else {
      method->draw(triangles, mask);
    }
  }
};

std::vector<Variant> variants(const Settings& settings) {
  std::vector<Variant> all;
  for (const CoverageMethod& method : rasterizer::coverageMethods()) {
    if (!chosen(settings, method.name)) continue;
    for (const Run& run : runsOf(settings, method.name == kDispatched)) all.push_back({&method, run});
  }
  return all;
}

Row rowOf(const Variant& variant) {
  Row row;
  row.method = variant.method->name;
  row.what = variant.method->what;
  row.exact = variant.method->exact;
  row.threads = variant.run.threads;
  if (row.method == kDispatched) row.target = targetName(variant.run);
  return row;
}

Contender contenderOf(const Variant& variant, const Load& load, const ErrorCount& error, const Settings& settings) {
  Contender contender;
  contender.mostSeconds = settings.kernelSeconds;
  contender.wholeSeconds = settings.kernelWhole;
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
