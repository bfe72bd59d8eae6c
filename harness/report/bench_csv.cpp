#include <fmt/format.h>

#include <iterator>

#include "harness/bench/machine.hpp"
#include "harness/report/bench_data.hpp"

namespace rasterdiff::harness {
namespace {

using namespace bench;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

std::string benchCsv(const Results& results) {
  std::string text =
      "workload,width,height,samples,task,method,exact,target,threads,triangles,covered_samples,triangles_per_second,"
      "samples_per_second,median_seconds,fastest_seconds,deviation,rounds,verified_triangles,verified_samples,wrong_samples,"
      "values,max_ulp,mean_ulp,peak_bytes,refused,machine,driver\r\n";
  const auto out = std::back_inserter(text);
  const std::string machine = quoted(machineLine(results.machine));
  for (const LoadResult& load : results.loads) {
    for (const Row& row : load.rows) {
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{:.0f},", quoted(load.name), load.width, load.height, load.samples, toString(row.task),
                     quoted(row.method), row.exact, row.target, row.threads, row.triangles, row.samples);
      if (row.timing) {
        fmt::format_to(out, "{:.6g},{:.6g},{:.6g},{:.6g},{:.4g},{},", trianglesPerSecond(row), samplesPerSecond(row), row.timing->median,
                       row.timing->fastest, row.timing->deviation, row.timing->rounds);
      } else {
        text += ",,,,,,";
      }
      if (row.error) {
        fmt::format_to(out, "{},{},{},{},", row.error->triangles, row.error->covered, row.error->wrong, row.error->values);
        fmt::format_to(out, "{},", row.error->values > 0 ? fmt::format("{},{:.6g}", row.error->maxUlp, row.error->meanUlp) : ",");
      } else {
        text += ",,,,,,";
      }
      fmt::format_to(out, "{},{},{},{}\r\n", row.peakBytes ? std::to_string(*row.peakBytes) : "", row.refused.empty() ? "" : quoted(row.refused),
                     machine, quoted(results.driver));
    }
  }
  return text;
}

}  // namespace rasterdiff::harness
