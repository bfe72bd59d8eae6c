// Adds results up: by run, by family, and batches of one random family into one entry.
#include <algorithm>
#include <utility>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {
namespace {

void addCounts(std::map<std::string, uint64_t>& sum, const std::map<std::string, uint64_t>& more) {
  for (const auto& [name, count] : more) sum[name] += count;
}

/// Returns whether `more` brought the new worst value.
bool addStats(ValueStats& sum, const ValueStats& more) {
  const uint64_t compared = sum.compared + more.compared;
  if (compared > 0) {
    sum.meanUlp = (sum.meanUlp * static_cast<double>(sum.compared) + more.meanUlp * static_cast<double>(more.compared)) /
                  static_cast<double>(compared);
  }
  sum.compared = compared;
  sum.same += more.same;
  sum.allowed += more.allowed;
  sum.differing += more.differing;
  sum.maxAbs = std::max(sum.maxAbs, more.maxAbs);
  sum.maxRatio = std::max(sum.maxRatio, more.maxRatio);
  const bool worse = more.worst && (!sum.worst || more.maxUlp > sum.maxUlp);
  if (worse) sum.worst = more.worst;
  if (!sum.firstDiffering) sum.firstDiffering = more.firstDiffering;
  sum.maxUlp = std::max(sum.maxUlp, more.maxUlp);
  return worse;
}

/// Batches share no vertices: each has its own answer, the worst state speaks for all.
void addPlacement(std::optional<PlacementAnswer>& sum, std::optional<PlacementAnswer>& more) {
  if (!more) return;
  if (!sum) {
    sum = std::move(more);
    return;
  }
  const auto gravity = [](const PlacementAnswer& answer) {
    return answer.state == PlacementAnswer::State::Impossible ? 2 : answer.state == PlacementAnswer::State::Undecided ? 1 : 0;
  };
  if (gravity(*more) > gravity(*sum)) {
    sum->state = more->state;
    sum->conflict = std::move(more->conflict);
    sum->why = std::move(more->why);
  }
  sum->gridBits = std::max(sum->gridBits, more->gridBits);
  sum->primitives += more->primitives;
  sum->vertices += more->vertices;
  sum->requirements += more->requirements;
  sum->leftOut += more->leftOut;
  sum->movedVertices += more->movedVertices;
}

/// Same < Skipped < Allowed < Differs < TimedOut < Crashed: which of two batches speaks for the family.
int gravity(Verdict verdict) {
  switch (verdict) {
    case Verdict::Same: return 0;
    case Verdict::Skipped: return 1;
    case Verdict::Allowed: return 2;
    case Verdict::Differs: return 3;
    case Verdict::TimedOut: return 4;
    case Verdict::Crashed: return 5;
  }
  return 5;
}

void countScene(Totals& totals, const SceneEntry& entry) {
  totals.validationMessages += entry.validationMessages.size();
  if (entry.error) {
    ++totals.errors;
    return;
  }
  ++totals.scenes;
  totals.unexpected += isUnexpected(entry.result) ? 1U : 0U;
  totals.expected += entry.result.baseline == BaselineStatus::ExpectedDiff ? 1U : 0U;
  totals.improved += entry.result.baseline == BaselineStatus::Improved ? 1U : 0U;
  switch (entry.result.verdict) {
    case Verdict::Same: ++totals.scenesSame; break;
    case Verdict::Allowed: ++totals.scenesAllowed; break;
    case Verdict::Differs: ++totals.scenesDiffer; break;
    case Verdict::Skipped: ++totals.skipped; break;
    case Verdict::Crashed: totals.crashed += isUnexpected(entry.result) ? 1U : 0U; break;
    case Verdict::TimedOut: ++totals.timedOut; break;
  }
}

void addEntry(Totals& totals, const SceneEntry& entry) {
  countScene(totals, entry);
  if (entry.error) return;
  const SceneResult& result = entry.result;
  totals.samples += result.samples;
  totals.same += result.same;
  totals.allowed += result.allowed;
  totals.differing += result.differing;
  totals.coveredSamples += result.coveredSamples;
  if (result.samples > 0) totals.primitives += entry.primitives;
  addCounts(totals.freedoms, result.freedoms);
  if (result.placement) ++totals.placements[result.placement->state];
  addCounts(totals.ruleCoverage, result.ruleCoverage);
  for (const ValueStats& value : result.values) {
    totals.values += value.compared;
    totals.valuesSame += value.same;
    totals.valuesAllowed += value.allowed;
    totals.valuesDiffering += value.differing;
    totals.maxUlp = std::max(totals.maxUlp, value.maxUlp);
    totals.maxRatio = std::max(totals.maxRatio, value.maxRatio);
    ValueStats& sum = totals.byValue[value.name];
    sum.name = value.name;
    if (!addStats(sum, value)) continue;
    const auto at = entry.worstAt.find(value.name);
    totals.worstAt[value.name] = at == entry.worstAt.end() ? entry.address : at->second;
  }
  totals.seconds += result.seconds;
}

}  // namespace

Totals totalsOf(std::span<const SceneEntry> entries) {
  Totals totals;
  for (const SceneEntry& entry : entries) addEntry(totals, entry);
  return totals;
}

std::string familyOf(const SceneEntry& entry) {
  if (entry.address.ends_with(".json")) return "files";
  return entry.result.id.substr(0, entry.result.id.find('/'));
}

std::vector<std::pair<std::string, Totals>> totalsByFamily(std::span<const SceneEntry> entries) {
  std::vector<std::pair<std::string, Totals>> families;
  for (const SceneEntry& entry : entries) {
    const std::string name = familyOf(entry);
    auto found = std::find_if(families.begin(), families.end(), [&](const auto& f) { return f.first == name; });
    if (found == families.end()) found = families.insert(families.end(), {name, Totals{}});
    addEntry(found->second, entry);
  }
  return families;
}

void addBatch(SceneEntry& sum, SceneEntry batch) {
  SceneResult& into = sum.result;
  SceneResult& from = batch.result;
  sum.batches += batch.batches;
  sum.primitives += batch.primitives;
  for (std::string& message : batch.validationMessages) sum.validationMessages.push_back(std::move(message));
  if (!sum.error) sum.error = std::move(batch.error);
  into.samples += from.samples;
  into.same += from.same;
  into.allowed += from.allowed;
  into.differing += from.differing;
  into.coveredSamples += from.coveredSamples;
  addCounts(into.freedoms, from.freedoms);
  addPlacement(into.placement, from.placement);
  addCounts(into.ruleCoverage, from.ruleCoverage);
  for (ValueStats& value : from.values) {
    auto same = std::find_if(into.values.begin(), into.values.end(), [&](const auto& v) { return v.name == value.name; });
    if (same == into.values.end()) {
      sum.worstAt[value.name] = batch.address;
      into.values.push_back(std::move(value));
    } else if (addStats(*same, value)) {
      sum.worstAt[value.name] = batch.address;
    }
  }
  into.seconds += from.seconds;
  if (gravity(from.verdict) > gravity(into.verdict)) {
    into.verdict = from.verdict;
    into.reason = std::move(from.reason);
    into.differences = std::move(from.differences);
    sum.address = std::move(batch.address);
    if (!batch.pictures.reference.empty()) sum.pictures = std::move(batch.pictures);
  }
}

}  // namespace rasterdiff::harness
