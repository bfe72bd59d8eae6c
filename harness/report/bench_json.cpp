#include "harness/report/bench_data.hpp"
#include "harness/report/json_parts.hpp"

namespace rasterdiff::harness {
namespace {

using namespace bench;

Json jsonOfTiming(const Timing& timing) {
  return {{"median", timing.median},
          {"fastest", timing.fastest},
          {"deviation", timing.deviation},
          {"rounds", timing.rounds},
          {"draws", timing.draws}};
}

Json jsonOfError(const ErrorCount& error) {
  Json json{{"triangles", error.triangles}, {"covered", error.covered}, {"wrong", error.wrong}, {"values", error.values}};
  if (error.values > 0) {
    json["maxUlp"] = jsonNumber(error.maxUlp);
    json["meanUlp"] = jsonNumber(error.meanUlp);
  }
  return json;
}

Json jsonOfRow(const Row& row) {
  Json json{{"task", toString(row.task)}, {"method", row.method}, {"what", row.what}, {"exact", row.exact}, {"threads", row.threads}};
  if (!row.target.empty()) json["target"] = row.target;
  json["triangles"] = row.triangles;
  json["samples"] = row.samples;
  if (row.timing) {
    json["trianglesPerSecond"] = trianglesPerSecond(row);
    json["samplesPerSecond"] = samplesPerSecond(row);
    json["seconds"] = jsonOfTiming(*row.timing);
  }
  if (row.error) json["error"] = jsonOfError(*row.error);
  if (row.peakBytes) json["peakBytes"] = *row.peakBytes;
  if (!row.refused.empty()) json["refused"] = row.refused;
  return json;
}

Json jsonOfLoad(const LoadResult& load) {
  Json rows = Json::array();
  for (const Row& row : load.rows) rows.push_back(jsonOfRow(row));
  Json json{{"name", load.name},       {"what", load.what},           {"width", load.width},
            {"height", load.height},   {"samples", load.samples},     {"triangles", load.triangles},
            {"coveredSamples", load.coveredSamples}};
  if (!load.note.empty()) json["note"] = load.note;
  json["rows"] = std::move(rows);
  return json;
}

Json jsonOfSampling(const SamplingRow& row) {
  return {{"method", row.method},     {"samples", row.samples},   {"pixels", row.pixels}, {"maxError", row.maxError},
          {"rmsError", row.rmsError}, {"wrong", row.wrong},       {"seconds", jsonOfTiming(row.timing)}};
}

Json jsonOfScaling(const ScalingSeries& series) {
  Json points = Json::array();
  for (const ScalingSeries::Point& point : series.points) points.push_back({{"x", point.x}, {"row", jsonOfRow(point.row)}});
  return {{"name", series.name},
          {"variable", series.variable},
          {"expected", series.expected},
          {"perSample", series.perSample},
          {"points", std::move(points)}};
}

}  // namespace

std::string benchJson(const Results& results) {
  const Machine& machine = results.machine;
  Json json{{"format", "rasterdiff-bench-1"}};
  json["machine"] = {{"cpu", machine.cpu},           {"cores", machine.cores},     {"compiler", machine.compiler},
                     {"system", machine.system},     {"date", machine.date},       {"targets", machine.targets},
                     {"loadAverage", machine.loadAverage}};
  if (!results.driver.empty()) json["driver"] = results.driver;
  json["rounds"] = results.rounds;
  json["loads"] = json["sampling"] = json["scaling"] = Json::array();
  for (const LoadResult& load : results.loads) json["loads"].push_back(jsonOfLoad(load));
  for (const SamplingRow& row : results.sampling) json["sampling"].push_back(jsonOfSampling(row));
  for (const ScalingSeries& series : results.scaling) json["scaling"].push_back(jsonOfScaling(series));
  json["wallSeconds"] = results.wallSeconds;
  return textOf(json) + "\n";
}

}  // namespace rasterdiff::harness
