// The profile of lavapipe that the rasterizer has built in is found again by experiment alone.
#include "harness/infer/infer.hpp"

#include <gtest/gtest.h>

#include "harness/infer/card.hpp"
#include "rasterizer/choice_table.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;

TEST(Infer, LandsOnTheBuiltInProfileOfLavapipe) {
  const Result<std::unique_ptr<Subject>> subject = openSubject({});
  ASSERT_TRUE(subject.has_value()) << subject.error().what;
  const Result<Inference> found = infer(**subject, {});
  ASSERT_TRUE(found.has_value()) << found.error().what;
  const rasterizer::Choices known = rasterizer::Rules::profile("lavapipe", (*subject)->limits())->choices;
  for (const Choice choice : {Choice::ViewportArithmetic, Choice::SnapRounding, Choice::SnapOrigin, Choice::TieOwner,
                              Choice::SlantedTies, Choice::TieWinding, Choice::ClipArithmetic, Choice::PointArithmetic,
                              Choice::LineArithmetic, Choice::DepthBiasUnit, Choice::DepthBiasSlope, Choice::PlanePositions}) {
    const rasterizer::ChoiceInfo& row = rasterizer::info(choice);
    EXPECT_EQ(row.answers[row.get(found->choices)], row.answers[row.get(known)]) << row.name;
  }
  EXPECT_EQ(found->choices.subPixelBits, (*subject)->limits().subPixelPrecisionBits);
  EXPECT_FALSE(found->choices.sampleLocations.has_value());
  EXPECT_EQ(found->openChoices, 0U);
  if (HasFailure()) ADD_FAILURE() << inferenceCard(*found);
}

}  // namespace
}  // namespace rasterdiff::harness
