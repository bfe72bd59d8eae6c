// count_instructions WORKLOAD: draws one fixed workload once on AVX2, the best instruction set that valgrind knows, for
// check.cmake to count the instructions of `drawCoverage`.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include <hwy/targets.h>

#include "rasterizer/kernels/coverage_mask.hpp"
#include "tests/rasterizer/kernels/kernel_families.hpp"

int main(int argc, char** argv) {
  using namespace rasterdiff;
  using namespace rasterdiff::rasterizer;
  constexpr int32_t kWidth = 1024, kHeight = 512;
  const auto families = testing::hardFamilies(kWidth, kHeight);
  const auto family = std::ranges::find(families, std::string_view(argc == 2 ? argv[1] : ""), &testing::Family::name);
  if (family == families.end()) {
    fmt::print(stderr, "count_instructions WORKLOAD: one of\n");
    for (const auto& known : families) fmt::print(stderr, "{}\n", known.name);
    return 2;
  }
  Prng random(1);
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < 20'000) triangles.push_back(family->make(random));
  auto mask = *CoverageMask::create(kWidth, kHeight, 1);
  hwy::SetSupportedTargetsForTest(HWY_AVX2);
  drawCoverage(triangles, mask);
  fmt::print("{} samples covered\n", mask.count());
  return 0;
}
