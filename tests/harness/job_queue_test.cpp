// Who is given which job next, and which scenes are one group.
#include "harness/cli/job_queue.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "harness/cli/job_groups.hpp"

namespace rasterdiff::harness::cli {
namespace {

std::vector<uint32_t> numbers(uint32_t count) {
  std::vector<uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

TEST(JobQueue, WithoutGroupsTheOrderIsKeptWhoeverAsks) {
  JobQueue queue(std::vector<uint32_t>{7, 3, 9}, {});
  std::optional<size_t> one, other;
  EXPECT_EQ(queue.next(one), 7U);
  EXPECT_EQ(queue.next(other), 3U);
  EXPECT_EQ(queue.next(one), 9U);
  EXPECT_EQ(queue.next(other), std::nullopt);
  EXPECT_TRUE(queue.empty());
}

TEST(JobQueue, AWorkerStaysWithItsGroupAndTakesOneThatNobodyHas) {
  JobQueue queue(numbers(9), [](uint32_t job) { return std::string(1, static_cast<char>('a' + job % 3)); });
  std::optional<size_t> one, other;
  EXPECT_EQ(queue.next(one), 0U);
  EXPECT_EQ(queue.next(other), 1U);
  EXPECT_EQ(queue.next(one), 3U);
  EXPECT_EQ(queue.next(one), 6U);
  EXPECT_EQ(queue.next(one), 2U);  // group c: b has a worker
  EXPECT_EQ(queue.next(other), 4U);
  EXPECT_EQ(queue.next(other), 7U);
  EXPECT_EQ(queue.next(other), 5U);  // helps with c, which is all there is
  EXPECT_EQ(queue.next(one), 8U);
  EXPECT_EQ(queue.next(one), std::nullopt);
}

TEST(JobQueue, WhoHelpsHelpsWhereMostIsLeft) {
  JobQueue queue(numbers(10), [](uint32_t job) { return std::string(job < 3 ? "small" : job < 9 ? "large" : "own"); });
  std::optional<size_t> small, large, own;
  EXPECT_EQ(queue.next(small), 0U);
  EXPECT_EQ(queue.next(large), 3U);
  EXPECT_EQ(queue.next(own), 9U);
  EXPECT_EQ(queue.next(own), 4U);
}

TEST(JobQueue, TheGroupOfALostWorkerIsFreeAgain) {
  JobQueue queue(numbers(6), [](uint32_t job) { return std::string(job < 2 ? "a" : "b"); });
  std::optional<size_t> lost, one;
  EXPECT_EQ(queue.next(lost), 0U);
  EXPECT_EQ(queue.next(one), 2U);
  queue.leave(lost);
  std::optional<size_t> fresh;
  EXPECT_EQ(queue.next(fresh), 1U);
}

TEST(JobQueue, EveryJobIsGivenOnceToAnyNumberOfWorkers) {
  for (size_t workers = 1; workers < 9; ++workers) {
    JobQueue queue(numbers(100), [](uint32_t job) { return std::to_string(job * job % 13); });
    std::vector<std::optional<size_t>> groups(workers);
    std::set<uint32_t> given;
    for (size_t turn = 0; given.size() < 100; turn = (turn * 7 + 3) % workers) {
      const std::optional<uint32_t> job = queue.next(groups[turn]);
      ASSERT_TRUE(job);
      EXPECT_TRUE(given.insert(*job).second);
    }
    EXPECT_EQ(queue.size(), 0U);
  }
}

TEST(JobGroups, WhatCanBeSetWhileDrawingMakesNoGroup) {
  JobGroups groups;
  const auto groupOf = [&](const std::function<void(Scene&)>& change) {
    Job job;
    job.id = job.address = "a/b";
    job.make = [change]() -> Result<Scene> {
      Scene scene;
      scene.target.width = scene.target.height = 8;
      scene.viewport = {0, 0, 8, 8, 0, 1};
      scene.draws.push_back({.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
      change(scene);
      return scene;
    };
    return groups.of(job);
  };
  const std::string plain = groupOf([](Scene&) {});
  EXPECT_EQ(groupOf([](Scene& scene) { scene.state.cullMode = CullMode::BACK; }), plain);
  EXPECT_EQ(groupOf([](Scene& scene) { scene.target.width = 16; }), plain);
  EXPECT_NE(groupOf([](Scene& scene) { scene.target.samples = 4; }), plain);
  EXPECT_NE(groupOf([](Scene& scene) { scene.target.depthFormat = DepthFormat::D32_SFLOAT; }), plain);
  EXPECT_EQ(groupOf([](Scene& scene) { scene.target.width = 0; }), "a/b");  // no scene that can be drawn
}

}  // namespace
}  // namespace rasterdiff::harness::cli
