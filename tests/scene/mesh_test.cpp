// OBJ meshes: what is read, what is refused, and real files of other people.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "scene/camera/projection.hpp"
#include "scene/mesh/obj.hpp"
#include "scene/mesh/obj_check.hpp"

namespace rasterdiff {
namespace {

TEST(Obj, QuadsAreTriangulatedAndVerticesShared) {
  const Result<Mesh> mesh = parseObj("# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "q.obj");
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(mesh->indices.size(), 6u);
  EXPECT_EQ(mesh->normals, (std::vector<std::array<float, 3>>(4, {0, 0, 1})));
}

TEST(Obj, NormalsOfTheFileAreKeptAndSplitVertices) {
  const Result<Mesh> mesh =
      parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 0 -2\nf 1//1 2//1 3//1\nf -3//-1 -1//-1 -2//-1\n", "n.obj");
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->positions.size(), 6u);
  EXPECT_EQ(mesh->normals[0], (std::array<float, 3>{1, 0, 0}));
  EXPECT_EQ(mesh->normals[5], (std::array<float, 3>{0, 0, -2}));
}

TEST(Obj, EverythingThatIsNotAFaceIsLeftOut) {
  const Result<Mesh> mesh = parseObj(
      "mtllib none.mtl\no thing\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvt 0 0\ng a b\ns off\nusemtl red\n"
      "l 1 2\np 1\n\tf  1/1   2/1 3/1  \r\n",
      "x.obj");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().where << mesh.error().what;
  EXPECT_EQ(mesh->indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Obj, FacesMayStandBeforeTheirVertices) {
  const Result<Mesh> mesh = parseObj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "x.obj");
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->indices.size(), 3u);
}

TEST(Obj, MistakesAreAtTheirLineAndColumn) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  struct Bad {
    std::string text, where, what;
  };
  const Bad table[] = {
      {"", "b.obj", "no faces"},
      {vertices, "b.obj", "no faces"},
      {vertices + "f 1 2 4\n", "b.obj:4:7", "index 4 is beyond"},
      {vertices + "f 1 2 0\n", "b.obj:4:7", "index 0"},
      {vertices + "f 1 2 -4\n", "b.obj:4:7", "index -4 but only 3"},
      {vertices + "f 1 2\n", "b.obj:4:1", "a face with 2 vertices"},
      {vertices + "f\n", "b.obj:4:1", "a face with 0 vertices"},
      {vertices + "f 1 2 3.5\n", "b.obj:4:7", "'3.5' is no face vertex"},
      {vertices + "f 1 2 3/\n", "b.obj:4:7", "no face vertex"},
      {vertices + "f 1 2 3/1/1/1\n", "b.obj:4:7", "no face vertex"},
      {vertices + "f 1 2 99999999999\n", "b.obj:4:7", "no face vertex"},
      {vertices + "f 1//1 2//1 3//1\n", "b.obj:4:3", "index 1 is beyond the last of the file's normals"},
      {vertices + "f 1 2 \\\n3\n", "b.obj:4:7", "no face vertex"},
      {"v 0 0\n", "b.obj:1:1", "'v' with 2 numbers"},
      {"v 0 0 nan\n", "b.obj:1:7", "'nan' is no finite number"},
      {"v 0 inf 0\n", "b.obj:1:5", "'inf'"},
      {"v 0 1e39 0\n", "b.obj:1:5", "'1e39'"},
      {"v 0 1,5 0\n", "b.obj:1:5", "'1,5'"},
      {"v 0 0 0x10\n", "b.obj:1:7", "'0x10'"},
      {"vn 0 0 0 0\n", "b.obj:1:1", "'vn' with 4 numbers"},
      {"hello world\n", "b.obj:1:1", "'hello' is no OBJ statement"},
      {"{\"draws\": []}", "b.obj:1:1", "no OBJ statement"},
      {std::string("v\0 0", 4), "b.obj", "NUL"},
      {"v 0 0 0\nv 0 0 0\nv 0 0 0\n  \x01 f\n", "b.obj:4:3", "'?'"},
  };
  for (const Bad& bad : table) {
    const Result<Mesh> mesh = parseObj(bad.text, "b.obj");
    ASSERT_FALSE(mesh.has_value()) << bad.text;
    EXPECT_EQ(mesh.error().where, bad.where) << bad.text;
    EXPECT_NE(mesh.error().what.find(bad.what), std::string::npos) << mesh.error().what;
    EXPECT_EQ(mesh.error().code, ErrorCode::BadInput);
  }
}

TEST(Obj, AMissingFileAndAFolderAreInputOutputErrors) {
  for (const std::string& path : {std::string("no/such.obj"), testing::TempDir()}) {
    const Result<Mesh> mesh = loadObj(path);
    ASSERT_FALSE(mesh.has_value());
    EXPECT_EQ(mesh.error().code, ErrorCode::Io);
    EXPECT_EQ(mesh.error().where, path);
  }
}

