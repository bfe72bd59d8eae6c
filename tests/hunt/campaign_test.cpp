// The hunt as a whole: it repeats exactly, knows what is known, survives a driver that does not, and writes what it found.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "harness/hunt/campaign.hpp"
#include "harness/hunt/record.hpp"
#include "scene/file/scene_file.hpp"
#include "tests/harness/program.hpp"
#include "tests/hunt/mutant_subject.hpp"

namespace rasterdiff {
namespace {

using namespace harness::hunt;
using harness::BaselineEntry;
using rasterizer::DeliberateError;
using test::runProgram;

BaselineEntry scissorEntry() {
  return {"mutant", "", "", "scissor/any", {"coverage"}, "R39", "vk:fragops-scissor", "its scissor is too wide", "scissor"};
}

Campaign hunted(DeliberateError error, harness::Baseline baseline, uint64_t lanes) {
  ReferenceWith mutant(error);
  const auto rules = *rasterizer::Rules::profile("reference", generousLimits());
  const Judge judging = [&](const Scene& scene) { return judge(scene, mutant, rules); };
  Campaign campaign({familyByName("any"), 5, generousLimits(), "mutant", "", "reference", std::move(baseline)});
  while (campaign.lanes() < lanes) {
    std::vector<LaneResult> round;
    for (uint32_t lane = 0; lane < kLanesPerRound; ++lane) {
      round.push_back(searchLane(campaign.corpus(), campaign.laneOptions(campaign.lanes() + lane), judging));
    }
    for (LaneResult& lane : round) campaign.absorb(std::move(lane));
    for (const Raw& raw : campaign.toShrink()) campaign.absorb(raw, shrink(raw.scene, raw.signature.kind, judging));
  }
  return campaign;
}

TEST(Hunt, TheReferenceShowsNothing) {
  const Campaign campaign = hunted(DeliberateError::None, {}, 16);
  EXPECT_TRUE(campaign.findings().empty());
  EXPECT_EQ(campaign.tally().scenes, 16U * kScenesPerLane);
  EXPECT_EQ(campaign.tally().differing, 0U);
}

TEST(Hunt, RepeatsExactlyWithTheSameSeed) {
  const Campaign once = hunted(DeliberateError::ScissorOffByOne, {}, 32), again = hunted(DeliberateError::ScissorOffByOne, {}, 32);
  ASSERT_FALSE(once.findings().empty());
  ASSERT_EQ(once.findings().size(), again.findings().size());
  for (size_t i = 0; i < once.findings().size(); ++i) EXPECT_EQ(once.findings()[i].scene, again.findings()[i].scene);
  EXPECT_EQ(once.corpus().pairs(), again.corpus().pairs());
}

TEST(Hunt, FindingsOfOneSignatureAreMerged) {
  const Campaign campaign = hunted(DeliberateError::ScissorOffByOne, {}, 32);
  const auto& findings = campaign.findings();
  for (size_t a = 0; a < findings.size(); ++a) {
    for (size_t b = 0; b < a; ++b) EXPECT_NE(findings[a].signature, findings[b].signature);
  }
}

TEST(Hunt, ABaselineEntryWithAllItsTraitsExplainsAFinding) {
  const Campaign unaware = hunted(DeliberateError::ScissorOffByOne, {}, 32);
  Campaign aware({familyByName("any"), 5, generousLimits(), "mutant", "", "reference", {{scissorEntry()}}});
  for (const Finding& finding : unaware.findings()) {
    Judgement judgement{finding.verdict, finding.reason, {finding.at}, 1, 0, {}};
    aware.absorb({finding.scene, finding.signature, finding.verdict}, {finding.scene, finding.signature.kind, judgement, 1});
  }
  ASSERT_FALSE(aware.findings().empty());
  for (const Finding& finding : aware.findings()) {
    if (planeKind(finding.signature.kind) != "coverage") continue;
    EXPECT_EQ(finding.known, "its scissor is too wide");
    EXPECT_EQ(finding.knownRule, "R39");
  }
}

TEST(Hunt, AnEntryExplainsNeitherOtherPlanesNorOtherDriversNorOtherTraits) {
  const harness::Baseline baseline{{scissorEntry()}};
  const auto known = [&](const char* driver, const char* kind, const char* traits) {
    return knownEntry(baseline, driver, "", "reference", {kind, traitsNamed(traits)}) != nullptr;
  };
  EXPECT_TRUE(known("mutant", "coverage/extra", "triangles scissor"));
  EXPECT_FALSE(known("mutant", "depth", "triangles scissor depth"));
  EXPECT_FALSE(known("other", "coverage/extra", "triangles scissor"));
  EXPECT_FALSE(known("mutant", "coverage/extra", "triangles"));
}

bool has(const Scene& scene, Trait trait) { return traitsOf(scene).test(static_cast<size_t>(trait)); }

/// Of triangles at these places.
bool has(std::vector<ClipPosition> positions, Trait trait, PrimitiveTopology topology = PrimitiveTopology::TRIANGLE_LIST) {
  Scene scene;
  scene.state.topology = topology;
  scene.draws.push_back({.positions = std::move(positions)});
  return has(scene, trait);
}

const ClipPosition a{-1, -1, 0.5F, 1}, b{1, 0, 0.5F, 1}, c{-1, 1, 0.5F, 1};

TEST(Hunt, KnowsTrianglesBetweenTwoWithoutArea) {
  EXPECT_TRUE(has({a, a, a, a, b, c, b, b, c}, Trait::BetweenNoArea));
  EXPECT_TRUE(has({a, a, b, c, c}, Trait::BetweenNoArea, PrimitiveTopology::TRIANGLE_STRIP));
  EXPECT_FALSE(has({a, b, c, a, a, a, b, b, b}, Trait::BetweenNoArea));
  EXPECT_FALSE(has({a, a, a, b, b, b, a, b, c}, Trait::BetweenNoArea));
  EXPECT_FALSE(has({a, b, c, a, b, c, a, b, c}, Trait::BetweenNoArea));
  EXPECT_FALSE(has({a, a, a, b, c, c}, Trait::BetweenNoArea, PrimitiveTopology::LINE_LIST));
}

// Where lavapipe goes wrong: four distances a location, and cull distances that lie across two after clip distances in the first.
TEST(Hunt, KnowsCullDistancesThatLieAcrossTwoLocationsBehindClipDistances) {
  for (uint32_t clips = 0; clips <= 7; ++clips) {
    for (uint32_t culls = 0; clips + culls <= 8; ++culls) {
      Scene scene;
      scene.draws.resize(1);
      scene.draws[0].clipDistanceCount = clips;
      scene.draws[0].cullDistanceCount = culls;
      const bool across = culls > 0 && clips > 0 && clips < 4 && clips + culls > 4;
      EXPECT_EQ(has(scene, Trait::CullBehindClip), across) << clips << " and " << culls;
    }
  }
}

TEST(Hunt, KnowsTheOneOfThreeTrianglesThatIsOne) {
  EXPECT_TRUE(has({a, b, c, a, a, a, b, b, b}, Trait::AloneOfThree));
  EXPECT_TRUE(has({a, a, a, a, b, c, a, a, a}, Trait::AloneOfThree));
  EXPECT_FALSE(has({a, b, c, a, a, a, b, b, c}, Trait::AloneOfThree));
  EXPECT_FALSE(has({a, b, c, a, a, a}, Trait::AloneOfThree));
  EXPECT_FALSE(has({a, b, c, a, a, a, a, a, a, a, a, a}, Trait::AloneOfThree));
  EXPECT_FALSE(has({a, b, c, c, c}, Trait::AloneOfThree, PrimitiveTopology::TRIANGLE_STRIP));
}

TEST(Hunt, NamesLaterOutputsWithAnAlpha) {
  const auto hasOne = [](std::vector<uint32_t> components, std::vector<BuiltIn> builtIns = {}) {
    Scene scene;
    scene.builtIns = std::move(builtIns);
    scene.draws.resize(1);
    for (const uint32_t count : components) scene.draws[0].varyings.push_back({.name = "v", .components = count});
    return has(scene, Trait::SecondAlpha);
  };
  EXPECT_FALSE(hasOne({4}));
  EXPECT_FALSE(hasOne({4, 3}));
  EXPECT_TRUE(hasOne({1, 4}));
  EXPECT_TRUE(hasOne({}, {BuiltIn::FragCoord}));
  EXPECT_FALSE(hasOne({}, {BuiltIn::FrontFacing}));
}

TEST(Hunt, EveryWordOfTheBuiltInBaselineIsATrait) {
  size_t stated = 0;
  for (const BaselineEntry& entry : harness::builtInBaseline().entries) {
    if (entry.when.empty()) continue;
    ++stated;
    const auto words = static_cast<size_t>(std::count(entry.when.begin(), entry.when.end(), ' ')) + 1;
    EXPECT_EQ(traitsNamed(entry.when).count(), words) << entry.when;
  }
  EXPECT_GT(stated, 10U);
}

TEST(HuntRecords, ReadBackWhatWasWritten) {
  ReferenceWith mutant(DeliberateError::HalfPixelShift);
  const auto rules = *rasterizer::Rules::profile("reference", generousLimits());
  const Judge judging = [&](const Scene& scene) { return judge(scene, mutant, rules); };
  LaneOptions options;
  options.family = familyByName("any");
  options.limits = generousLimits();
  const LaneResult lane = searchLane(Corpus(), options, judging);
  ASSERT_FALSE(lane.raw.empty());
  const Result<LaneResult> read = readLaneRecord(recordOf(lane));
  ASSERT_TRUE(read) << read.error().what;
  ASSERT_EQ(read->kept.size(), lane.kept.size());
  ASSERT_EQ(read->raw.size(), lane.raw.size());
  for (size_t i = 0; i < lane.raw.size(); ++i) {
    EXPECT_EQ(read->raw[i].scene, lane.raw[i].scene);
    EXPECT_EQ(read->raw[i].signature, lane.raw[i].signature);
  }
  EXPECT_EQ(read->tally.samples, lane.tally.samples);
  EXPECT_EQ(read->tally.decided.decided, lane.tally.decided.decided);
  EXPECT_FALSE(readLaneRecord("{}"));
  EXPECT_FALSE(readShrunkRecord("nonsense"));
}

TEST(HuntCommand, WritesWhatItFindsAndTheCommandThatRepeatsIt) {
  const test::TemporaryFolder folder;
  const std::string json = folder.path("hunt.json");
  const test::Outcome run = runProgram({"hunt", "--driver", "mutant:half-pixel-shift", "--family", "fill", "--count", "64", "-o", folder.path("found"), "--json", json});
  ASSERT_EQ(run.status, 1) << run.err;
  EXPECT_TRUE(run.lastErrorLine().starts_with("rasterdiff explain ")) << run.err;
  const auto found = nlohmann::json::parse(test::readAll(json)).at("findings");
  ASSERT_FALSE(found.empty());
  const std::string file = found.at(0).at("file");
  EXPECT_TRUE(loadScene(file)) << file;
  EXPECT_TRUE(std::filesystem::exists(found.at(0).at("picture").get<std::string>()));
  EXPECT_LE(found.at(0).at("primitives"), 2);
  EXPECT_EQ(runProgram({"check", file, "--driver", "mutant:half-pixel-shift", "--baseline", "none"}).status, 1);
}

TEST(HuntCommand, ACrashIsFoundShrunkAndWritten) {
  const test::TemporaryFolder folder;
  const test::Outcome run = runProgram({"hunt", "--driver", "fault:crash", "--family", "point", "--count", "32", "--jobs", "1", "-o", folder.path("found")});
  EXPECT_EQ(run.status, 4) << run.out;
  EXPECT_NE(run.out.find("Crashed: crash"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("smallest 1 primitive, 1 x 1 pixels"), std::string::npos) << run.out;
}

TEST(HuntCommand, BadWordsAreRefused) {
  EXPECT_EQ(runProgram({"hunt", "--family", "nonsense"}).status, 2);
  EXPECT_EQ(runProgram({"hunt", "--count", "0"}).status, 2);
  EXPECT_EQ(runProgram({"hunt", "--count", "10", "--seconds", "3"}).status, 2);
  EXPECT_EQ(runProgram({"hunt", "--driver", "mutant:nonsense"}).status, 2);
}

}  // namespace
}  // namespace rasterdiff
