// Jobs that wait for a worker, in groups that one worker does best.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rasterdiff::harness::cli {

class JobQueue {
 public:
  /// Without `groupOf` all are one group.
  JobQueue(std::span<const uint32_t> order, const std::function<std::string(uint32_t)>& groupOf);

  [[nodiscard]] size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

  /// The next job of a worker's group, in order. Where that has none left, of the first group without a worker; else of the
  /// group with the most jobs a worker. `group` is what the worker is at, none at first, and what it is at from now on.
  [[nodiscard]] std::optional<uint32_t> next(std::optional<size_t>& group);
  /// A worker of that group is gone.
  void leave(std::optional<size_t>& group);

 private:
  struct Group {
    std::deque<uint32_t> jobs;
    size_t workers = 0;
  };
  [[nodiscard]] size_t choose() const;

  std::vector<Group> groups_;  ///< in the order of their first jobs
  size_t size_ = 0;
};

}  // namespace rasterdiff::harness::cli
