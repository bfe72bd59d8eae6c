// The search finds every deliberate error, and what it finds shrinks to next to nothing.
#include <gtest/gtest.h>

#include <iostream>

#include "harness/hunt/lane.hpp"
#include "harness/hunt/shrink.hpp"
#include "scene/file/scene_file.hpp"
#include "scene/primitive_class.hpp"
#include "tests/hunt/mutant_subject.hpp"

namespace rasterdiff {
namespace rasterizer {

void PrintTo(const DeliberateErrorInfo& mutant, std::ostream* out) { *out << mutant.name; }

}  // namespace rasterizer

namespace {

using namespace harness::hunt;
using harness::Verdict;
using rasterizer::DeliberateErrorInfo;

class HuntedMutant : public ::testing::TestWithParam<DeliberateErrorInfo> {};

TEST_P(HuntedMutant, IsFoundAndShrunk) {
  ReferenceWith mutant(GetParam().error);
  const auto rules = *rasterizer::Rules::profile("reference", mutant.limits());
  const Judge judging = [&](const Scene& scene) { return judge(scene, mutant, rules); };
  LaneOptions options;
  options.family = familyByName("any");
  options.limits = mutant.limits();
  Corpus corpus;
  uint64_t scenes = 0;
  std::vector<Raw> raw;
  for (options.lane = 0; options.lane < 400 && raw.empty(); ++options.lane) {
    LaneResult lane = searchLane(corpus, options, judging);
    for (Kept& kept : lane.kept) corpus.offer(std::move(kept));
    scenes += lane.tally.scenes;
    raw = std::move(lane.raw);
  }
  ASSERT_FALSE(raw.empty()) << "not found in " << scenes << " scenes";
  const Shrunk shrunk = shrink(raw.front().scene, raw.front().signature.kind, judging);
  EXPECT_EQ(shrunk.judgement.verdict, Verdict::Differs);
  EXPECT_NE(find(shrunk.judgement, raw.front().signature.kind), nullptr);
  const uint64_t primitives = primitiveCount(shrunk.scene), pixels = uint64_t{shrunk.scene.target.width} * shrunk.scene.target.height;
  std::cout << "[ HUNT     ] " << GetParam().name << ": " << scenes << " scenes, " << shrunk.attempts << " to shrink, " << primitives
            << " primitive(s), " << shrunk.scene.target.width << " x " << shrunk.scene.target.height << " pixels, " << shrunk.kind << ": "
            << namesOf(traitsOf(shrunk.scene)) << "\n";
  // Most end at one or two primitives in a pixel; what needs a distance (a stipple period, a long line) keeps some.
  EXPECT_LE(primitives, 6U);
  EXPECT_LE(pixels, 128U);
  const Result<Scene> again = parseScene(writeScene(shrunk.scene), "hunt.scene.json");
  ASSERT_TRUE(again) << again.error().what;
  EXPECT_EQ(*again, shrunk.scene);
}

std::vector<DeliberateErrorInfo> mutants() {
  return {rasterizer::deliberateErrors().begin(), rasterizer::deliberateErrors().end()};
}

INSTANTIATE_TEST_SUITE_P(All, HuntedMutant, ::testing::ValuesIn(mutants()), [](const auto& testInfo) {
  std::string name;
  bool capital = true;
  for (const char c : testInfo.param.name) {
    if (c != '-') name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    capital = c == '-';
  }
  return name;
});

}  // namespace
}  // namespace rasterdiff
