// Hidden rules are found by experiment alone; what cannot be found is said.
#include "harness/infer/infer.hpp"

#include <gtest/gtest.h>

#include "harness/infer/card.hpp"
#include "harness/infer/synthetic.hpp"
#include "rasterizer/choice_table.hpp"
#include "rasterizer/render.hpp"
#include "scene/generators/random_triangles.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::ChoiceInfo;
using rasterizer::Choices;

Inference inferenceOf(const std::string& driver) {
  SubjectOptions options;
  options.driver = driver;
  const Result<std::unique_ptr<Subject>> subject = openSubject(options);
  EXPECT_TRUE(subject.has_value());
  const Result<Inference> inference = infer(**subject, {});
  EXPECT_TRUE(inference.has_value());
  return *inference;
}

class HiddenRules : public testing::TestWithParam<uint64_t> {};

// Every one of the choices is the hidden one, nothing stays open, and fresh scenes are drawn alike.
TEST_P(HiddenRules, AreRecoveredExactly) {
  const rasterizer::Rules hidden = syntheticRules(GetParam());
  const Inference found = inferenceOf("synthetic:" + std::to_string(GetParam()));
  for (const ChoiceInfo& row : rasterizer::choiceTable()) {
    EXPECT_EQ(row.answers[row.get(found.choices)], row.answers[row.get(hidden.choices)]) << row.name;
  }
  EXPECT_EQ(found.choices, hidden.choices);
  EXPECT_EQ(found.openChoices, 0U);
  if (HasFailure()) ADD_FAILURE() << inferenceCard(found);
  for (const uint32_t samples : {1U, 4U}) {
    const Scene scene = randomTriangles({99, 500, Grid::Free, samples, true, 128, false});
    const Result<Frame> expected = rasterizer::render(scene, hidden);
    const Result<Frame> actual = rasterizer::render(scene, inferredRules(found, hidden.limits));
    ASSERT_TRUE(expected && actual);
    EXPECT_EQ(expected->primitive.data, actual->primitive.data);
    EXPECT_EQ(expected->count.data, actual->count.data);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, HiddenRules, testing::Range<uint64_t>(1, 13));

TEST(Infer, FindsWhatADeviceDoesAgainstWhatItAdvertises) {
  const Inference coarse = inferenceOf("mutant:coarse-snap");
  EXPECT_EQ(coarse.choices.subPixelBits, 4U);
  EXPECT_EQ(coarse.advertisedBits, 8U);
  EXPECT_NE(inferenceCard(coarse).find("4 (8 advertised)"), std::string::npos);
  EXPECT_EQ(inferenceOf("mutant:truncating-snap").choices.snapRounding, rasterizer::SnapRounding::TowardZero);
}

TEST(Infer, FindsMovedSamples) {
  const Inference found = inferenceOf("mutant:sample-moved");
  ASSERT_TRUE(found.choices.sampleLocations.has_value());
  EXPECT_EQ(found.choices.sampleLocations->of(4)[0], (rasterizer::SampleTables::Offset{7 * 16, 2 * 16}));
  EXPECT_EQ(found.choices.sampleLocations->of(4)[1], (rasterizer::SampleTables::Offset{14 * 16, 6 * 16}));
}

// Both sides of an edge covered: no owner fits, and no profile pretends that one does.
TEST(Infer, LeavesOpenWhatNoCandidateExplains) {
  const Inference found = inferenceOf("mutant:ties-covered-by-both");
  EXPECT_EQ(found.of(Choice::TieOwner).status, Finding::Status::NoneFits);
  EXPECT_NE(found.openChoices & rasterizer::bitOf(Choice::TieOwner), 0U);
  EXPECT_NE(inferenceCard(found).find("open: none fits"), std::string::npos);
}

TEST(Infer, GivesTheSameAnswerToTheSameSeed) {
  Inference first = inferenceOf("synthetic:5"), second = inferenceOf("synthetic:5");
  first.seconds = second.seconds = 0;
  EXPECT_EQ(inferenceCard(first), inferenceCard(second));
  EXPECT_EQ(inferenceJson(first), inferenceJson(second));
}

}  // namespace
}  // namespace rasterdiff::harness
