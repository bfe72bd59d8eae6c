// Amber scripts: what they demand is what the reference draws, what Amber cannot say is refused, and their shaders compile.
#include "harness/export/amber_script.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <sstream>

#include "harness/export/amber_limits.hpp"
#include "harness/export/amber_text.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

using harness::AmberScript;
using rasterizer::Rules;

Scene sceneNamed(const std::string& name) { return *matchCatalogue(name).at(0)->make(); }

AmberScript scriptOf(const Scene& scene, const Rules& rules) {
  const Result<AmberScript> script = harness::amberScript(scene, rules, "test");
  EXPECT_TRUE(script) << script.error().where << ": " << script.error().what;
  return script.value_or(AmberScript{});
}

AmberScript underSpecification(const std::string& name) { return scriptOf(sceneNamed(name), Rules::specification(Limits{})); }

/// One number that a script demands.
struct Demand {
  size_t index = 0;  ///< in numbers of four bytes
  std::string comparator, number;
};

std::vector<Demand> demandsOf(const AmberScript& script, const std::string& buffer) {
  std::vector<Demand> demands;
  std::istringstream lines(script.text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string command, name, idx, comparator, number;
    size_t offset = 0;
    if (!(words >> command >> name >> idx >> offset >> comparator) || command != "EXPECT" || name != buffer) continue;
    for (size_t i = offset / 4; words >> number; ++i) demands.push_back({i, comparator, number});
  }
  return demands;
}

/// The lines between `BUFFER name …` and END.
std::vector<std::vector<uint32_t>> rowsOf(const AmberScript& script, const std::string& buffer) {
  std::vector<std::vector<uint32_t>> rows;
  std::istringstream lines(script.text);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("BUFFER " + buffer + " ")) {
      inside = true;
    } else if (inside && line == "END") {
      break;
    } else if (inside) {
      std::istringstream words(line);
      rows.emplace_back();
      for (uint32_t number = 0; words >> number;) rows.back().push_back(number);
    }
  }
  return rows;
}

TEST(AmberScript, DemandsWhatTheReferenceDraws) {
  for (const char* name : {"fill/triangle-1x", "varying/across-draws", "depth/no-write", "varying/provoking-last-strip", "polygon-mode/line-1x"}) {
    const Scene scene = sceneNamed(name);
    const AmberScript script = scriptOf(scene, Rules::specification(Limits{}));
    const Frame frame = *rasterizer::render(scene, Rules::specification(Limits{}));
    const std::vector<Demand> demands = demandsOf(script, "drawn");
    EXPECT_EQ(demands.size(), script.expected) << name;
    EXPECT_EQ(script.expected + script.free, frame.primitive.data.size()) << name;
    EXPECT_GT(script.expected, frame.primitive.data.size() / 2) << name;
    for (const Demand& demand : demands) ASSERT_EQ(demand.number, std::to_string(frame.primitive.data[demand.index])) << name << " " << demand.index;
  }
}

TEST(AmberScript, DemandsTheSamplesOfEachPrimitive) {
  const Scene scene = sceneNamed("fill/shared-diagonal");
  const Rules rules = *Rules::profile("reference", Limits{});
  const AmberScript script = scriptOf(scene, rules);
  EXPECT_EQ(script.free, 0U);
  const Frame frame = *rasterizer::render(scene, rules);
  const size_t pixels = size_t{frame.width} * frame.height;
  std::vector<uint32_t> masks(2 * pixels, 0);
  for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
    if (frame.primitive.data[i] != 0) masks[(frame.primitive.data[i] - 1) * pixels + i / frame.samples] |= 1U << (i % frame.samples);
  }
  const std::vector<Demand> demands = demandsOf(script, "masks");
  ASSERT_EQ(demands.size(), masks.size());
  for (const Demand& demand : demands) ASSERT_EQ(demand.number, std::to_string(masks[demand.index])) << demand.index;
}

TEST(AmberScript, LeavesOutWhatTheSpecificationLeavesOpen) {
  const AmberScript open = underSpecification("fill/shared-diagonal");
  EXPECT_GT(open.free, 0U);  // samples on the diagonal
  EXPECT_EQ((open.expected + open.free) / 4, 2U * 64 * 64);
}

TEST(AmberScript, DemandsTheIntervalsOfValues) {
  const Scene scene = sceneNamed("varying/components-2");
  const AmberScript script = scriptOf(scene, Rules::specification(Limits{}));
  const Frame frame = *rasterizer::render(scene, Rules::specification(Limits{}));
  const std::vector<Demand> demands = demandsOf(script, "drawn0");
  ASSERT_EQ(demands.size(), 2 * script.values);
  ASSERT_GT(script.values, 1000U);
  for (const Demand& demand : demands) {
    const float value = frame.varyings[0].values.data[demand.index / 4 * 2 + demand.index % 4];
    const float bound = std::strtof(demand.number.c_str(), nullptr);
    if (demand.comparator == "GE") {
      ASSERT_GE(value, bound) << demand.index;
    } else {
      ASSERT_EQ(demand.comparator, "LE");
      ASSERT_LE(value, bound) << demand.index;
    }
  }
}

