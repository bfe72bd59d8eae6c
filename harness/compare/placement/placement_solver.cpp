#include "harness/compare/placement/placement_solver.hpp"

#include <bit>
#include <deque>

namespace rasterdiff::harness {
namespace {

constexpr uint64_t kMostRevisions = 4'000'000;
constexpr size_t kMostMinimised = 4096;  // constraints; a larger conflict is narrowed around the vertex that failed

class Solver {
 public:
  Solver(std::span<const size_t> placeCounts, std::span<const TableConstraint> constraints)
      : constraints_(constraints), around_(placeCounts.size()), queued_(constraints.size()) {
    for (const size_t count : placeCounts) {
      domains_.push_back(count == 64 ? ~uint64_t{0} : (uint64_t{1} << count) - 1);
    }
    for (size_t c = 0; c < constraints.size(); ++c) {
      for (const uint32_t v : constraints[c].vertices) around_[v].push_back(c);
      push(c);
    }
  }

  Solution run() {
    if (!propagate()) return {givenUp() ? SolverOutcome::GivenUp : SolverOutcome::Unsolvable, {}};
    size_t vertex = 0;
    while (true) {
      while (vertex < domains_.size() && (std::has_single_bit(domains_[vertex]) || around_[vertex].empty())) ++vertex;
      if (vertex == domains_.size()) break;
      const uint64_t first = domains_[vertex] & (~domains_[vertex] + 1);
      decisions_.push_back({vertex, first, trail_.size()});
      narrow(vertex, first);
      while (!propagate()) {
        if (givenUp()) return {SolverOutcome::GivenUp, {}};
        if (decisions_.empty()) return {SolverOutcome::Unsolvable, {}};
        const Decision last = decisions_.back();
        decisions_.pop_back();
        undoTo(last.trail);
        vertex = last.vertex;
        narrow(last.vertex, domains_[last.vertex] & ~last.place);
      }
    }
    Solution solution;
    for (const uint64_t domain : domains_) solution.places.push_back(static_cast<uint8_t>(std::countr_zero(domain)));
    return solution;
  }

 private:
  struct Decision {
    size_t vertex;
    uint64_t place;
    size_t trail;
  };

  [[nodiscard]] bool givenUp() const { return revisions_ > kMostRevisions; }

  void push(size_t constraint) {
    if (queued_[constraint]) return;
    queued_[constraint] = true;
    queue_.push_back(constraint);
  }

  void narrow(size_t vertex, uint64_t domain) {
    if (domains_[vertex] == domain) return;
    trail_.emplace_back(vertex, domains_[vertex]);
    domains_[vertex] = domain;
    for (const size_t c : around_[vertex]) push(c);
  }

  void undoTo(size_t size) {
    for (; trail_.size() > size; trail_.pop_back()) domains_[trail_.back().first] = trail_.back().second;
    for (const size_t c : queue_) queued_[c] = false;
    queue_.clear();
  }

  // False: some vertex has no place left, or the budget is used up.
  bool propagate() {
    while (!queue_.empty()) {
      if (++revisions_ > kMostRevisions) return false;
      const size_t c = queue_.front();
      queue_.pop_front();
      queued_[c] = false;
      const TableConstraint& constraint = constraints_[c];
      std::array<uint64_t, 3> supported{};
      for (const PlaceTriple& triple : constraint.table->allowed) {
        const std::array<uint64_t, 3> bits{uint64_t{1} << triple[0], uint64_t{1} << triple[1], uint64_t{1} << triple[2]};
        bool possible = true;
        for (size_t i = 0; i < 3; ++i) possible = possible && (domains_[constraint.vertices[i]] & bits[i]) != 0;
        if (!possible) continue;
        for (size_t i = 0; i < 3; ++i) supported[i] |= bits[i];
      }
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t vertex = constraint.vertices[i];
        narrow(vertex, domains_[vertex] & supported[i]);
        if (domains_[vertex] == 0) return false;
      }
    }
    return true;
  }

  std::span<const TableConstraint> constraints_;
  std::vector<std::vector<size_t>> around_;
  std::vector<uint64_t> domains_;
  std::vector<std::pair<size_t, uint64_t>> trail_;
  std::vector<Decision> decisions_;
  std::deque<size_t> queue_;
  std::vector<bool> queued_;
  uint64_t revisions_ = 0;
};

bool unsolvable(std::span<const size_t> placeCounts, std::span<const TableConstraint> constraints) {
  return Solver(placeCounts, constraints).run().outcome == SolverOutcome::Unsolvable;
}

}  // namespace

Solution solvePlacement(std::span<const size_t> placeCounts, std::span<const TableConstraint> constraints) {
  return Solver(placeCounts, constraints).run();
}

std::vector<size_t> conflictOf(std::span<const size_t> placeCounts, std::span<const TableConstraint> constraints) {
  std::vector<size_t> kept(constraints.size());
  for (size_t i = 0; i < kept.size(); ++i) kept[i] = i;
  const auto without = [&](size_t begin, size_t end) {
    std::vector<TableConstraint> rest;
    for (size_t i = 0; i < kept.size(); ++i) {
      if (i < begin || i >= end) rest.push_back(constraints[kept[i]]);
    }
    return rest;
  };
  // Whole runs first, then halves of them, down to single constraints.
  for (size_t run = kept.size() / 2; run >= 1 && kept.size() <= kMostMinimised; run /= 2) {
    for (size_t begin = 0; begin < kept.size();) {
      const size_t end = std::min(begin + run, kept.size());
      if (unsolvable(placeCounts, without(begin, end))) {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(begin), kept.begin() + static_cast<std::ptrdiff_t>(end));
      } else {
        begin = end;
      }
    }
  }
  return kept;
}

}  // namespace rasterdiff::harness
