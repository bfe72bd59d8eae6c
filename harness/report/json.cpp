#include "harness/report/json.hpp"

#include "harness/report/json_parts.hpp"

namespace rasterdiff::harness {
namespace {

Json jsonOfDriver(const RunSubject& subject) {
  Json json{{"name", subject.name}, {"info", subject.info}, {"driver", subject.driver}};
  for (const auto& [name, value] : subject.details) json[name] = value;
  json.update(jsonOf(subject.limits));
  return json;
}

Json jsonOfTotals(const Totals& totals) {
  return {{"scenes", totals.scenes},
          {"scenesSame", totals.scenesSame},
          {"scenesAllowed", totals.scenesAllowed},
          {"scenesDiffer", totals.scenesDiffer},
          {"skipped", totals.skipped},
          {"crashed", totals.crashed},
          {"timedOut", totals.timedOut},
          {"unexpected", totals.unexpected},
          {"expected", totals.expected},
          {"improved", totals.improved},
          {"errors", totals.errors},
          {"validationMessages", totals.validationMessages},
          {"primitives", totals.primitives},
          {"samples", totals.samples},
          {"same", totals.same},
          {"allowed", totals.allowed},
          {"differing", totals.differing},
          {"coveredSamples", totals.coveredSamples},
          {"values", totals.values},
          {"valuesSame", totals.valuesSame},
          {"valuesAllowed", totals.valuesAllowed},
          {"valuesDiffering", totals.valuesDiffering},
          {"maxUlp", jsonNumber(totals.maxUlp)},
          {"maxRatio", jsonNumber(totals.maxRatio)},
          {"seconds", jsonOf(totals.seconds)}};
}

}  // namespace

std::string jsonReport(const Report& report) {
  const Totals totals = totalsOf(report.scenes);
  Json json{{"format", "rasterdiff-results-1"},
            {"verdict", verdictLine(report)},
            {"exitStatus", exitStatus(report)},
            {"driver", jsonOfDriver(report.subject)},
            {"rules", report.subject.rules},
            {"scenes", Json::array()}};
  Json errors = Json::array();
  for (const SceneEntry& entry : report.scenes) {
    if (!entry.error) {
      json["scenes"].push_back(jsonOf(entry));
      continue;
    }
    Json error = jsonOf(*entry.error);
    error["id"] = entry.result.id;
    errors.push_back(std::move(error));
  }
  json["ruleCoverage"] = Json(totals.ruleCoverage);
  json["freedoms"] = Json(totals.freedoms);
  json["totals"] = jsonOfTotals(totals);
  json["errors"] = std::move(errors);
  if (!report.stopped.empty()) json["stopped"] = report.stopped;
  json["notRun"] = report.notRun;
  json["workers"] = report.workers;
  json["wallSeconds"] = report.wallSeconds;
  return textOf(json) + "\n";
}

}  // namespace rasterdiff::harness
