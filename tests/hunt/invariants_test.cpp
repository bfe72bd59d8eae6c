// Every invariant holds of the reference, and is broken by a renderer that is wrong in the way it is about.
#include <gtest/gtest.h>

#include <map>

#include "harness/invariants/run.hpp"
#include "tests/harness/program.hpp"
#include "tests/hunt/mutant_subject.hpp"

namespace rasterdiff {
namespace {

using namespace harness::invariants;
using rasterizer::DeliberateError;

/// The reference, its frames changed after the fact.
class Spoiled final : public harness::Subject {
 public:
  using Spoil = std::function<void(const Scene&, Frame&, uint64_t number)>;
  Spoiled(DeliberateError error, Spoil spoil) : reference_(error), spoil_(std::move(spoil)) {}
  std::string name() const override { return "spoiled"; }
  std::string info() const override { return {}; }
  const Limits& limits() const override { return reference_.limits(); }
  Result<Frame> render(const Scene& scene) override {
    Result<Frame> frame = reference_.render(scene);
    if (frame && spoil_) spoil_(scene, *frame, number_++);
    return frame;
  }

 private:
  ReferenceWith reference_;
  Spoil spoil_;
  uint64_t number_ = 0;
};

struct Killer {
  DeliberateError error = DeliberateError::None;
  Spoiled::Spoil spoil{};
};

void dropLast(const Scene&, Frame& frame, uint64_t) {
  for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
    if (frame.primitive.data[i] == 16) frame.primitive.data[i] = frame.count.data[i] = 0;
  }
}

const std::map<std::string_view, Killer> kKillers{
    {"shared-edges-list", {DeliberateError::TiesCoveredByBoth}},
    {"shared-edges-strip", {DeliberateError::TiesCoveredByBoth}},
    {"shared-edges-fan", {DeliberateError::TiesCoveredByNone}},
    {"shared-edges-across-draws", {DeliberateError::TiesCoveredByNone}},
    {"shared-edges-clipped", {DeliberateError::TiesCoveredByBoth}},
    {"complementary-clip-distances", {DeliberateError::ClipDistanceIgnored}},
    {"indexed", {DeliberateError::IndexOffByOne}},
    {"list-strip", {DeliberateError::StripParityIgnored}},
    {"list-fan", {DeliberateError::None, [](const Scene& scene, Frame& frame, uint64_t) {
       if (scene.state.topology == PrimitiveTopology::TRIANGLE_FAN) frame.count.data[0] += 1;
     }}},
    {"scissor-split", {DeliberateError::ScissorOffByOne}},
    {"viewport-index", {DeliberateError::ViewportIndexIgnored}},
    {"repeated", {DeliberateError::None, [](const Scene&, Frame& frame, uint64_t number) {
       if (number % 3 == 2) frame.primitive.data.back() += 1;
     }}},
    {"primitive-order", {DeliberateError::None, dropLast}},
    {"masks-independent", {DeliberateError::None, [](const Scene& scene, Frame& frame, uint64_t) {
       if (scene.target.depthFormat) frame.count.data[0] += 1;
     }}},
};

class Holds : public ::testing::TestWithParam<Invariant> {};

TEST_P(Holds, OfTheReference) {
  Spoiled reference(DeliberateError::None, {});
  const Result<Outcome> outcome = run(GetParam(), reference, 1, 60);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->cases, 60U);
  EXPECT_GT(outcome->samples, 1000U);
  EXPECT_FALSE(outcome->broken) << GetParam().what << ": (" << outcome->broken->x << ", " << outcome->broken->y << ") sample "
                                << outcome->broken->sample << ": " << outcome->broken->what;
}

TEST_P(Holds, NotOfARendererThatIsWrongThere) {
  ASSERT_TRUE(kKillers.contains(GetParam().name)) << "nothing breaks " << GetParam().name;
  const Killer& killer = kKillers.at(GetParam().name);
  Spoiled wrong(killer.error, killer.spoil);
  const Result<Outcome> outcome = run(GetParam(), wrong, 1, 100);
  ASSERT_TRUE(outcome);
  ASSERT_TRUE(outcome->broken);
  EXPECT_FALSE(outcome->broken->what.empty());
  EXPECT_FALSE(outcome->scenes.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Holds, ::testing::ValuesIn(invariants().begin(), invariants().end()), [](const auto& testInfo) {
  std::string name;
  for (const char c : testInfo.param.name) {
    if (c != '-') name += c;
  }
  return name;
});

TEST(InvariantsCommand, SaysWhatHoldsAndWritesWhatDoesNot) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::runProgram({"invariants", "shared-edges-*", "--driver", "mutant:ties-covered-by-both", "--count", "20", "-o", folder.path("o")}).status, 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path("o/shared-edges-list-1.scene.json")));
  EXPECT_EQ(test::runProgram({"invariants", "list-*", "--driver", "mutant:ties-covered-by-both", "--count", "20", "-o", folder.path("o")}).status, 0);
  EXPECT_EQ(test::runProgram({"invariants", "nonsense"}).status, 2);
  EXPECT_EQ(test::runProgram({"invariants", "repeated", "--driver", "fault:crash", "--count", "1"}).status, 4);
}

}  // namespace
}  // namespace rasterdiff
