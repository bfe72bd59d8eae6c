// The catalogue as a whole: names, rules, sizes, and the scenes that must be what they claim.
#include "scene/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "scene/needs.hpp"

namespace rasterdiff {
namespace {

std::string fileText(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

const CatalogueEntry& entry(const std::string& name) {
  const auto found = matchCatalogue(name);
  if (found.size() != 1) throw std::runtime_error("no single scene " + name);
  return *found[0];
}

Scene made(const std::string& name) {
  Result<Scene> scene = entry(name).make();
  EXPECT_TRUE(scene.has_value()) << name;
  return scene.value_or(Scene{});
}

TEST(Catalogue, EveryEntryMakesAValidSceneOfItsName) {
  for (const CatalogueEntry& e : catalogue()) {
    const Result<Scene> scene = e.make();
    ASSERT_TRUE(scene.has_value()) << e.name << ": " << scene.error().where << " " << scene.error().what;
    EXPECT_EQ(scene->name, e.name);
    EXPECT_TRUE(validate(*scene).has_value()) << e.name;
    EXPECT_FALSE(e.what.empty()) << e.name;
  }
}

TEST(Catalogue, HasEveryFamilyAndNoNameTwice) {
  std::map<std::string, size_t> families;
  std::set<std::string> names;
  for (const CatalogueEntry& e : catalogue()) {
    EXPECT_TRUE(names.insert(e.name).second) << e.name;
    ++families[e.name.substr(0, e.name.find('/'))];
  }
  EXPECT_GE(names.size(), 400u);
  const char* const kFamilies[] = {
      "fill",           "shared-edge",     "strip",         "fan",           "indexed",      "facing",
      "clip",           "viewport",        "scissor",       "depth",         "varying",      "samples",
      "overlap",        "sliver",          "tiny",          "far",           "nearplane",    "order",
      "random",         "mesh",            "point",         "point-clip",    "line-rect",    "line-bresenham",
      "line-wide",      "line-stipple",    "line-strip",    "polygon-mode",  "restart",      "depth-clip",
      "depth-format",   "depth-bias",      "clip-distance", "cull-distance", "viewports",    "sample-mask",
      "sample-shading", "depth-precision", "centroid",      "offset",        "built-ins",    "alpha-to-coverage",
      "resolve",        "supersample",     "polygon",       "random-lines",  "random-points", "crowd",
      "found",          "sample-locations", "line-smooth",
      "random-strips",  "random-clip",     "random-edges",  "random-corners", "random-depth", "random-line-strips",
      "shader-mask",    "random-masks",    "random-facing",  "random-scissor",  "random-viewport", "random-distances"};
  for (const char* family : kFamilies) EXPECT_GE(families[family], 3u) << family;
  EXPECT_EQ(families.size(), std::size(kFamilies));
}

TEST(Catalogue, RulesAreThoseOfTheRuleTableAndEachOfThemHasAScene) {
  const std::string table = fileText(RASTERDIFF_SOURCE_DIR "/docs/rules.md");
  std::set<std::string> known, used;
  const std::regex row("\\n\\| (R[0-9]+) \\|");
  for (std::sregex_iterator i(table.begin(), table.end(), row), end; i != end; ++i) known.insert((*i)[1]);
  for (const CatalogueEntry& e : catalogue()) {
    EXPECT_FALSE(e.rules.empty()) << e.name;
    used.insert(e.rules.begin(), e.rules.end());
  }
  EXPECT_EQ(known, used);
}

TEST(Catalogue, LinksLeadToIssuesOfRepositories) {
  const std::regex form("https://github\\.com/[A-Za-z0-9_.-]+/[A-Za-z0-9_.-]+/(issues|pull)/[0-9]+");
  size_t links = 0;
  for (const CatalogueEntry& e : catalogue()) {
    if (e.link.empty()) continue;
    ++links;
    EXPECT_TRUE(std::regex_match(e.link, form)) << e.name << " " << e.link;
  }
  EXPECT_GE(links, 35u);
}

TEST(Catalogue, TargetsAreSmallSaveThoseThatAreAboutSize) {
  for (const CatalogueEntry& e : catalogue()) {
    if (e.name.starts_with("mesh/") || e.name.starts_with("far/")) continue;
    const Scene scene = made(e.name);
    EXPECT_LE(scene.target.width * scene.target.height, 256u * 256) << e.name;
  }
}

TEST(Catalogue, GlobsSelect) {
  EXPECT_EQ(matchCatalogue("*").size(), catalogue().size());
  EXPECT_EQ(matchCatalogue("fill/triangle-?x").size(), 2u);
  EXPECT_EQ(matchCatalogue("mesh/bunny-[14]x").size(), 0u);
  EXPECT_EQ(matchCatalogue("mesh/*").size(), 6u);
  EXPECT_EQ(matchCatalogue("*/*-persp").size(), 15u);
  EXPECT_TRUE(matchCatalogue("").empty());
  EXPECT_TRUE(matchCatalogue("fill").empty());
  EXPECT_TRUE(matchCatalogue("no/such").empty());
}

TEST(Catalogue, ScenesAskForDepthAndValuesOnlyWhereTheyAreAboutThem) {
  for (const char* family :
       {"fill/*", "shared-edge/*", "strip/*", "fan/*", "indexed/*", "facing/*", "sliver/*", "tiny/*", "overlap/*"}) {
    for (const CatalogueEntry* e : matchCatalogue(family)) {
      const SceneNeeds needs = needsOf(made(e->name));
      EXPECT_FALSE(needs.depth) << e->name;
      EXPECT_EQ(needs.varyings, 0u) << e->name;
    }
  }
  for (const CatalogueEntry* e : matchCatalogue("depth/*")) EXPECT_TRUE(needsOf(made(e->name)).depth) << e->name;
  for (const CatalogueEntry* e : matchCatalogue("varying/*")) EXPECT_GT(needsOf(made(e->name)).varyings, 0u) << e->name;
}

TEST(Catalogue, OnlyFamiliesAboutTheViewVolumeAreClipped) {
  for (const char* family : {"fill/*", "shared-edge/*", "strip/*", "fan/*", "indexed/*", "sliver/*", "tiny/*",
                             "depth/*", "varying/*", "samples/*", "overlap/*", "order/*", "scissor/*", "point/*",
                             "line-bresenham/*", "line-wide/*", "line-strip/*", "random-lines/*", "random-points/*",
                             "depth-bias/*", "depth-format/*", "resolve/*", "centroid/*"}) {
    for (const CatalogueEntry* e : matchCatalogue(family)) EXPECT_FALSE(needsClipping(made(e->name))) << e->name;
  }
}

struct ViewVolume {
  size_t visible = 0, crossNear = 0, verticesBehindEye = 0;
};

ViewVolume measure(const Scene& scene) {
  ViewVolume result;
  const Draw& draw = scene.draws.at(0);
  for (const ClipPosition& p : draw.positions) result.verticesBehindEye += p.w <= 0;
  const std::vector<uint32_t>& indices = draw.indices.value();
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    unsigned all = 63, any = 0;
    for (size_t k = 0; k < 3; ++k) {
      const ClipPosition& p = draw.positions[indices[i + k]];
      const unsigned out = (p.x < -p.w ? 1u : 0u) | (p.x > p.w ? 2u : 0u) | (p.y < -p.w ? 4u : 0u) |
                           (p.y > p.w ? 8u : 0u) | (p.z < 0 ? 16u : 0u) | (p.z > p.w ? 32u : 0u);
      all &= out;
      any |= out;
    }
    if (all != 0) continue;
    ++result.visible;
    if ((any & 16u) != 0) ++result.crossNear;
  }
  return result;
}

TEST(Catalogue, TheBunnyIsWhollyInView) {
  const Scene scene = made("mesh/bunny-1x");
  EXPECT_FALSE(needsClipping(scene));
  EXPECT_TRUE(needsPerspective(scene));
  EXPECT_TRUE(scene.state.depthTestEnable && scene.state.depthWriteEnable);
  EXPECT_EQ(measure(scene).visible, 69666u);
  EXPECT_EQ(made("mesh/bunny-4x").target.samples, 4u);
  EXPECT_EQ(needsOf(made("mesh/bunny-depth-1x")).varyings, 0u);
}

TEST(Catalogue, TheNearBunnyCrossesTheNearPlaneAndReachesBehindTheEye) {
  const ViewVolume view = measure(made("mesh/bunny-near-1x"));
  EXPECT_GT(view.crossNear, 250u);
  EXPECT_GT(view.verticesBehindEye, 5000u);
  EXPECT_GT(view.visible, 30000u);
}

}  // namespace
}  // namespace rasterdiff
