#include "harness/stability/results.hpp"

#include <fmt/format.h>

#include <iterator>
#include <sstream>

namespace rasterdiff::harness::stability {

std::vector<const Series*> seriesOf(const Results& results, std::string_view family, bool values) {
  std::vector<const Series*> found;
  for (const Series& series : results.series) {
    if (series.family == family && series.values == values) found.push_back(&series);
  }
  return found;
}

// family, method with '_' for ' ', values, judged, number of points, then six numbers a point; one line a series.
std::string recordOf(const std::vector<Series>& all) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Series& series : all) {
    std::string method = series.method;
    for (char& c : method) c = c == ' ' ? '_' : c;
    fmt::format_to(out, "{} {} {:d} {:d} {}", series.family, method, series.values, series.judged, series.points.size());
    for (const Point& p : series.points) fmt::format_to(out, " {} {} {} {} {} {:d}", p.dial, p.cases, p.wrong, p.maxUlp, p.notFinite, p.offered);
    text += '\n';
  }
  return text;
}

Result<std::vector<Series>> readRecord(std::string_view text) {
  std::vector<Series> all;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Series series;
    size_t points = 0;
    words >> series.family >> series.method >> series.values >> series.judged >> points;
    for (char& c : series.method) c = c == '_' ? ' ' : c;
    for (size_t i = 0; i < points && words; ++i) {
      Point& p = series.points.emplace_back();
      std::string ulps;
      words >> p.dial >> p.cases >> p.wrong >> ulps >> p.notFinite >> p.offered;
      p.maxUlp = std::strtod(ulps.c_str(), nullptr);  // a stream does not read "inf"
    }
    if (!words) return fail(ErrorCode::BadInput, "record", "the driver's process wrote no measurement");
    all.push_back(std::move(series));
  }
  return all;
}

}  // namespace rasterdiff::harness::stability
