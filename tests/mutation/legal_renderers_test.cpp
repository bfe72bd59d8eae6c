// No false alarms: random legal renderers, each with its own answers to what the specification leaves open, are never
// called wrong. RASTERDIFF_LEGAL_RENDERERS sets how many (a handful by default); a check of one by hand:
// `rasterdiff check --driver legal:SEED --rules spec`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "catalogue_scenes.hpp"
#include "harness/compare/compare.hpp"
#include "harness/invariants/run.hpp"
#include "harness/subject.hpp"
#include "rasterizer/legal/legal_rules.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"

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

// Each of these seeds was once called wrong: triangles so flat that their side depends on the rounding, drawn as corners.
TEST(LegalRenderers, AreNotCalledWrongOnFlatTrianglesDrawnAsCorners) {
  for (const uint64_t seed : {5U, 18U}) {
    const Rules legal = rasterizer::legalRules(seed), specification = Rules::specification(legal.limits);
    const Result<Scene> scene = matchCatalogue("random-corners/4x").at(0)->make();
    ASSERT_TRUE(scene);
    const Result<Frame> expected = rasterizer::render(*scene, specification), actual = rasterizer::render(*scene, legal);
    ASSERT_TRUE(expected && actual);
    const Result<harness::SceneResult> result = harness::compare(*scene, specification, *expected, *actual);
    ASSERT_TRUE(result);
    EXPECT_NE(result->verdict, Verdict::Differs) << "legal:" << seed << ": " << result->reason;
  }
}

// A vertex of a mesh on a sample has one owner, whatever the rule for ties.
TEST(LegalRenderers, KeepWhatHoldsWithoutAReference) {
  for (const uint64_t seed : {2U, 7U, 14U}) {
    harness::SubjectOptions options;
    options.driver = "legal:" + std::to_string(seed);
    const Result<std::unique_ptr<harness::Subject>> subject = harness::openSubject(options);
    ASSERT_TRUE(subject);
    for (const harness::invariants::Invariant& invariant : harness::invariants::ownershipInvariants()) {
      const auto outcome = harness::invariants::run(invariant, **subject, 1, 8);
      ASSERT_TRUE(outcome) << invariant.name;
      EXPECT_FALSE(outcome->broken) << "legal:" << seed << ", " << invariant.name;
    }
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
