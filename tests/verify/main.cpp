// verify_kernels COUNT [SEED]: the fast coverage kernel against the oracle on COUNT hard triangles, on every instruction set of
// this machine and for several thread counts. Exit status 1 at the first difference, with the triangles that show it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>
#include <vector>

#include <hwy/targets.h>

#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "tests/rasterizer/kernels/kernel_families.hpp"

namespace {

using namespace rasterdiff;
using namespace rasterdiff::rasterizer;

struct Target {
  uint32_t width = 0, height = 0, samples = 0;
};
/// In turn, most of them small: there the oracle is fast and a wrong sample has nowhere to hide.
constexpr std::array<Target, 10> kTargets{{{97, 61, 1}, {97, 61, 4}, {33, 129, 1}, {65, 9, 16}, {97, 61, 1}, {70, 420, 1},
                                           {130, 40, 8}, {64, 64, 4}, {331, 203, 1}, {60, 300, 4}}};
constexpr size_t kTogether = 4;  // triangles a mask

std::optional<uint64_t> number(const char* text) {
  uint64_t value = 0;
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, value);
  return error == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

int report(const char* what, const char* target, const std::vector<SnappedTriangle>& triangles, uint64_t wrong) {
  fmt::print("{}: {} samples differ on {}\n", what, wrong, target);
  for (const SnappedTriangle& t : triangles)
    fmt::print("  {},{} {},{} {},{}\n", t.v[0].x, t.v[0].y, t.v[1].x, t.v[1].y, t.v[2].x, t.v[2].y);
  return 1;
}

int verifyInstructionSets(uint64_t count, uint64_t seed) {
  Prng random(seed);
  const auto targets = hwy::SupportedAndGeneratedTargets();
  uint64_t done = 0, covered = 0;
  for (size_t turn = 0; done < count; ++turn) {
    const Target& size = kTargets[turn % kTargets.size()];
    const auto families = testing::hardFamilies(static_cast<int32_t>(size.width), static_cast<int32_t>(size.height));
    auto mask = *CoverageMask::create(size.width, size.height, size.samples), expected = mask;
    for (const auto& family : families) {
      for (size_t k = 0; k < 16 && done < count; ++k, done += kTogether) {
        if (done % 100'000 < kTogether) fmt::print(stderr, "\r{} of {} triangles", done, count);
        std::vector<SnappedTriangle> triangles;
        while (triangles.size() < kTogether) triangles.push_back(family.make(random));
        expected.clear();
        drawCoverageOracle(triangles, expected);
        covered += expected.count();
        for (const int64_t target : targets) {
          hwy::SetSupportedTargetsForTest(target);
          mask.clear();
          drawCoverage(triangles, mask);
          if (const auto wrong = mask.differing(expected); wrong != 0)
            return report(fmt::format("{} at {}x{}, {} samples", family.name, size.width, size.height, size.samples).c_str(),
                          hwy::TargetName(target), triangles, wrong);
        }
      }
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  fmt::print(stderr, "\r");
  fmt::print("{} hard triangles, {} covered samples: the kernel equals the oracle on", done, covered);
  for (const int64_t target : targets) fmt::print(" {}", hwy::TargetName(target));
  fmt::print("\n");
  return 0;
}

int verifyThreadCounts(uint64_t count, uint64_t seed) {
  constexpr size_t kEach = 40'000;
  Prng random(seed);
  const auto families = testing::hardFamilies(640, 360);
  for (uint64_t done = 0; done < count; done += kEach) {
    std::vector<SnappedTriangle> triangles;
    while (triangles.size() < std::min<uint64_t>(kEach, count))
      triangles.push_back(families[triangles.size() % 5].make(random));  // the small ones: others would cover everything
    auto one = *CoverageMask::create(640, 360, 4);
    drawCoverage(triangles, one, 1);
    for (const unsigned threads : {2u, 3u, 8u}) {
      auto many = *CoverageMask::create(640, 360, 4);
      drawCoverage(triangles, many, threads);
      if (const auto wrong = many.differing(one); wrong != 0)
        return report("thread count", fmt::format("{} threads", threads).c_str(), {}, wrong);
    }
  }
  fmt::print("the same masks with 1, 2, 3 and 8 threads\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = argc >= 2 ? number(argv[1]) : std::nullopt, seed = argc == 3 ? number(argv[2]) : std::optional<uint64_t>(1);
  if (argc > 3 || !count || !seed) {
    fmt::print(stderr, "verify_kernels COUNT [SEED]: numbers, please, for example\nverify_kernels 10000000\n");
    return 2;
  }
  if (const int failed = verifyInstructionSets(*count, *seed); failed != 0) return failed;
  return verifyThreadCounts(std::max<uint64_t>(*count / 10, 40'000), *seed);
}
