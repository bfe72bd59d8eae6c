#include "harness/hunt/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/report/json_parts.hpp"
#include "harness/report/numbers.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness::hunt {
namespace {

bool isLost(const Finding& finding) { return finding.verdict != Verdict::Differs; }

std::string size(const Scene& scene) {
  return fmt::format("{}, {} x {} pixels", counted(primitiveCount(scene), "primitive"), scene.target.width, scene.target.height);
}

std::string place(const Finding& finding) {
  if (isLost(finding)) return finding.signature.kind;
  return fmt::format("{} at ({}, {}) sample {}", finding.signature.kind, finding.at.x, finding.at.y, finding.at.sample);
}

std::string driverWords(const HuntReport& report) {
  return fmt::format(" --driver {} --rules {}", shellQuoted(report.subject.driver), shellQuoted(report.subject.rules));
}

std::string repeatCommand(const HuntReport& report) {
  return fmt::format("rasterdiff hunt --family {} --seed {} --count {}{}", report.family, report.seed, report.tally.scenes, driverWords(report));
}

/// Rule id → times it decided, only what decided.
std::map<std::string, uint64_t> decidedRules(const Tally& tally) {
  std::map<std::string, uint64_t> decided;
  for (const rasterizer::RuleInfo& rule : rasterizer::countedRules()) {
    if (tally.decided[rule.rule] > 0) decided[std::string(rule.id)] += tally.decided[rule.rule];
  }
  return decided;
}

Json jsonOf(const HuntReport& report, const Written& written) {
  const Finding& f = *written.finding;
  Json json{{"file", written.file}, {"picture", written.picture}, {"verdict", toString(f.verdict)}, {"kind", f.signature.kind},
            {"reason", f.reason}, {"x", f.at.x}, {"y", f.at.y}, {"sample", f.at.sample}, {"traits", namesOf(f.signature.traits)},
            {"primitives", primitiveCount(f.scene)}, {"width", f.scene.target.width}, {"height", f.scene.target.height},
            {"samplesPerPixel", f.scene.target.samples}, {"seen", f.seen}, {"attempts", f.attempts}, {"steady", f.steady}};
  if (!f.known.empty()) json["known"] = {{"rule", f.knownRule}, {"reason", f.known}};
  if (!written.file.empty()) json["check"] = checkCommand(report, written);
  return json;
}

}  // namespace

std::string fileStem(const Finding& finding) {
  constexpr size_t kLongest = 90;
  std::string stem = fmt::format("{}-{}", finding.signature.kind, namesOf(finding.signature.traits, '-'));
  std::replace(stem.begin(), stem.end(), '/', '-');
  if (stem.size() > kLongest) stem.resize(stem.rfind('-', kLongest));
  return stem;
}

int exitStatus(const HuntReport& report) {
  int status = 0;
  for (const Written& written : report.findings) {
    if (!written.finding->known.empty()) continue;
    status = std::max(status, isLost(*written.finding) ? 4 : 1);
  }
  return !report.stopped.empty() ? 4 : status;
}

std::string checkCommand(const HuntReport& report, const Written& written) {
  return fmt::format("rasterdiff check {}{} --baseline none", shellQuoted(written.file), driverWords(report));
}

std::string explainCommand(const HuntReport& report, const Written& written) {
  const Finding& f = *written.finding;
  if (isLost(f)) return {};
  return fmt::format("rasterdiff explain {} {} {} --sample {}{}", shellQuoted(written.file), f.at.x, f.at.y, f.at.sample, driverWords(report));
}

std::string huntText(const HuntReport& report, bool listKnown) {
  const Tally& t = report.tally;
  std::string text = fmt::format("driver   {}\nrules    {}\nseed     {}, family {}\n", report.subject.line, report.subject.rules, report.seed, report.family);
  text += fmt::format("scenes   {} in {:.1f} s: {} same, {} allowed, {} differ, {} skipped, {} lost the driver\n", grouped(t.scenes), report.seconds,
                      grouped(t.same), grouped(t.allowed), grouped(t.differing), grouped(t.skipped), grouped(t.lost));
  text += fmt::format("decided  {} samples, {} values; {} rules; {} pairs of rules and states, first shown by {} scenes\n", grouped(t.samples),
                      grouped(t.values), decidedRules(t).size(), grouped(report.pairs), grouped(report.kept));
  if (!report.stopped.empty()) text += fmt::format("stopped  {}\n", report.stopped);
  text += fmt::format("repeat   {}\n", repeatCommand(report));
  uint64_t known = 0, fresh = 0;
  for (const Written& written : report.findings) {
    const Finding& f = *written.finding;
    ++(f.known.empty() ? fresh : known);
    if (!f.known.empty() && !listKnown) continue;
    text += fmt::format("\n{}: {}: {}; seen {}\n", f.known.empty() ? toString(f.verdict) : "known", place(f), f.reason, counted(f.seen, "time"));
    if (!f.known.empty()) text += fmt::format("  {}: {}\n", f.knownRule, f.known);
    if (!f.steady) text += "  unsteady: this scene alone does not show it; what was drawn before it, or chance, takes part\n";
    text += fmt::format("  needs    {}\n  smallest {} ({} tries)\n", namesOf(f.signature.traits), size(f.scene), grouped(f.attempts));
    if (!written.file.empty()) text += fmt::format("  scene    {}\n", written.file);
    if (!written.picture.empty()) text += fmt::format("  picture  {}\n", written.picture);
    if (!written.file.empty()) text += fmt::format("  repeat   {}\n", checkCommand(report, written));
  }
  text += fmt::format("\n{}: {} found", fresh == 0 && report.stopped.empty() ? "PASS" : "FAIL", counted(fresh, "new difference"));
  if (known > 0) text += fmt::format(", {} known to the baseline{}", known, listKnown ? "" : " (--known lists them)");
  return text + "\n";
}

std::string huntJson(const HuntReport& report) {
  const Tally& t = report.tally;
  Json findings = Json::array();
  for (const Written& written : report.findings) findings.push_back(jsonOf(report, written));
  Json json{{"format", "rasterdiff-hunt-1"},
            {"exitStatus", exitStatus(report)},
            {"driver", {{"name", report.subject.name}, {"info", report.subject.info}, {"driver", report.subject.driver}}},
            {"rules", report.subject.rules},
            {"family", report.family},
            {"seed", report.seed},
            {"scenes", t.scenes},
            {"same", t.same},
            {"allowed", t.allowed},
            {"differing", t.differing},
            {"skipped", t.skipped},
            {"lost", t.lost},
            {"samples", t.samples},
            {"values", t.values},
            {"kept", report.kept},
            {"pairs", report.pairs},
            {"ruleCoverage", decidedRules(t)},
            {"seconds", report.seconds},
            {"repeat", repeatCommand(report)},
            {"findings", findings}};
  if (!report.stopped.empty()) json["stopped"] = report.stopped;
  return textOf(json);
}

}  // namespace rasterdiff::harness::hunt
