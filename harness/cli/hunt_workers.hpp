// A hunt's work in processes: lanes and shrinking in workers that keep the driver open; a lane that lost its worker
// again, every scene in a process of its own, so that the scene that did it is known and can be shrunk.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "harness/cli/options.hpp"
#include "harness/hunt/campaign.hpp"
#include "harness/report/report.hpp"

namespace rasterdiff::harness::cli {

class HuntWorkers {
 public:
  explicit HuntWorkers(const HuntOptions& options);

  /// Opens the driver once, to know its name and limits. Error: as openSubject, or DeviceLost, TimedOut.
  [[nodiscard]] Result<RunSubject> introduce() const;

  /// Lanes `first` .. `first + count - 1`, in order; fewer if the deadline passed before one began.
  [[nodiscard]] std::vector<hunt::LaneResult> lanes(const hunt::Campaign& campaign, uint64_t first, uint32_t count,
                                                    std::optional<std::chrono::steady_clock::time_point> deadline);
  /// In the order of `raw`.
  [[nodiscard]] std::vector<hunt::Shrunk> shrink(const std::vector<hunt::Raw>& raw);

  /// Does the scene, alone in a process, show its kind?
  [[nodiscard]] bool isSteady(const hunt::Shrunk& shrunk) const;

  /// Why no more work can be done, or empty.
  [[nodiscard]] const std::string& stopped() const { return stopped_; }

 private:
  [[nodiscard]] hunt::Judgement judgedAlone(const Scene& scene) const;

  const HuntOptions& options_;
  unsigned workers_ = 1;
  std::string stopped_;
};

}  // namespace rasterdiff::harness::cli
