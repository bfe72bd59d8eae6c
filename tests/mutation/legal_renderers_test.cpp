// No false alarms: random legal renderers, each with its own answers to what the specification leaves open, are never
// called wrong. RASTERDIFF_LEGAL_RENDERERS sets how many (a handful by default); a check of one by hand:
// `rasterdiff check --driver legal:SEED --rules spec`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "catalogue_scenes.hpp"
#include "harness/compare/compare.hpp"
#include "rasterizer/legal/legal_rules.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff {
namespace {

using harness::Verdict;
using rasterizer::Rules;

uint64_t howMany() {
  const char* given = std::getenv("RASTERDIFF_LEGAL_RENDERERS");
  return given == nullptr ? 3 : std::strtoull(given, nullptr, 10);
}

// Thousands of primitives each; the full check draws them.
bool isLarge(const Scene& scene) { return scene.name.starts_with("random"); }

TEST(LegalRenderers, AreNeverCalledWrong) {
  for (uint64_t seed = 1; seed <= howMany(); ++seed) {
    const Rules legal = rasterizer::legalRules(seed);
    const Rules specification = Rules::specification(legal.limits);
    uint64_t allowed = 0;
    for (const CatalogueScene& entry : catalogueScenes()) {
      if (isLarge(entry.scene)) continue;
      const Result<Frame> expected = rasterizer::render(entry.scene, specification), actual = rasterizer::render(entry.scene, legal);
      ASSERT_TRUE(expected && actual) << entry.scene.name;
      const Result<harness::SceneResult> result = harness::compare(entry.scene, specification, *expected, *actual);
      ASSERT_TRUE(result) << entry.scene.name;
      EXPECT_NE(result->verdict, Verdict::Differs) << "legal:" << seed << " (" << describe(legal) << ") on " << entry.scene.name
                                                   << ": " << result->reason;
      if (result->verdict == Verdict::Allowed) ++allowed;
    }
    EXPECT_GT(allowed, 50U) << "legal:" << seed << " is hardly another renderer than the reference";
  }
}

TEST(LegalRenderers, AreTheSameEveryTimeAndUnlikeOneAnother) {
  std::set<std::string> answers;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    EXPECT_EQ(describe(rasterizer::legalRules(seed)), describe(rasterizer::legalRules(seed)));
    answers.insert(describe(rasterizer::legalRules(seed)));
  }
  EXPECT_GT(answers.size(), 95U);
}

}  // namespace
}  // namespace rasterdiff
