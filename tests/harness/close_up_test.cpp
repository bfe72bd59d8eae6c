// Close-ups: every sample of the window once, rings where the verdict is not Same, and nothing outside of the window.
#include "harness/report/close_up.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "harness/compare/compare.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/polygon/svg_markup.hpp"
#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

using rasterizer::Rules;

struct Drawing {
  size_t samples = 0, differ = 0, edges = 0, vertices = 0;
};

double number(const SvgTag& tag, std::string_view name) { return std::atof(std::string(tag.find(name)->value).c_str()); }

Drawing read(const std::string& svg) {
  Drawing drawing;
  const Result<std::vector<SvgTag>> tags = svgTags(svg, "x.svg");
  EXPECT_TRUE(tags);
  for (const SvgTag& tag : tags.value_or(std::vector<SvgTag>{})) {
    if (tag.name == "circle" && tag.find("fill")->value != "none") {
      ++drawing.samples;
      drawing.differ += tag.find("stroke")->value == "#e22030" ? 1U : 0U;
    }
    if (tag.name == "line") {
      for (const char* end : {"x1", "y1", "x2", "y2"}) EXPECT_LT(std::fabs(number(tag, end)), 70) << svg;
      drawing.edges += number(tag, "stroke-width") > 0.05 ? 1U : 0U;
    }
    drawing.vertices += tag.name == "rect" && number(tag, "width") < 0.5 ? 1U : 0U;
  }
  return drawing;
}

struct Compared {
  Scene scene;
  Frame reference, actual;
  harness::SceneResult result;
};

Compared compared(const char* name, rasterizer::DeliberateError error) {
  Compared c{*matchCatalogue(name).at(0)->make(), {}, {}, {}};
  const Rules rules = *Rules::profile("reference", Limits{});
  Rules wrong = rules;
  wrong.error = error;
  c.reference = *rasterizer::render(c.scene, rules);
  c.actual = *rasterizer::render(c.scene, wrong);
  c.result = *harness::compare(c.scene, rules, c.reference, c.actual);
  return c;
}

TEST(CloseUp, ShowsEverySampleOfNinePixelsEachWay) {
  const Compared c = compared("fill/shared-diagonal", rasterizer::DeliberateError::TieOwnerBottomRight);
  const auto focus = harness::focusOf(c.result);
  ASSERT_TRUE(focus);
  const Rules rules = *Rules::profile("reference", Limits{});
  const Drawing drawing = read(harness::closeUp(c.scene, rules, c.reference, c.actual, c.result, *focus));
  EXPECT_EQ(drawing.samples, 81U * c.reference.samples);
  size_t differ = 0;
  for (uint32_t y = focus->y - 4; y <= focus->y + 4; ++y) {
    for (uint32_t x = focus->x - 4; x <= focus->x + 4; ++x) {
      for (uint32_t s = 0; s < c.reference.samples; ++s) differ += c.reference.primitive.at(x, y, s) != c.actual.primitive.at(x, y, s) ? 1U : 0U;
    }
  }
  EXPECT_GT(differ, 0U);
  EXPECT_EQ(drawing.differ, differ);
  EXPECT_GE(drawing.edges, 4U);     // two sides and the diagonal, from both of its triangles
  EXPECT_EQ(drawing.vertices, 2U);  // the corner of the quad, of both
}

TEST(CloseUp, StaysInsideOfTheTarget) {
  const Compared c = compared("fill/one-sample", rasterizer::DeliberateError::None);
  const Rules rules = *Rules::profile("reference", Limits{});
  for (const rasterizer::SampleQuery focus : {rasterizer::SampleQuery{0, 0, 0}, {c.scene.target.width - 1, c.scene.target.height - 1, 0}}) {
    const Drawing drawing = read(harness::closeUp(c.scene, rules, c.reference, c.actual, c.result, focus));
    const uint64_t pixels = uint64_t{std::min(9U, c.scene.target.width)} * std::min(9U, c.scene.target.height);
    EXPECT_EQ(drawing.samples, pixels * c.reference.samples);
    EXPECT_EQ(drawing.differ, 0U);
  }
}

TEST(CloseUp, CutsEdgesThatAreAMillionPixelsLong) {
  const Compared c = compared("far/wide", rasterizer::DeliberateError::None);
  const Rules rules = *Rules::profile("reference", Limits{});
  const std::string svg = harness::closeUp(c.scene, rules, c.reference, c.actual, c.result, {0, 0, 0});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(svg.find("e+"), std::string::npos) << svg;
}

TEST(CloseUp, HasNoFocusWhereNothingDiffers) {
  EXPECT_FALSE(harness::focusOf(compared("fill/triangle-1x", rasterizer::DeliberateError::None).result));
}

TEST(Explain, DrawsTheNeighbourhood) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram({"explain", "fill/shared-diagonal", "12", "12", "--driver", "none", "--svg", folder.path("e.svg")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(read(readAll(folder.path("e.svg"))).samples, 324U);
  EXPECT_EQ(runProgram({"explain", "fill/shared-diagonal", "12", "12", "--driver", "none", "--svg", folder.path("missing/e.svg")}).status, 2);
}

}  // namespace
}  // namespace rasterdiff::test
