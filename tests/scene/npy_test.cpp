// .npy files: what NumPy writes is read, bit by bit; everything else is refused with what is wrong.
#include "scene/file/npy.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

std::string npyOf(const std::string& header, const std::string& data, char major = 1) {
  std::string bytes("\x93NUMPY", 6);
  bytes += major;
  bytes += '\0';
  const std::string padded = header + std::string(63 - (10 + header.size()) % 64, ' ') + "\n";
  bytes += static_cast<char>(padded.size() & 0xff);
  bytes += static_cast<char>(padded.size() >> 8);
  if (major > 1) bytes += std::string(2, '\0');
  return bytes + padded + data;
}

template <class T>
std::string bytesOf(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

std::string header(const std::string& descr, const std::string& shape, const std::string& fortran = "False") {
  return "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}

/// 2 × 3: 1 2 3 / 4 5 6.
void expectOneToSix(const Result<NpyMatrix>& matrix) {
  ASSERT_TRUE(matrix.has_value()) << matrix.error().what;
  ASSERT_EQ(matrix->rows(), 2U);
  ASSERT_EQ(matrix->columns(), 3U);
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(matrix->at(i / 3, i % 3), static_cast<double>(i + 1));
    EXPECT_EQ(matrix->float32(i / 3, i % 3), static_cast<float>(i + 1));
  }
}

TEST(Npy, BothPrecisionsOrdersEndiannessesAndAllVersionsAreRead) {
  const std::string floats = bytesOf({1.F, 2.F, 3.F, 4.F, 5.F, 6.F});
  for (const char major : {'\1', '\2', '\3'}) expectOneToSix(NpyMatrix::parse(npyOf(header("<f4", "(2, 3)"), floats, major), "f"));
  expectOneToSix(NpyMatrix::parse(npyOf(header("<f8", "(2, 3)"), bytesOf({1.0, 2.0, 3.0, 4.0, 5.0, 6.0})), "f"));
  expectOneToSix(NpyMatrix::parse(npyOf(header("<f4", "(2, 3)", "True"), bytesOf({1.F, 4.F, 2.F, 5.F, 3.F, 6.F})), "f"));
  std::string swapped = floats;
  for (size_t i = 0; i < swapped.size(); i += 4) {
    std::swap(swapped[i], swapped[i + 3]);
    std::swap(swapped[i + 1], swapped[i + 2]);
  }
  expectOneToSix(NpyMatrix::parse(npyOf(header(">f4", "(2, 3)"), swapped), "f"));
  expectOneToSix(NpyMatrix::parse(npyOf("{'shape':(2,3),'descr':\"<f4\",'fortran_order':False}", floats), "f"));
}

TEST(Npy, AFloat32KeepsItsBits) {
  const auto nan = std::bit_cast<float>(0x7fc12345U);
  const auto matrix = NpyMatrix::parse(npyOf(header("<f4", "(1, 2)"), bytesOf({nan, -0.F})), "f");
  ASSERT_TRUE(matrix.has_value());
  EXPECT_EQ(std::bit_cast<uint32_t>(matrix->float32(0, 0)), 0x7fc12345U);
  EXPECT_EQ(std::bit_cast<uint32_t>(matrix->float32(0, 1)), 0x80000000U);
}

TEST(Npy, WhatNumpyDoesNotWriteIsRefusedWithWhatIsWrong) {
  const std::string two = bytesOf({1.F, 2.F});
  const std::string good = npyOf(header("<f4", "(1, 2)"), two);
  const struct {
    std::string bytes;
    const char* what;
  } table[] = {{"", "is no .npy file"},
               {"PK\x03\x04", "is no .npy file"},
               {good.substr(0, 8), "ends within its header"},
               {good.substr(0, 40), "ends within its header"},
               {npyOf(header("<f4", "(1, 2)"), two, 4), "version 4.0"},
               {npyOf(header("<i4", "(1, 2)"), two), "holds '<i4'"},
               {npyOf(header("|O", "(1, 2)"), two), "holds '|O'"},
               {npyOf(header("<f4", "(2,)"), two), "has 1 dimensions"},
               {npyOf(header("<f4", "(1, 1, 2)"), two), "has 3 dimensions"},
               {npyOf(header("<f4", "(1, 3)"), two), "is truncated"},
               {npyOf(header("<f4", "(4294967296, 4294967296)"), two), "is truncated"},
               {npyOf(header("<f4", "(1, 1)"), two), "is too long"},
               {npyOf(header("<f4", "(0, 2)"), two), "is too long"},
               {npyOf(header("<f4", "(99999999999999999999, 2)"), two), "header that NumPy does not write"},
               {npyOf(header("<f4", "(-1, 2)"), two), "header that NumPy does not write"},
               {npyOf(header("<f4", "(1, 2)") + "x", two), "header that NumPy does not write"},
               {npyOf("{'descr': '<f4', 'shape': (1, 2), }", two), "header that NumPy does not write"},
               {npyOf("{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (1, 2)}", two),
                "header that NumPy does not write"},
               {npyOf("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (1, 2)}", two),
                "header that NumPy does not write"}};
  for (const auto& [bytes, what] : table) {
    const auto matrix = NpyMatrix::parse(bytes, "f.npy");
    ASSERT_FALSE(matrix.has_value()) << what;
    EXPECT_EQ(matrix.error().where, "f.npy");
    EXPECT_NE(matrix.error().what.find(what), std::string::npos) << matrix.error().what;
    EXPECT_NE(matrix.error().hint.find("numpy.save"), std::string::npos);
  }
}

TEST(Npy, EveryTruncationOfASoundFileIsRefused) {
  const std::string good = npyOf(header("<f8", "(1, 2)"), bytesOf({1.0, 2.0}));
  for (size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(NpyMatrix::parse(good.substr(0, length), "f").has_value()) << length;
}

/// A folder with p.npy in it, and the scene that a file beside it describes.
class NpyScene : public testing::Test {
 protected:
  NpyScene() {
    std::string name = (std::filesystem::temp_directory_path() / "rasterdiff-npy-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~NpyScene() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Result<Scene> scene(const std::string& bytes, const std::string& space, const std::string& more = {}) {
    std::ofstream(folder_ / "p.npy", std::ios::binary) << bytes;
    return parseScene(R"({"target": {"width": 64, "height": 32}, )" + more + R"("draws": [{"space": ")" + space +
                          R"(", "positions": "p.npy"}]})",
                      (folder_ / "s.scene.json").string());
  }
  std::filesystem::path folder_;
};

