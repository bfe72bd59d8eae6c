#include "harness/cli/job_queue.hpp"

#include <map>

namespace rasterdiff::harness::cli {

JobQueue::JobQueue(std::span<const uint32_t> order, const std::function<std::string(uint32_t)>& groupOf) : size_(order.size()) {
  std::map<std::string, size_t> places;
  for (const uint32_t job : order) {
    const size_t place = places.try_emplace(groupOf ? groupOf(job) : std::string(), groups_.size()).first->second;
    if (place == groups_.size()) groups_.emplace_back();
    groups_[place].jobs.push_back(job);
  }
}

size_t JobQueue::choose() const {
  size_t best = groups_.size();
  for (size_t g = 0; g < groups_.size(); ++g) {
    const Group& group = groups_[g];
    if (group.jobs.empty()) continue;
    if (group.workers == 0) return g;
    if (best == groups_.size() || group.jobs.size() * groups_[best].workers > groups_[best].jobs.size() * group.workers) best = g;
  }
  return best;
}

std::optional<uint32_t> JobQueue::next(std::optional<size_t>& group) {
  if (size_ == 0) {
    leave(group);
    return std::nullopt;
  }
  if (!group || groups_[*group].jobs.empty()) {
    leave(group);
    group = choose();
    ++groups_[*group].workers;
  }
  const uint32_t job = groups_[*group].jobs.front();
  groups_[*group].jobs.pop_front();
  --size_;
  return job;
}

void JobQueue::leave(std::optional<size_t>& group) {
  if (group) --groups_[*group].workers;
  group.reset();
}

}  // namespace rasterdiff::harness::cli
