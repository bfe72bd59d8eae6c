#include "harness/report/record.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/report/base64.hpp"
#include "harness/report/json_parts.hpp"

namespace rasterdiff::harness {
namespace {

double numberIn(const Json& json, const char* key) {
  const Json& value = json.at(key);
  if (value.is_number()) return value.get<double>();
  const std::string word = value.get<std::string>();
  if (word == "NaN") return std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  return word == "-Infinity" ? -infinity : infinity;
}

Verdict verdictIn(const Json& json) {
  constexpr std::array kAll{Verdict::Same,    Verdict::Allowed, Verdict::Differs,
                            Verdict::Skipped, Verdict::Crashed, Verdict::TimedOut};
  const std::string name = json.at("verdict").get<std::string>();
  for (const Verdict verdict : kAll) {
    if (toString(verdict) == name) return verdict;
  }
  throw std::invalid_argument("unknown verdict");
}

std::optional<ValueStats::Worst> placeIn(const Json& json, const char* key) {
  if (!json.contains(key)) return std::nullopt;
  const Json& place = json.at(key);
  const auto number = [&](const char* name) { return static_cast<float>(numberIn(place, name)); };
  return ValueStats::Worst{place.at("x"),      place.at("y"),    place.at("sample"), place.at("component"),
                           number("expected"), number("actual"), number("lo"),       number("hi")};
}

ValueStats valueIn(const std::string& name, const Json& json) {
  ValueStats value;
  value.name = name;
  value.compared = json.at("compared");
  value.same = json.at("same");
  value.allowed = json.at("allowed");
  value.differing = json.at("differing");
  value.maxUlp = numberIn(json, "maxUlp");
  value.meanUlp = numberIn(json, "meanUlp");
  value.maxAbs = numberIn(json, "maxAbs");
  value.maxRatio = numberIn(json, "maxRatio");
  value.worst = placeIn(json, "worst");
  value.firstDiffering = placeIn(json, "firstDiffering");
  return value;
}

SampleDifference differenceIn(const Json& json) {
  return {json.at("x"),
          json.at("y"),
          json.at("sample"),
          verdictIn(json),
          json.at("reason"),
          json.at("anchor"),
          json.at("expectedPrimitive"),
          json.at("actualPrimitive"),
          json.at("expectedCount"),
          json.at("actualCount")};
}

PlacementAnswer placementIn(const Json& json) {
  using State = PlacementAnswer::State;
  PlacementAnswer answer;
  for (const State state : {State::Explained, State::Impossible, State::Undecided}) {
    if (toString(state) == json.at("state")) answer.state = state;
  }
  answer.gridBits = json.at("gridBits");
  answer.primitives = json.at("primitives");
  answer.vertices = json.at("vertices");
  answer.requirements = json.at("requirements");
  answer.leftOut = json.at("leftOut");
  answer.movedVertices = json.at("movedVertices");
  for (const Json& moved : json.at("moved")) {
    const Json& nominal = moved.at("nominal");
    const Json& placed = moved.at("placed");
    answer.moved.push_back({moved.at("draw"), moved.at("vertex"), nominal.at(0), nominal.at(1), placed.at(0), placed.at(1)});
  }
  json.at("conflict").get_to(answer.conflict);
  answer.why = json.at("why");
  return answer;
}

Seconds secondsIn(const Json& json) {
  return {json.at("setUp"),    json.at("reference"), json.at("driver"), json.at("compare"),
          json.at("pictures"), {json.at("drawing"), json.at("pipelines"), json.at("upload"), json.at("readback")}};
}

SceneResult resultIn(const Json& json) {
  SceneResult result;
  result.id = json.at("id");
  result.verdict = verdictIn(json);
  result.reason = json.value("reason", "");
  result.samples = json.at("samples");
  result.same = json.at("same");
  result.allowed = json.at("allowed");
  result.differing = json.at("differing");
  result.coveredSamples = json.at("coveredSamples");
  json.at("freedoms").get_to(result.freedoms);
  json.at("ruleCoverage").get_to(result.ruleCoverage);
  for (const auto& [name, value] : json.at("values").items()) result.values.push_back(valueIn(name, value));
  for (const Json& difference : json.at("differences")) result.differences.push_back(differenceIn(difference));
  if (json.contains("placement")) result.placement = placementIn(json.at("placement"));
  result.seconds = secondsIn(json.at("seconds"));
  return result;
}

ErrorCode codeIn(const Json& json) {
  for (int code = 0; code <= static_cast<int>(ErrorCode::TimedOut); ++code) {
    const Error error{static_cast<ErrorCode>(code), {}, {}, {}};
    if (jsonOf(error).at("code") == json.at("code")) return error.code;
  }
  throw std::invalid_argument("unknown error code");
}

Error errorIn(const Json& json) { return {codeIn(json), json.at("where"), json.at("what"), json.at("hint")}; }

Limits limitsIn(const Json& json) {
  Limits limits;
  json.at("subPixelPrecisionBits").get_to(limits.subPixelPrecisionBits);
  json.at("viewportSubPixelBits").get_to(limits.viewportSubPixelBits);
  json.at("framebufferSampleCounts").get_to(limits.framebufferSampleCounts);
  json.at("standardSampleLocations").get_to(limits.standardSampleLocations);
  json.at("sampleLocationSampleCounts").get_to(limits.sampleLocationSampleCounts);
  json.at("maxSampleLocationGridWidth").get_to(limits.maxSampleLocationGridWidth);
  json.at("maxSampleLocationGridHeight").get_to(limits.maxSampleLocationGridHeight);
  json.at("sampleLocationCoordinateMin").get_to(limits.sampleLocationCoordinateMin);
  json.at("sampleLocationCoordinateMax").get_to(limits.sampleLocationCoordinateMax);
  json.at("sampleLocationSubPixelBits").get_to(limits.sampleLocationSubPixelBits);
  json.at("maxFramebufferWidth").get_to(limits.maxFramebufferWidth);
  json.at("maxFramebufferHeight").get_to(limits.maxFramebufferHeight);
  json.at("provokingVertexLast").get_to(limits.provokingVertexLast);
  json.at("depthClipControl").get_to(limits.depthClipControl);
  json.at("strictLines").get_to(limits.strictLines);
  json.at("rectangularLines").get_to(limits.rectangularLines);
  json.at("bresenhamLines").get_to(limits.bresenhamLines);
  json.at("smoothLines").get_to(limits.smoothLines);
  json.at("stippledRectangularLines").get_to(limits.stippledRectangularLines);
  json.at("stippledBresenhamLines").get_to(limits.stippledBresenhamLines);
  json.at("lineWidthMin").get_to(limits.lineWidthMin);
  json.at("lineWidthMax").get_to(limits.lineWidthMax);
  json.at("lineWidthGranularity").get_to(limits.lineWidthGranularity);
  json.at("pointSizeMin").get_to(limits.pointSizeMin);
  json.at("pointSizeMax").get_to(limits.pointSizeMax);
  json.at("pointSizeGranularity").get_to(limits.pointSizeGranularity);
  limits.pointClippingBehavior =
      static_cast<PointClippingBehavior>(json.at("pointClippingBehavior").get<uint32_t>());
  json.at("subPixelInterpolationOffsetBits").get_to(limits.subPixelInterpolationOffsetBits);
  json.at("minInterpolationOffset").get_to(limits.minInterpolationOffset);
  json.at("maxInterpolationOffset").get_to(limits.maxInterpolationOffset);
  return limits;
}

/// Runs `read` on the parsed text; whatever the library throws becomes an Error.
template <class Read>
auto reading(std::string_view text, Read&& read) -> Result<decltype(read(Json{}))> {
  try {
    return read(Json::parse(text));
  } catch (const std::exception& exception) {
    return fail(ErrorCode::BadInput, "worker record", exception.what(), "run again with --jobs 1");
  }
}

}  // namespace

std::string recordOf(const SceneEntry& entry) {
  Json json = jsonOf(entry);
  if (entry.error) json["error"] = jsonOf(*entry.error);
  const Pictures& pictures = entry.pictures;
  json["pictures"] = {{"reference", toBase64(pictures.reference)}, {"driver", toBase64(pictures.driver)},
                      {"difference", toBase64(pictures.difference)}, {"thumbnail", toBase64(pictures.thumbnail)}, {"closeUp", pictures.closeUp},
                      {"width", pictures.width}, {"height", pictures.height}};
  return textOf(json, -1);
}

std::string recordOf(const RunSubject& subject) {
  return textOf({{"driver", subject.driver},
                 {"name", subject.name},
                 {"info", subject.info},
                 {"line", subject.line},
                 {"details", subject.details},
                 {"limits", jsonOf(subject.limits)},
                 {"rules", subject.rules},
                 {"rulesOpen", subject.rulesOpen}},
                -1);
}

std::string recordOf(const Error& error) { return textOf(jsonOf(error), -1); }

Result<SceneEntry> readSceneRecord(std::string_view text) {
  return reading(text, [](const Json& json) {
    SceneEntry entry;
    entry.result = resultIn(json);
    entry.address = json.at("scene");
    entry.what = json.at("what");
    entry.link = json.value("link", "");
    json.at("rules").get_to(entry.rules);
    entry.width = json.at("width");
    entry.height = json.at("height");
    entry.samplesPerPixel = json.at("samplesPerPixel");
    entry.primitives = json.at("primitives");
    entry.batches = json.at("batches");
    if (json.contains("validationMessages")) json.at("validationMessages").get_to(entry.validationMessages);
    if (json.contains("error")) entry.error = errorIn(json.at("error"));
    const Json& pictures = json.at("pictures");
    const auto file = [&](const char* name) { return fromBase64(pictures.at(name).get<std::string>()); };
    entry.pictures = {file("reference"), file("driver"),          file("difference"),     file("thumbnail"),
                      pictures.at("closeUp"), pictures.at("width"), pictures.at("height")};
    return entry;
  });
}

Result<RunSubject> readSubjectRecord(std::string_view text) {
  return reading(text, [](const Json& json) {
    RunSubject subject;
    subject.driver = json.at("driver");
    subject.name = json.at("name");
    subject.info = json.at("info");
    subject.line = json.at("line");
    json.at("details").get_to(subject.details);
    subject.limits = limitsIn(json.at("limits"));
    subject.rules = json.at("rules");
    subject.rulesOpen = json.at("rulesOpen");
    return subject;
  });
}

Result<Error> readErrorRecord(std::string_view text) {
  return reading(text, [](const Json& json) { return errorIn(json); });
}

}  // namespace rasterdiff::harness
