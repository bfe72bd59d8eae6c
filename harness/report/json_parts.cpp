#include "harness/report/json_parts.hpp"

#include <cmath>
#include <string_view>

namespace rasterdiff::harness {
namespace {

std::string_view codeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadInput: return "BadInput";
    case ErrorCode::Io: return "Io";
    case ErrorCode::NoDevice: return "NoDevice";
    case ErrorCode::NotOffered: return "NotOffered";
    case ErrorCode::DeviceLost: return "DeviceLost";
    case ErrorCode::TimedOut: return "TimedOut";
  }
  return "BadInput";
}

Json jsonOfPlace(const ValueStats::Worst& place) {
  return {{"x", place.x},
          {"y", place.y},
          {"sample", place.sample},
          {"component", place.component},
          {"expected", jsonNumber(place.expected)},
          {"actual", jsonNumber(place.actual)},
          {"lo", jsonNumber(place.lo)},
          {"hi", jsonNumber(place.hi)}};
}

Json jsonOfValue(const ValueStats& value) {
  Json json{{"maxUlp", jsonNumber(value.maxUlp)},     {"meanUlp", jsonNumber(value.meanUlp)},
            {"maxAbs", jsonNumber(value.maxAbs)},     {"compared", value.compared},
            {"same", value.same},                     {"allowed", value.allowed},
            {"differing", value.differing},           {"maxRatio", jsonNumber(value.maxRatio)}};
  if (value.worst) json["worst"] = jsonOfPlace(*value.worst);
  if (value.firstDiffering) json["firstDiffering"] = jsonOfPlace(*value.firstDiffering);
  return json;
}

Json jsonOfDifference(const SampleDifference& difference) {
  return {{"x", difference.x},
          {"y", difference.y},
          {"sample", difference.sample},
          {"verdict", toString(difference.verdict)},
          {"reason", difference.reason},
          {"anchor", difference.anchor},
          {"expectedPrimitive", difference.expectedPrimitive},
          {"actualPrimitive", difference.actualPrimitive},
          {"expectedCount", difference.expectedCount},
          {"actualCount", difference.actualCount}};
}

/// The first sample that is not the same: coverage before values.
Json firstPlace(const SceneResult& result) {
  if (!result.differences.empty()) {
    const SampleDifference& first = result.differences.front();
    return {{"x", first.x}, {"y", first.y}, {"sample", first.sample}};
  }
  for (const ValueStats& value : result.values) {
    if (value.firstDiffering) {
      return {{"x", value.firstDiffering->x}, {"y", value.firstDiffering->y}, {"sample", value.firstDiffering->sample}};
    }
  }
  return nullptr;
}

}  // namespace

Json jsonNumber(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "Infinity" : "-Infinity";
  return number;
}

