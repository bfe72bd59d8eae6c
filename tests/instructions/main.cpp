// count_instructions WORKLOAD [values]: draws one fixed workload once on the instruction set that highway.cpp chooses,
// for check.cmake to count the instructions of `drawCoverage`, or with `values` those of `drawValues`.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "tests/rasterizer/kernels/kernel_families.hpp"

namespace {

using namespace rasterdiff;
using namespace rasterdiff::rasterizer;

/// Index, depth and four perspective varyings.
void drawWithValues(std::span<const SnappedTriangle> triangles, int32_t width, int32_t height, Prng& random) {
  const std::vector<ValueKind> kinds(4, ValueKind::Perspective);
  std::vector<float> depth, reciprocalW, values;
  for (size_t i = 0; i < 3 * triangles.size(); ++i) {
    depth.push_back(static_cast<float>(random.unit()));
    reciprocalW.push_back(1.0F / static_cast<float>(1U << random.below(3)));
    for (size_t c = 0; c < kinds.size(); ++c) values.push_back(static_cast<float>(random.unit()));
  }
  auto target = *ValueTarget::create(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 1, {true, false, true, 4});
  const ValueRows<float> carried = carriedValues(reciprocalW, values, kinds.size());
  drawValues({triangles, depth, carried, kinds}, target);
  fmt::print("{} samples drawn\n", std::ranges::count_if(target.primitive, [](uint32_t number) { return number != 0; }));
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int32_t kWidth = 1024, kHeight = 512;
  const auto families = testing::hardFamilies(kWidth, kHeight);
  const auto family = std::ranges::find(families, std::string_view(argc >= 2 ? argv[1] : ""), &testing::Family::name);
  if (family == families.end()) {
    fmt::print(stderr, "count_instructions WORKLOAD [values]: one of\n");
    for (const auto& known : families) fmt::print(stderr, "{}\n", known.name);
    return 2;
  }
  Prng random(1);
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < 20'000) triangles.push_back(family->make(random));
  if (argc == 3 && argv[2] == std::string_view("values")) {
    drawWithValues(triangles, kWidth, kHeight, random);
    return 0;
  }
  auto mask = *CoverageMask::create(kWidth, kHeight, 1);
  drawCoverage(triangles, mask);
  fmt::print("{} samples covered\n", mask.count());
  return 0;
}
