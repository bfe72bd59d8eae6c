// Files that are not what they should be: each is refused with a place and a reason, or it is good enough to be used.
// Run with RASTERDIFF_SANITIZE to see what a crash would only perhaps show.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "harness/compare/blessing.hpp"
#include "harness/profile/profile_file.hpp"
#include "rasterizer/render.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/file/npy.hpp"
#include "scene/file/scene_file.hpp"
#include "scene/mesh/obj.hpp"
#include "scene/polygon/svg_polygon.hpp"
#include "scene/primitive_class.hpp"
#include "tests/fuzz/mangled_text.hpp"

namespace rasterdiff::test {
namespace {

constexpr int kFiles = 20000;

std::string contents(const std::string& path) {
  std::ifstream file(std::string(RASTERDIFF_SOURCE_DIR) + "/" + path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void expectReason(const Error& error, const std::string& text) {
  EXPECT_FALSE(error.what.empty()) << text;
  EXPECT_FALSE(error.where.empty()) << error.what << "\n" << text;
  EXPECT_TRUE(error.code == ErrorCode::BadInput || error.code == ErrorCode::Io) << error.what << "\n" << text;
}

/// How many of the mangled texts `parse` refuses, each with a reason. Both kinds have to be there for the test to mean something.
template <class Parse>
void expectReasons(std::vector<std::string> good, uint64_t seed, const Parse& parse) {
  MangledText mangled(std::move(good), seed);
  int refused = 0, taken = 0;
  for (int i = 0; i < kFiles; ++i) {
    const std::string text = mangled.next();
    if (const auto result = parse(text)) {
      ++taken;
    } else {
      ++refused;
      expectReason(result.error(), text);
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(refused, kFiles / 20);
  EXPECT_GT(taken, kFiles / 100);
}

std::vector<std::string> sceneFiles() {
  std::vector<std::string> files;
  for (const char* name : {"fill/triangle-4x", "varying/eight", "clip-distance/zero-edge", "line-stipple/rect-strip", "depth/less", "viewports/two", "sample-locations/*",
                           "polygon-mode/point-sizes", "depth-bias/*", "point/perspective"}) {
    for (const CatalogueEntry* entry : matchCatalogue(name)) {
      Result<Scene> scene = entry->make();
      if (!scene) continue;
      scene->target.width = std::min(scene->target.width, 32U);
      scene->target.height = std::min(scene->target.height, 32U);
      files.push_back(writeScene(*scene));
      break;
    }
  }
  files.push_back(R"({"name": "m", "target": {"width": 16, "height": 16}, "camera": {"lookAt": {"eye": [4, 2, 0], "target": [5, 2, 0], "up": [0, 1, 0]},
    "perspective": {"fovY": 60, "near": 0.1, "far": 100}}, "draws": [{"space": "world", "positions": [[9, 2, 0], [9, 3, 0], [9, 2, 1]]}]})");
  files.push_back(R"({"target": {"width": 16, "height": 16, "samples": 4}, "scissor": {"x": 1, "y": 1, "width": 9, "height": 9},
    "draws": [{"points": "1,1 12,2 5,12 1,8 12,9", "fillRule": "evenodd", "varyings": [{"name": "position"}]}]})");
  return files;
}

bool isSmall(const Scene& scene) {
  return uint64_t{scene.target.width} * scene.target.height * scene.target.samples <= 4096 && primitiveCount(scene) <= 200;
}

TEST(MangledSceneFile, IsRefusedWithAReasonOrDrawn) {
  const rasterizer::Rules specification = rasterizer::Rules::specification(Limits{});
  const rasterizer::Rules profile = *rasterizer::Rules::profile("lavapipe", Limits{});
  int drawn = 0;
  expectReasons(sceneFiles(), 1, [&](const std::string& text) {
    Result<Scene> scene = parseScene(text, "x.scene.json");
    if (!scene || !isSmall(*scene)) return scene;
    EXPECT_TRUE(validate(*scene)) << text;
    for (const rasterizer::Rules& rules : {specification, profile}) {
      const Result<Frame> frame = rasterizer::render(*scene, rules);
      if (!frame) expectReason({frame.error().code == ErrorCode::NotOffered ? ErrorCode::BadInput : frame.error().code, frame.error().where, frame.error().what, ""}, text);
      drawn += frame ? 1 : 0;
    }
    // What was read can be written and read again.
    const Result<Scene> again = parseScene(writeScene(*scene), "x.scene.json");
    EXPECT_TRUE(again && (scene->allowNonFinite || *again == *scene)) << text;
    return scene;
  });
  EXPECT_GT(drawn, 100);
}

TEST(MangledObj, IsRefusedWithAReasonOrAMesh) {
  const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvt 0 0\nf 1//1 2//1 3//1\nf 1 2 3 4\nf -1 -2 -3\ng a\nf 1/1/1 3/1/1 4/1/1\n";
  expectReasons({cube, "# c\nv 1e3 -2.5 3\nv 0 0 0\nv 1 1 1\ns off\nf 1 2 3\n"}, 2, [](const std::string& text) {
    Result<Mesh> mesh = parseObj(text, "x.obj");
    if (!mesh) return mesh;
    EXPECT_EQ(mesh->normals.size(), mesh->positions.size()) << text;
    EXPECT_EQ(mesh->indices.size() % 3, 0U) << text;
    for (const uint32_t index : mesh->indices) EXPECT_LT(index, mesh->positions.size()) << text;
    return mesh;
  });
}

TEST(MangledSvg, IsRefusedWithAReasonOrPolygons) {
  const std::string other = R"(<svg viewBox="0 0 64 64" width="64" height="64"><!-- c --><g id='a'><polygon fill-rule="evenodd" points=".5.5-1e1 20,30 1 2 3 4"/></g></svg>)";
  expectReasons({contents("examples/star.svg"), other}, 3, [](const std::string& text) { return parseSvgPolygons(text, "x.svg"); });
}

TEST(MangledNpy, IsRefusedWithAReasonOrAMatrix) {
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }";
  header.resize(117, ' ');
  header += '\n';
  std::string file = std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header + std::string(48, 'A');
  expectReasons({file}, 4, [](const std::string& bytes) {
    Result<NpyMatrix> matrix = NpyMatrix::parse(bytes, "x.npy");
    if (matrix && matrix->rows() > 0 && matrix->columns() > 0) static_cast<void>(matrix->at(matrix->rows() - 1, matrix->columns() - 1));
    return matrix;
  });
}

TEST(MangledProfile, IsRefusedWithAReasonOrRules) {
  harness::Profile profile{"found", "llvmpipe", "Mesa", {}, 0};
  const std::string whole = harness::writeProfile(profile);
  profile.openChoices = 5;
  expectReasons({whole, harness::writeProfile(profile)}, 5, [](const std::string& text) {
    Result<harness::Profile> read = harness::parseProfile(text, "x.json");
    EXPECT_TRUE(!read || harness::parseProfile(harness::writeProfile(*read), "x.json")) << text;
    return read;
  });
}

TEST(MangledBaseline, IsRefusedWithAReasonOrEntries) {
  harness::Baseline few = harness::builtInBaseline();
  few.entries.resize(3);
  expectReasons({harness::writeBaseline(few)}, 6, [](const std::string& text) { return harness::parseBaseline(text, "x.json"); });
}

TEST(MangledResults, AreRefusedWithAReasonOrBlessed) {
  const std::string results = R"J({"format": "rasterdiff-results-1", "driver": {"name": "llvmpipe", "info": "Mesa 22.3.6 (LLVM 15.0.6)"}, "rules": "spec",
    "scenes": [{"id": "a/wrong", "verdict": "Differs", "differing": 3, "values": {"depth": {"differing": 0}, "color": {"differing": 2}}}]})J";
  expectReasons({results}, 7, [](const std::string& text) { return harness::bless(text, "x.json", {}, {{}, "because", "", ""}); });
}

}  // namespace
}  // namespace rasterdiff::test