/// What Debian's assimp-testmodels holds: accepted with a number of triangles, or refused with a line.
TEST(Obj, RealFilesOfAssimpAreReadOrRefusedWithAReason) {
  const std::filesystem::path models = "/usr/share/assimp/models";
  ASSERT_TRUE(std::filesystem::exists(models)) << "install the package assimp-testmodels";
  const std::map<std::string, std::string> refused{
      {"OBJ/box_UTF16BE.obj", "NUL bytes"}, {"OBJ/number_formats.obj", "'3.1+e2'"},
      {"OBJ/point_cloud.obj", "no faces"},  {"OBJ/testline.obj", "no faces"},
      {"OBJ/testpoints.obj", "no faces"},   {"invalid/empty.obj", "no faces"},
      {"invalid/malformed.obj", "index 0"}, {"invalid/malformed2.obj", "a face with 0 vertices"}};
  std::map<std::string, std::string> found;
  size_t accepted = 0;
  for (const char* folder : {"OBJ", "invalid"}) {
    for (const auto& entry : std::filesystem::directory_iterator(models / folder)) {
      if (entry.path().extension() != ".obj") continue;
      const std::string name = std::string(folder) + "/" + entry.path().filename().string();
      const Result<Mesh> mesh = loadObj(entry.path().string());
      if (!mesh) {
        found[name] = mesh.error().where + ": " + mesh.error().what;
        continue;
      }
      ++accepted;
      EXPECT_EQ(mesh->indices.size() % 3, 0u) << name;
      EXPECT_EQ(mesh->normals.size(), mesh->positions.size()) << name;
      for (uint32_t index : mesh->indices) ASSERT_LT(index, mesh->positions.size()) << name;
    }
  }
  EXPECT_GE(accepted, 15u);
  for (const auto& [name, what] : found) {
    const auto expected = refused.find(name);
    EXPECT_TRUE(expected != refused.end() && what.find(expected->second) != std::string::npos) << name << ": " << what;
  }
  EXPECT_EQ(found.size(), refused.size());
}

TEST(Obj, TheBoxOfAssimpIsTwelveTriangles) {
  const Result<Mesh> mesh = loadObj("/usr/share/assimp/models/OBJ/box.obj");
  ASSERT_TRUE(mesh.has_value()) << mesh.error().what;
  EXPECT_EQ(mesh->indices.size(), 36u);
  EXPECT_EQ(mesh->positions.size(), 8u);
}

TEST(Obj, EveryTruncationOfARealFileIsReadOrRefused) {
  std::ifstream file("/usr/share/assimp/models/OBJ/concave_polygon.obj");
  std::stringstream text;
  text << file.rdbuf();
  const std::string whole = text.str();
  ASSERT_GT(whole.size(), 1000u);
  size_t read = 0;
  for (size_t length = 0; length <= whole.size(); ++length) read += parseObj(whole.substr(0, length), "t").has_value();
  EXPECT_GT(read, 0u);
  EXPECT_LT(read, whole.size());
}

TEST(Bunny, HasItsTrianglesAndUnitNormals) {
  const Result<std::string> path = findBunny();
  ASSERT_TRUE(path.has_value()) << path.error().hint;
  const Result<Mesh> mesh = loadObj(*path);
  ASSERT_TRUE(mesh.has_value()) << mesh.error().where << mesh.error().what;
  EXPECT_EQ(mesh->indices.size(), 3u * 69666);
  EXPECT_EQ(mesh->positions.size(), 34835u);
  for (const auto& [x, y, z] : mesh->normals) EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-6);  // float32 rounding of 1
}

TEST(MeshDraw, TransformsPositionsAndKeepsValuesInModelSpace) {
  const Result<Mesh> mesh = parseObj("v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n", "m.obj");
  ASSERT_TRUE(mesh.has_value());
  glm::dmat4 matrix(1);
  matrix[0][0] = 0.5;
  const Varying asked{.name = "position", .interpolation = Interpolation::flat};
  const Draw draw = meshDraw(*mesh, matrix, {&asked, 1});
  EXPECT_EQ(draw.positions[1], (ClipPosition{1, 0, 0, 1}));
  EXPECT_EQ(draw.varyings[0], (Varying{.name = "position",
                                       .interpolation = Interpolation::flat,
                                       .components = 3,
                                       .values = {0, 0, 0, 2, 0, 0, 0, 2, 0}}));
  EXPECT_TRUE(meshDraw(*mesh, matrix, {}).varyings.empty());
}

}  // namespace
}  // namespace rasterdiff
