// rasterdiff_bench_kernels: triangles per second of the coverage methods on the built-in workloads, through Google
// Benchmark. An exact method that is wrong is not timed: its row is an error.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "bench/workloads.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "scene/mesh/obj.hpp"

namespace {

using namespace rasterdiff;
using rasterizer::CoverageMask;

constexpr size_t kCheckedSamples = 20'000'000;  // of boxes: how much the oracle looks at before a timing

/// As many of the first triangles as the oracle can do in about a second.
std::span<const rasterizer::SnappedTriangle> checked(const bench::Workload& load, uint32_t samples) {
  size_t count = 0;
  for (double cost = 0; count < load.triangles.size() && cost < kCheckedSamples; ++count) {
    const auto& v = load.triangles[count].v;
    const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
    cost += ((x1 - x0) / 256.0 + 1) * ((y1 - y0) / 256.0 + 1) * samples;
  }
  return std::span(load.triangles).first(count);
}

void run(benchmark::State& state, const bench::Workload& load, const rasterizer::CoverageMethod& method, uint32_t samples) {
  auto mask = CoverageMask::create(load.width, load.height, samples);
  if (!mask) return state.SkipWithError(mask.error().what.c_str());
  const auto part = checked(load, samples);
  CoverageMask expected = *mask;
  rasterizer::drawCoverageOracle(part, expected);
  method.draw(part, *mask);
  const auto wrong = mask->differing(expected);
  if (method.exact && wrong != 0) return state.SkipWithError(fmt::format("{} wrong samples", wrong).c_str());
  for (auto _ : state) {
    state.PauseTiming();
    mask->clear();
    state.ResumeTiming();
    method.draw(load.triangles, *mask);
    benchmark::ClobberMemory();
  }
  state.counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(load.triangles.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["wrong"] = static_cast<double>(wrong);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto obj = findBunny();
  if (!obj) {
    fmt::print(stderr, "{}: {}\n{}\n", obj.error().where, obj.error().what, obj.error().hint);
    return 2;
  }
  const auto loads = bench::builtInWorkloads(*obj);
  if (!loads) {
    fmt::print(stderr, "{}: {}\n", loads.error().where, loads.error().what);
    return 2;
  }
  for (const uint32_t samples : {1u, 4u})
    for (const bench::Workload& load : *loads)
      for (const rasterizer::CoverageMethod& method : rasterizer::coverageMethods())
        benchmark::RegisterBenchmark(fmt::format("{}/{}x/{}", load.name, samples, method.name).c_str(),
                                     [&load, &method, samples](benchmark::State& s) { run(s, load, method, samples); })
            ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
