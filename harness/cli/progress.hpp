// Progress on stderr while a run takes long: one rewriting line on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>

#include "harness/report/report.hpp"

namespace rasterdiff::harness::cli {

class Progress {
 public:
  explicit Progress(size_t total);
  void done(const SceneEntry& entry);
  void tick();
  void clear();  ///< takes the line away

 private:
  size_t total_, finished_ = 0;
  uint64_t samples_ = 0, failed_ = 0;
  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace rasterdiff::harness::cli