TEST_F(NpyScene, PositionsEqualThoseWrittenIntoTheSceneFile) {
  const std::string pixels = npyOf(header("<f8", "(3, 3)"), bytesOf({8.5, 8.25, 0.5, 40.5, 9.0, 0.25, 8.0, 20.125, 1.0}));
  const auto listed = parseScene(
      R"({"name": "s", "target": {"width": 64, "height": 32}, "draws": [{"space": "pixels",
          "positions": [[8.5, 8.25, 0.5], [40.5, 9, 0.25], [8, 20.125, 1]]}]})", "s.scene.json");
  const auto read = scene(pixels, "pixels");
  ASSERT_TRUE(read.has_value()) << read.error().what;
  EXPECT_EQ(*read, *listed);
  const auto clip = scene(npyOf(header("<f4", "(1, 4)"), bytesOf({0.1F, -0.2F, 0.3F, 2.F})), "clip");
  ASSERT_TRUE(clip.has_value()) << clip.error().what;
  EXPECT_EQ(clip->draws[0].positions[0], (ClipPosition{0.1F, -0.2F, 0.3F, 2.F}));
}

TEST_F(NpyScene, MistakesNameTheSceneFilesPlaceAndTheArrayWithRowAndColumn) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [&](const Result<Scene>& scene, const char* what) {
    ASSERT_FALSE(scene.has_value()) << what;
    EXPECT_NE(scene.error().where.find("s.scene.json:1:"), std::string::npos) << scene.error().where;
    EXPECT_NE(scene.error().what.find("p.npy"), std::string::npos) << scene.error().what;
    EXPECT_NE(scene.error().what.find(what), std::string::npos) << scene.error().what;
  };
  refused(scene("nonsense", "clip"), "is no .npy file");
  refused(scene(npyOf(header("<f4", "(1, 2)"), bytesOf({1.F, 2.F})), "clip"), "2 columns");
  refused(scene(npyOf(header("<f4", "(0, 2)"), ""), "pixels"), "no rows");
  refused(scene(npyOf(header("<f4", "(1, 4)"), bytesOf({1.F, 2.F, nan, 1.F})), "clip"), "row 0, column 2: nan is not finite");
  refused(scene(npyOf(header("<f8", "(2, 2)"), bytesOf({1.0, 2.0, 1.0, 1e300})), "pixels"), "row 1, column 1");
  const auto let = scene(npyOf(header("<f4", "(1, 4)"), bytesOf({1.F, 2.F, nan, 1.F})), "clip", "\"allowNonFinite\": true, ");
  EXPECT_TRUE(let.has_value());
  std::filesystem::remove(folder_ / "p.npy");
  const auto missing = parseScene(R"({"target": {"width": 4, "height": 4}, "draws": [{"positions": "none.npy"}]})", "s.scene.json");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::Io);
}

}  // namespace
}  // namespace rasterdiff
