#include "harness/hunt/campaign.hpp"

#include <algorithm>
#include <bit>

#include "scene/built_ins.hpp"

namespace rasterdiff::harness::hunt {
namespace {

bool isPlaneOfItsOwn(std::string_view plane) {
  constexpr BuiltIn kAll[] = {BuiltIn::FragCoord,  BuiltIn::FrontFacing, BuiltIn::PointCoord,
                              BuiltIn::SampleMask, BuiltIn::SampleId,    BuiltIn::SamplePosition};
  if (plane == "coverage" || plane == "depth" || plane == "crash") return true;
  return std::any_of(std::begin(kAll), std::end(kAll), [&](BuiltIn b) { return builtInName(b) == plane; });
}

/// Coverage, depth and built-ins by their name; a varying by its interpolation, if `when` names one.
bool explains(const BaselineEntry& entry, const Traits& when, std::string_view kind) {
  constexpr std::string_view kResolved = "resolved/";
  const std::string_view own = kind.starts_with(kResolved) ? kind.substr(kResolved.size()) : planeKind(kind);
  Traits named;
  for (size_t t = static_cast<size_t>(Trait::Smooth); t <= static_cast<size_t>(Trait::Offset); ++t) named[t] = when[t];
  return std::any_of(entry.planes.begin(), entry.planes.end(), [&](const std::string& plane) {
    if (isPlaneOfItsOwn(plane) || isPlaneOfItsOwn(own)) return plane == own;
    return named.none() || includes(named, traitsNamed(own));
  });
}

bool isFor(const BaselineEntry& entry, std::string_view driverName, std::string_view driverInfo, std::string_view rulesName) {
  return !entry.when.empty() && entry.driver == driverName && driverInfo.starts_with(entry.version) &&
         appliesUnder(entry, rulesName);
}

}  // namespace

const BaselineEntry* knownEntry(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo,
                                std::string_view rulesName, const Signature& signature) {
  for (const BaselineEntry& entry : baseline.entries) {
    if (!isFor(entry, driverName, driverInfo, rulesName) || !explains(entry, traitsNamed(entry.when), signature.kind)) continue;
    if (includes(signature.traits, traitsNamed(entry.when))) return &entry;
  }
  return nullptr;
}

Campaign::Campaign(CampaignOptions options) : options_(std::move(options)) {
  for (const BaselineEntry& entry : options_.baseline.entries) {
    if (isFor(entry, options_.driverName, options_.driverInfo, options_.rulesName)) avoided_.push_back({{}, traitsNamed(entry.when)});
  }
}

LaneOptions Campaign::laneOptions(uint64_t lane) const {
  return {options_.family, options_.limits, options_.seed, lane, kScenesPerLane, avoided_};
}

void Campaign::absorb(LaneResult lane) {
  ++lanes_;
  tally_ += lane.tally;
  for (Kept& kept : lane.kept) (void)corpus_.offer(std::move(kept));
  for (Raw& raw : lane.raw) waiting_.push_back(std::move(raw));
}

std::vector<Raw> Campaign::toShrink() {
  std::vector<Raw> chosen;
  for (Raw& raw : waiting_) {
    const auto like = [&](const Signature& s) { return s.kind == raw.signature.kind && includes(raw.signature.traits, s.traits); };
    const auto found = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& f) { return f.steady && like(f.signature); });
    if (found != findings_.end() && !std::has_single_bit(++found->seen)) continue;
    const bool chosenLike = std::any_of(chosen.begin(), chosen.end(), [&](const Raw& c) { return c.signature.kind == raw.signature.kind; });
    // One of a kind at a time: the next of that kind may turn out to be the same.
    if (!chosenLike && chosen.size() < kShrunkPerRound) chosen.push_back(std::move(raw));
  }
  waiting_.clear();
  return chosen;
}

void Campaign::absorb(const Raw& raw, const Shrunk& shrunk, bool steady) {
  Finding finding{shrunk.scene, {shrunk.kind, traitsOf(shrunk.scene)}, raw.verdict, shrunk.judgement.reason, {}, shrunk.attempts, 1, steady, {}, {}};
  const BaselineEntry* entry =
      knownEntry(options_.baseline, options_.driverName, options_.driverInfo, options_.rulesName, finding.signature);
  if (!steady) finding.signature.traits &= traitsNamed("points lines triangles polygon-line polygon-point");
  if (const Difference* at = find(shrunk.judgement, shrunk.kind)) finding.at = *at;
  const auto same = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& f) { return f.steady == steady && f.signature == finding.signature; });
  if (same != findings_.end()) {
    ++same->seen;
    return;
  }
  if (entry != nullptr) {
    finding.knownRule = entry->rule;
    finding.known = entry->reason;
  }
  if (steady) avoided_.push_back(finding.signature);
  findings_.push_back(std::move(finding));
}

}  // namespace rasterdiff::harness::hunt
