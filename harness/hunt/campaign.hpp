// The whole hunt as plain state: rounds of lanes, what was found, what is shrunk next. Processes and drivers are the
// caller's; absorbing results in the order of their numbers makes every run with one seed the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/compare/baseline.hpp"
#include "harness/hunt/lane.hpp"
#include "harness/hunt/shrink.hpp"

namespace rasterdiff::harness::hunt {

struct Finding {
  Scene scene;  ///< the smallest
  Signature signature;
  Verdict verdict = Verdict::Differs;
  std::string reason;
  Difference at;
  uint32_t attempts = 0;   ///< scenes judged to shrink it
  uint64_t seen = 1;       ///< scenes (of different traits) that shrank to it, or have all of its traits
  bool steady = true;      ///< false: its scene alone, in a new process, does not show it
  std::string knownRule;   ///< of the baseline entry that it is
  std::string known;       ///< its reason; empty: nobody knows it yet
};

/// The entry of `baseline` that explains a finding: a difference in one of its planes, in a scene with all the traits
/// of its `when`. Null: none does. Entries without `when` explain nothing here.
[[nodiscard]] const BaselineEntry* knownEntry(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo,
                                              std::string_view rulesName, const Signature& signature);

struct CampaignOptions {
  const Family* family = nullptr;
  uint64_t seed = 1;
  Limits limits;
  std::string driverName, driverInfo, rulesName;  ///< what the baseline goes by
  Baseline baseline;
};

inline constexpr uint32_t kLanesPerRound = 8;
inline constexpr uint32_t kScenesPerLane = 32;
inline constexpr size_t kShrunkPerRound = 6;

class Campaign {
 public:
  explicit Campaign(CampaignOptions options);

  /// What lane `lane` starts from, until the next round is closed.
  [[nodiscard]] LaneOptions laneOptions(uint64_t lane) const;
  [[nodiscard]] const Corpus& corpus() const { return corpus_; }

  /// In the order of the lanes.
  void absorb(LaneResult lane);
  /// Closes a round: what has to be shrunk now. Scenes with all traits of an earlier finding of their kind are counted
  /// there, and shrunk again only now and then.
  [[nodiscard]] std::vector<Raw> toShrink();
  /// In the order of toShrink. `steady`: the scene shows it alone, too. Of those that do not, one a kind and primitive
  /// is kept: what they need is what was drawn before them.
  void absorb(const Raw& raw, const Shrunk& shrunk, bool steady = true);

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }
  [[nodiscard]] uint64_t lanes() const { return lanes_; }

 private:
  CampaignOptions options_;
  Corpus corpus_;
  Tally tally_;
  uint64_t lanes_ = 0;
  std::vector<Raw> waiting_;
  std::vector<Finding> findings_;
  std::vector<Signature> avoided_;  ///< of the baseline and of findings
};

}  // namespace rasterdiff::harness::hunt
