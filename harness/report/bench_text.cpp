#include "harness/report/bench_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "harness/bench/machine.hpp"
#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {
namespace {

using namespace bench;
using Out = std::back_insert_iterator<std::string>;

std::string deviationText(const Timing& timing) { return fmt::format("±{:.1f} %", 100 * timing.deviation); }

std::string wrongText(const ErrorCount& error) {
  if (error.wrong == 0) return "none wrong";
  const double part = error.covered == 0 ? 1 : static_cast<double>(error.wrong) / static_cast<double>(error.covered);
  return part < 1e-3 ? fmt::format("{:.3g} wrong in a million", 1e6 * part) : fmt::format("{:.3g} % wrong", 100 * part);
}

void writeRow(Out out, const Row& row, const LoadResult& load) {
  fmt::format_to(out, "  {:<20} ", row.threads > 1 ? fmt::format("{}, {} threads", row.method, row.threads) : row.method);
  if (!row.refused.empty()) {
    fmt::format_to(out, "not timed: {}\n", row.refused);
    return;
  }
  const std::string part = row.triangles < load.triangles ? grouped(row.triangles) : "all";
  fmt::format_to(out, "{:>9} {:>9} {:>9}  {:>9}  {:>8}  {:<12} {}\n", threeDigits(trianglesPerSecond(row)),
                 threeDigits(samplesPerSecond(row)), deviationText(*row.timing), part,
                 row.peakBytes ? threeDigits(static_cast<double>(*row.peakBytes)) + "B" : "-", row.target, errorText(row));
}

void writeLoad(Out out, const LoadResult& load) {
  fmt::format_to(out, "\n{}  {} {}; {} x {} pixels, {}\n", load.name, grouped(load.triangles), load.what, load.width,
                 load.height, counted(load.samples, "sample"));
  if (!load.note.empty()) fmt::format_to(out, "  note: {}\n", load.note);
  const Row* previous = nullptr;
  for (const Row& row : load.rows) {
    if (previous == nullptr || previous->task != row.task)
      fmt::format_to(out, "  {:<20} {:>9} {:>9} {:>9} {:>10}  {:>8}  {:<12} {}\n", toString(row.task), "tri/s", "samples/s",
                     "", "timed", "memory", "target", "error");
    writeRow(out, row, load);
    previous = &row;
  }
}

void writeSampling(Out out, const std::vector<SamplingRow>& rows) {
  fmt::format_to(out, "\n{:<22} {:>9} {:>9} {:>9}  {:>10} {:>10}  {}\n", "sampling a pixel", "ns/pixel", "", "pixels",
                 "max error", "RMS error", "wrong in 8 bits");
  for (const SamplingRow& row : rows)
    fmt::format_to(out, "  {:<20} {:>9.3g} {:>9} {:>9}  {:>10.3g} {:>10.3g}  {:.3g} %\n", row.method, 1e9 * row.timing.median,
                   deviationText(row.timing), grouped(row.pixels), row.maxError, row.rmsError,
                   row.pixels == 0 ? 0 : 100 * static_cast<double>(row.wrong) / static_cast<double>(row.pixels));
}

void writeScaling(Out out, const ScalingSeries& series) {
  fmt::format_to(out, "\nscaling with {} ({})\n  {:>12}  {:<20} {:>12} {:>12} {:>9}\n", series.name, series.expected,
                 series.variable, "method", "ns/triangle", "ns/sample", "");
  for (const ScalingSeries::Point& point : series.points) {
    const Row& row = point.row;
    if (!row.timing) {
      fmt::format_to(out, "  {:>12}  {:<20} not timed: {}\n", grouped(static_cast<uint64_t>(point.x)), row.method, row.refused);
      continue;
    }
    fmt::format_to(out, "  {:>12}  {:<20} {:>12.4g} {:>12.4g} {:>9}\n", grouped(static_cast<uint64_t>(std::llround(point.x))),
                   row.method, 1e9 / trianglesPerSecond(row), 1e9 / samplesPerSecond(row), deviationText(*row.timing));
  }
}

}  // namespace

std::string threeDigits(double number) {
  const char* unit = "";
  for (const char* larger : {"k", "M", "G", "T"}) {
    if (number < 999.5) break;
    number /= 1000;
    unit = larger;
  }
  return fmt::format("{:.{}f}{}", number, number >= 100 || (*unit == '\0' && number == std::floor(number)) ? 0 : number >= 10 ? 1 : 2, unit);
}

std::string errorText(const Row& row) {
  if (!row.error) return "not looked at";
  const ErrorCount& error = *row.error;
  if (error.values == 0) return error.wrong == 0 && row.exact ? "exact" : wrongText(error);
  return fmt::format("{}; at most {} ULP, mean {:.3g}", wrongText(error), ulps(error.maxUlp), error.meanUlp);
}

std::string benchText(const Results& results) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "machine   {}\n", machineLine(results.machine));
  if (!results.driver.empty()) fmt::format_to(out, "driver    {}\n", results.driver);
  fmt::format_to(out, "rounds    {}, interleaved; figures are medians ± median absolute deviation\n", results.rounds);
  for (const LoadResult& load : results.loads) writeLoad(out, load);
  if (!results.sampling.empty()) writeSampling(out, results.sampling);
  for (const ScalingSeries& series : results.scaling) writeScaling(out, series);
  return text;
}

}  // namespace rasterdiff::harness