std::string textOf(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json jsonOf(const Seconds& seconds) {
  const DriverSeconds& parts = seconds.parts;
  return {{"setUp", seconds.setUp},       {"reference", seconds.reference}, {"driver", seconds.driver},
          {"drawing", parts.drawing},     {"pipelines", parts.pipelines},   {"upload", parts.upload},
          {"readback", parts.readback},   {"compare", seconds.compare},     {"pictures", seconds.pictures}};
}

Json jsonOf(const Error& error) {
  return {{"code", codeName(error.code)}, {"where", error.where}, {"what", error.what}, {"hint", error.hint}};
}

Json jsonOf(const Limits& limits) {
  return {{"subPixelPrecisionBits", limits.subPixelPrecisionBits},
          {"viewportSubPixelBits", limits.viewportSubPixelBits},
          {"framebufferSampleCounts", limits.framebufferSampleCounts},
          {"standardSampleLocations", limits.standardSampleLocations},
          {"sampleLocationSampleCounts", limits.sampleLocationSampleCounts},
          {"maxSampleLocationGridWidth", limits.maxSampleLocationGridWidth},
          {"maxSampleLocationGridHeight", limits.maxSampleLocationGridHeight},
          {"sampleLocationCoordinateMin", limits.sampleLocationCoordinateMin},
          {"sampleLocationCoordinateMax", limits.sampleLocationCoordinateMax},
          {"sampleLocationSubPixelBits", limits.sampleLocationSubPixelBits},
          {"maxFramebufferWidth", limits.maxFramebufferWidth},
          {"maxFramebufferHeight", limits.maxFramebufferHeight},
          {"provokingVertexLast", limits.provokingVertexLast},
          {"depthClipControl", limits.depthClipControl},
          {"strictLines", limits.strictLines},
          {"rectangularLines", limits.rectangularLines},
          {"bresenhamLines", limits.bresenhamLines},
          {"smoothLines", limits.smoothLines},
          {"stippledRectangularLines", limits.stippledRectangularLines},
          {"stippledBresenhamLines", limits.stippledBresenhamLines},
          {"lineWidthMin", limits.lineWidthMin},
          {"lineWidthMax", limits.lineWidthMax},
          {"lineWidthGranularity", limits.lineWidthGranularity},
          {"pointSizeMin", limits.pointSizeMin},
          {"pointSizeMax", limits.pointSizeMax},
          {"pointSizeGranularity", limits.pointSizeGranularity},
          {"pointClippingBehavior", static_cast<uint32_t>(limits.pointClippingBehavior)},
          {"subPixelInterpolationOffsetBits", limits.subPixelInterpolationOffsetBits},
          {"minInterpolationOffset", limits.minInterpolationOffset},
          {"maxInterpolationOffset", limits.maxInterpolationOffset}};
}

Json jsonOf(const PlacementAnswer& answer) {
  Json json{{"state", toString(answer.state)},       {"gridBits", answer.gridBits},
            {"primitives", answer.primitives},       {"vertices", answer.vertices},
            {"requirements", answer.requirements},   {"leftOut", answer.leftOut},
            {"movedVertices", answer.movedVertices}, {"moved", Json::array()},
            {"conflict", answer.conflict},           {"why", answer.why}};
  for (const VertexPlacement& moved : answer.moved) {
    json["moved"].push_back({{"draw", moved.draw},
                             {"vertex", moved.vertex},
                             {"nominal", {moved.nominalX, moved.nominalY}},
                             {"placed", {moved.x, moved.y}}});
  }
  return json;
}

Json jsonOf(const SceneResult& result) {
  Json json{{"id", result.id}, {"verdict", toString(result.verdict)}};
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (result.baseline != BaselineStatus::None) {
    json["baseline"] = toString(result.baseline);
    json["baselineReason"] = result.baselineReason;
  }
  json["samples"] = result.samples;
  json["same"] = result.same;
  json["allowed"] = result.allowed;
  json["differing"] = result.differing;
  json["coveredSamples"] = result.coveredSamples;
  json["freedoms"] = Json(result.freedoms);
  json["values"] = Json::object();
  for (const ValueStats& value : result.values) json["values"][value.name] = jsonOfValue(value);
  if (Json first = firstPlace(result); !first.is_null()) json["first"] = std::move(first);
  json["differences"] = Json::array();
  for (const SampleDifference& difference : result.differences) {
    json["differences"].push_back(jsonOfDifference(difference));
  }
  if (result.placement) json["placement"] = jsonOf(*result.placement);
  json["ruleCoverage"] = Json(result.ruleCoverage);
  json["seconds"] = jsonOf(result.seconds);
  return json;
}

Json jsonOf(const SceneEntry& entry) {
  Json json = jsonOf(entry.result);
  json["scene"] = entry.address;
  json["what"] = entry.what;
  if (!entry.link.empty()) json["link"] = entry.link;
  json["rules"] = entry.rules;
  json["width"] = entry.width;
  json["height"] = entry.height;
  json["samplesPerPixel"] = entry.samplesPerPixel;
  json["primitives"] = entry.primitives;
  json["batches"] = entry.batches;
  if (!entry.validationMessages.empty()) json["validationMessages"] = entry.validationMessages;
  return json;
}

}  // namespace rasterdiff::harness
