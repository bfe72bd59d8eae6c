#include "harness/hunt/record.hpp"

#include <stdexcept>

#include "harness/report/json_parts.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff::harness::hunt {
namespace {

Json jsonOf(const rasterizer::RuleCounts& counts) { return counts.decided; }

Json jsonOf(const Judgement& judgement) {
  Json differences = Json::array();
  for (const Difference& d : judgement.differences) differences.push_back({d.kind, d.x, d.y, d.sample});
  return {{"verdict", static_cast<int>(judgement.verdict)}, {"reason", judgement.reason}, {"differences", differences},
          {"samples", judgement.samples}, {"values", judgement.values}, {"counts", jsonOf(judgement.counts)}};
}

rasterizer::RuleCounts countsIn(const Json& json) {
  rasterizer::RuleCounts counts;
  json.get_to(counts.decided);
  return counts;
}

Verdict verdictIn(const Json& json) {
  const int verdict = json.get<int>();
  if (verdict < 0 || verdict > static_cast<int>(Verdict::TimedOut)) throw std::invalid_argument("unknown verdict");
  return static_cast<Verdict>(verdict);
}

Judgement judgementIn(const Json& json) {
  Judgement judgement{verdictIn(json.at("verdict")), json.at("reason"), {}, json.at("samples"), json.at("values"), countsIn(json.at("counts"))};
  for (const Json& d : json.at("differences")) judgement.differences.push_back({d.at(0), d.at(1), d.at(2), d.at(3)});
  return judgement;
}

Scene sceneIn(const Json& json) {
  Result<Scene> scene = parseScene(json.get<std::string>(), "hunt.scene.json");
  if (!scene) throw std::invalid_argument(scene.error().where + ": " + scene.error().what);
  return std::move(*scene);
}

template <class Read>
auto reading(std::string_view text, const Read& read) -> Result<decltype(read(Json{}))> {
  try {
    return read(Json::parse(text));
  } catch (const std::exception& exception) {
    return fail(ErrorCode::BadInput, "worker record", exception.what(), "run again with another --seed");
  }
}

}  // namespace

std::string recordOf(const Judgement& judgement) { return textOf(jsonOf(judgement), -1); }

std::string recordOf(const Shrunk& shrunk) {
  return textOf({{"scene", writeScene(shrunk.scene)}, {"kind", shrunk.kind}, {"judgement", jsonOf(shrunk.judgement)}, {"attempts", shrunk.attempts}}, -1);
}

std::string recordOf(const LaneResult& lane) {
  Json kept = Json::array(), raw = Json::array();
  for (const Kept& k : lane.kept) kept.push_back({writeScene(k.scene), k.pairs});
  for (const Raw& r : lane.raw) {
    raw.push_back({writeScene(r.scene), r.signature.kind, r.signature.traits.to_ullong(), static_cast<int>(r.verdict)});
  }
  const Tally& t = lane.tally;
  return textOf({{"kept", kept}, {"raw", raw}, {"decided", jsonOf(t.decided)},
                 {"tally", {t.scenes, t.skipped, t.same, t.allowed, t.differing, t.lost, t.samples, t.values}}}, -1);
}

Result<Judgement> readJudgementRecord(std::string_view text) {
  return reading(text, [](const Json& json) { return judgementIn(json); });
}

Result<Shrunk> readShrunkRecord(std::string_view text) {
  return reading(text, [](const Json& json) {
    return Shrunk{sceneIn(json.at("scene")), json.at("kind"), judgementIn(json.at("judgement")), json.at("attempts")};
  });
}

Result<LaneResult> readLaneRecord(std::string_view text) {
  return reading(text, [](const Json& json) {
    LaneResult lane;
    for (const Json& k : json.at("kept")) lane.kept.push_back({sceneIn(k.at(0)), k.at(1).get<std::vector<Pair>>()});
    for (const Json& r : json.at("raw")) {
      lane.raw.push_back({sceneIn(r.at(0)), {r.at(1), Traits(r.at(2).get<unsigned long long>())}, verdictIn(r.at(3))});
    }
    const Json& t = json.at("tally");
    lane.tally = {t.at(0), t.at(1), t.at(2), t.at(3), t.at(4), t.at(5), t.at(6), t.at(7), countsIn(json.at("decided"))};
    return lane;
  });
}

}  // namespace rasterdiff::harness::hunt