TEST(AmberScript, CarriesPositionsAsBitsAndStripsAsLists) {
  const Scene scene = sceneNamed("strip/zigzag-4x");
  const AmberScript script = scriptOf(scene, Rules::specification(Limits{}));
  const auto positions = rowsOf(script, "positions"), numbers = rowsOf(script, "numbers");
  ASSERT_EQ(positions.size(), 3 * primitiveCount(scene.state, scene.draws[0]));
  ASSERT_EQ(numbers.size(), positions.size());
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(positions[i][0], std::bit_cast<uint32_t>(scene.draws[0].positions[i].x));
  for (size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i][0], i / 3 + 1);
}

TEST(AmberScript, PutsTheProvokingVertexFirst) {
  for (const char* name : {"varying/provoking-last-list", "varying/provoking-last-strip", "varying/provoking-last-fan"}) {
    const Scene scene = sceneNamed(name);
    const AmberScript script = scriptOf(scene, *Rules::profile("reference", Limits{}));
    const Frame frame = *rasterizer::render(scene, *Rules::profile("reference", Limits{}));
    const auto varyings = rowsOf(script, "varying0");
    size_t seen = 0;
    for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
      if (frame.primitive.data[i] == 0) continue;
      ++seen;
      const size_t first = 3 * (frame.primitive.data[i] - 1);
      ASSERT_EQ(varyings[first][0], std::bit_cast<uint32_t>(frame.varyings[0].values.data[i * frame.varyings[0].values.components])) << name;
    }
    EXPECT_GT(seen, 100U) << name;
  }
}

TEST(AmberScript, RefusesWhatAmberCannotSay) {
  const auto refused = [](const char* name, const std::string& field) {
    const Result<AmberScript> script = harness::amberScript(sceneNamed(name), Rules::specification(Limits{}), "test");
    ASSERT_FALSE(script) << name;
    EXPECT_EQ(script.error().code, ErrorCode::BadInput) << name;
    EXPECT_EQ(script.error().where, field) << name;
  };
  refused("scissor/one-pixel", "scissor");
  refused("sample-mask/1x-0", "state.sampleMask");
  refused("shader-mask/4x-6", "state.shaderSampleMask");
  refused("line-bresenham/values", "state.lineRasterizationMode");
  refused("depth/less-4x", "state.depthTestEnable");
  refused("offset/perspective-one-pixel", "varyings");
  refused("built-ins/front-facing-edges", "builtIns");
  Scene culled = sceneNamed("fill/triangle-1x");
  culled.state.cullMode = CullMode::BACK;
  EXPECT_EQ(harness::sayableInAmber(culled).error().where, "state.cullMode");
  Scene large = sceneNamed("fill/triangle-1x");
  large.target.width = large.target.height = 2048;
  EXPECT_EQ(harness::sayableInAmber(large).error().where, "target");
  Scene empty = sceneNamed("fill/triangle-1x");
  empty.draws[0].indices.emplace();
  EXPECT_EQ(harness::amberScript(empty, Rules::specification(Limits{}), "test").error().where, "draws");
}

TEST(AmberScript, WritesFloatsThatItsParserReads) {
  EXPECT_EQ(harness::amberFloat(1), "1.0");
  EXPECT_EQ(harness::amberFloat(-0.1F), "-0.1");
  for (const float value : {1e-45F, -1e-30F, 3.4028235e38F, 0x1.fffffep-1F}) {
    const std::string text = harness::amberFloat(value);
    EXPECT_EQ(text.find_first_not_of("-0123456789."), std::string::npos) << text;
    EXPECT_EQ(std::strtof(text.c_str(), nullptr), value);
  }
}

TEST(AmberScript, HasShadersThatCompile) {
  const TemporaryFolder folder;
  for (const char* name : {"fill/shared-diagonal", "clip-distance/zero-edge", "cull-distance/two", "point/perspective", "varying/flat"}) {
    const std::string text = underSpecification(name).text;
    size_t shaders = 0;
    for (size_t at = text.find("SHADER "); at != std::string::npos; at = text.find("SHADER ", at + 1)) {
      const bool vertex = text.compare(at, 13, "SHADER vertex") == 0;
      const size_t begin = text.find('\n', at) + 1, end = text.find("END\n", begin);
      const std::string path = folder.path("shader");
      writeAll(path, text.substr(begin, end - begin));
      const std::string command = std::string(RASTERDIFF_GLSLANG) + " -V -S " + (vertex ? "vert" : "frag") + " -o " + path + ".spv " + path;
      EXPECT_EQ(std::system((command + " > /dev/null").c_str()), 0) << name << "\n" << text.substr(begin, end - begin);
      ++shaders;
    }
    EXPECT_GE(shaders, 2U) << name;
  }
}

TEST(Export, WritesAScriptAndASceneFile) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"export", "fill/triangle-1x", "--amber", folder.path("a.amber"), "--scene", folder.path("a.scene.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(readAll(folder.path("a.amber")).starts_with("#!amber\n# fill/triangle-1x\n"));
  EXPECT_EQ(runProgram({"explain", folder.path("a.scene.json"), "3", "3", "--driver", "none"}).status, 0);
}

TEST(Export, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const Outcome nothing = runProgram({"export", "fill/triangle-1x"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_EQ(nothing.lastErrorLine(), "rasterdiff export --help");
  const Outcome refused = runProgram({"export", "scissor/one-pixel", "--amber", folder.path("a.amber")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("scissor: Amber cannot say this"), std::string::npos) << refused.err;
  const Outcome unwritable = runProgram({"export", "fill/triangle-1x", "--amber", folder.path("missing/a.amber")});
  EXPECT_EQ(unwritable.status, 2);
}

}  // namespace
}  // namespace rasterdiff::test
