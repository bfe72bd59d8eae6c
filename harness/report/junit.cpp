#include "harness/report/junit.hpp"

#include <fmt/format.h>

#include <iterator>

#include "harness/report/markup.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;

double secondsOf(const Seconds& seconds) { return seconds.reference + seconds.driver + seconds.compare; }

void writeCase(Out out, const Report& report, const std::string& family, const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  fmt::format_to(out, "    <testcase classname=\"rasterdiff.{}\" name=\"{}\" time=\"{:.6f}\"", escaped(family),
                 escaped(result.id), secondsOf(result.seconds));
  const std::string command = escaped(explainCommand(report, entry));
  const std::string reason = escaped(result.reason);
  const bool passed = !entry.error && entry.validationMessages.empty() && !isUnexpected(result) &&
                      (result.verdict == Verdict::Same || result.verdict == Verdict::Allowed);
  if (passed) {
    fmt::format_to(out, "/>\n");
    return;
  }
  fmt::format_to(out, ">\n");
  if (entry.error) {
    fmt::format_to(out, "      <error type=\"Error\" message=\"{}: {}\">{}</error>\n", escaped(entry.error->where),
                   escaped(entry.error->what), escaped(entry.error->hint));
  } else if (result.baseline == BaselineStatus::ExpectedDiff) {
    fmt::format_to(out, "      <skipped message=\"known difference: {}\"/>\n", escaped(result.baselineReason));
  } else if (result.baseline == BaselineStatus::Improved) {
    fmt::format_to(out, "      <failure type=\"Improved\" message=\"stale baseline entry: {}\"/>\n",
                   escaped(result.baselineReason));
  } else if (result.verdict == Verdict::Skipped) {
    fmt::format_to(out, "      <skipped message=\"{}\"/>\n", reason);
  } else if (result.verdict == Verdict::Differs) {
    fmt::format_to(out, "      <failure type=\"Differs\" message=\"{}\">{}</failure>\n", reason, command);
  } else if (result.verdict == Verdict::Crashed || result.verdict == Verdict::TimedOut) {
    fmt::format_to(out, "      <error type=\"{}\" message=\"{}\">{}</error>\n", toString(result.verdict), reason, command);
  } else {
    fmt::format_to(out, "      <failure type=\"Validation\" message=\"{}\"/>\n",
                   escaped(entry.validationMessages.front()));
  }
  fmt::format_to(out, "    </testcase>\n");
}

}  // namespace

std::string junitReport(const Report& report) {
  const auto families = totalsByFamily(report.scenes);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rasterdiff\">\n";
  const auto out = std::back_inserter(text);
  for (const auto& [family, totals] : families) {
    fmt::format_to(out,
                   "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.6f}\">\n",
                   escaped(family), totals.scenes + totals.errors, totals.unexpected - totals.crashed - totals.timedOut,
                   totals.crashed + totals.timedOut + totals.errors, totals.skipped + totals.expected,
                   secondsOf(totals.seconds));
    fmt::format_to(out, "    <properties><property name=\"driver\" value=\"{}: {}\"/><property name=\"rules\" value=\"{}\"/>"
                        "</properties>\n",
                   escaped(report.subject.name), escaped(report.subject.info), escaped(report.subject.rules));
    for (const SceneEntry& entry : report.scenes) {
      if (familyOf(entry) == family) writeCase(out, report, family, entry);
    }
    fmt::format_to(out, "  </testsuite>\n");
  }
  return text + "</testsuites>\n";
}

}  // namespace rasterdiff::harness
