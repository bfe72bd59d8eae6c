// Opening devices: by name, by manifest, and every way in which that can fail.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "vkref/device.hpp"
#include "vkref/drivers.hpp"

namespace rasterdiff::vkref {
namespace {

namespace fs = std::filesystem;

class OpenDevice : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("rasterdiff-drivers-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string manifest(const std::string& text, const std::string& name = "driver.json") {
    const fs::path path = folder_ / name;
    std::ofstream(path) << text;
    return path.string();
  }
  static std::string naming(const std::string& library) {
    return R"({"file_format_version": "1.0.0", "ICD": {"library_path": ")" + library + R"(", "api_version": "1.3.0"}})";
  }
  /// The error of opening `driver`; its text must contain `reason`.
  static void expectRefusal(const std::string& driver, const std::string& reason) {
    const Result<std::unique_ptr<Device>> device = openDevice({driver});
    ASSERT_FALSE(device.has_value()) << driver;
    EXPECT_EQ(device.error().code, ErrorCode::NoDevice);
    EXPECT_NE(device.error().what.find(reason), std::string::npos) << device.error().what;
    EXPECT_FALSE(device.error().hint.empty());
  }

  fs::path folder_;
};

TEST_F(OpenDevice, ByNameSaysWhichDriverItIs) {
  const Result<std::unique_ptr<Device>> device = openDevice({"lavapipe"});
  ASSERT_TRUE(device.has_value()) << device.error().what;
  const DriverInfo& driver = (*device)->driver();
  EXPECT_EQ(driver.name, "llvmpipe");
  EXPECT_NE(driver.info.find("Mesa"), std::string::npos);
  EXPECT_NE(driver.library.find("libvulkan_lvp.so"), std::string::npos);
  EXPECT_EQ((*device)->limits().subPixelPrecisionBits, 8U);
  EXPECT_TRUE((*device)->validationMessages().empty());
}

TEST_F(OpenDevice, ByTheManifestThatANameStandsFor) {
  const Result<std::vector<std::string>> manifests = manifestsOf("swiftshader");
  ASSERT_TRUE(manifests.has_value());
  ASSERT_FALSE(manifests->empty());
  const Result<std::unique_ptr<Device>> device = openDevice({manifests->front()});
  ASSERT_TRUE(device.has_value()) << device.error().what;
  EXPECT_EQ((*device)->driver().manifest, manifests->front());
  EXPECT_NE((*device)->driver().deviceName.find("SwiftShader"), std::string::npos);
  EXPECT_EQ((*device)->limits().subPixelPrecisionBits, 4U);
}

TEST_F(OpenDevice, UnknownNamesAreRefused) { expectRefusal("lavapiep", "unknown driver 'lavapiep'"); }
TEST_F(OpenDevice, EmptyNamesAreRefused) { expectRefusal("", "unknown driver ''"); }
TEST_F(OpenDevice, MissingManifestsAreRefused) { expectRefusal((folder_ / "no.json").string(), "no such file"); }
TEST_F(OpenDevice, FoldersAreRefused) { expectRefusal(folder_.string(), "not a regular file"); }
TEST_F(OpenDevice, EmptyManifestsAreRefused) { expectRefusal(manifest(""), "not valid JSON"); }
TEST_F(OpenDevice, TruncatedManifestsAreRefused) { expectRefusal(manifest(R"({"ICD": {"libr)"), "not valid JSON"); }
TEST_F(OpenDevice, ManifestsOfOtherThingsAreRefused) {
  expectRefusal(manifest("[1, 2]"), "not a driver manifest");
  expectRefusal(manifest(R"({"ICD": 7})"), "not a driver manifest");
  expectRefusal(manifest(R"({"ICD": {"library_path": 7}})"), "not a driver manifest");
  expectRefusal(manifest(R"({"ICD": {"library_path": ""}})"), "empty");
}
TEST_F(OpenDevice, HugeManifestsAreRefused) {
  expectRefusal(manifest(std::string(2 << 20, ' ')), "larger than any driver manifest");
}
TEST_F(OpenDevice, ManifestsWithoutTheirLibraryAreRefused) {
  expectRefusal(manifest(naming("./missing.so")), "cannot be loaded");
  expectRefusal(manifest(naming("librasterdiff-missing.so")), "cannot be loaded");
}
TEST_F(OpenDevice, LibrariesThatAreNoDriverAreRefused) {
  expectRefusal(manifest(naming("libm.so.6")), "not a Vulkan driver");
}
TEST_F(OpenDevice, PathsThatTheLoaderWouldSplitAreRefused) {
  expectRefusal(manifest(naming("libm.so.6"), "a:b.json"), "':'");
}

TEST_F(OpenDevice, TimeoutsMustBePositive) {
  for (double seconds : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Result<std::unique_ptr<Device>> device = openDevice({"lavapipe", false, seconds});
    ASSERT_FALSE(device.has_value());
    EXPECT_EQ(device.error().code, ErrorCode::BadInput);
  }
}

TEST_F(OpenDevice, TheEnvironmentIsPutBack) {
  setenv("VK_DRIVER_FILES", "before", 1);
  unsetenv("VK_LOADER_LAYERS_DISABLE");
  const Result<std::unique_ptr<Device>> device = openDevice({"swiftshader"});
  ASSERT_TRUE(device.has_value()) << device.error().what;
  EXPECT_STREQ(getenv("VK_DRIVER_FILES"), "before");
  EXPECT_EQ(getenv("VK_LOADER_LAYERS_DISABLE"), nullptr);
  unsetenv("VK_DRIVER_FILES");
}

TEST_F(OpenDevice, AMissingValidationLayerIsNamedWithItsPackage) {
  setenv("VK_LAYER_PATH", folder_.c_str(), 1);  // where the loader then looks for layers, and finds none
  const Result<std::unique_ptr<Device>> device = openDevice({"lavapipe", /*validate=*/true});
  unsetenv("VK_LAYER_PATH");
  ASSERT_FALSE(device.has_value());
  EXPECT_EQ(device.error().code, ErrorCode::NoDevice);
  EXPECT_NE(device.error().what.find("validation layer is not installed"), std::string::npos) << device.error().what;
  EXPECT_NE(device.error().hint.find("vulkan-validationlayers"), std::string::npos);
}

TEST_F(OpenDevice, SeveralDriversAreOpenAtTheSameTime) {
  const Result<std::unique_ptr<Device>> first = openDevice({"lavapipe"});
  const Result<std::unique_ptr<Device>> second = openDevice({"swiftshader"});
  ASSERT_TRUE(first.has_value() && second.has_value());
  Scene scene;
  scene.target.width = scene.target.height = 4;
  scene.viewport = {0, 0, 4, 4, 0, 1};
  scene.draws.push_back({{{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}}, {}, {}});
  for (Device* device : {first->get(), second->get(), first->get()}) {
    const Result<Frame> frame = render(scene, *device);
    ASSERT_TRUE(frame.has_value()) << frame.error().what;
    EXPECT_EQ(frame->primitive.at(3, 3, 0), 1U);
  }
}

TEST(ListDrivers, FindsBothSoftwareDriversAndExplainsTheRest) {
  const std::vector<DriverCandidate> candidates = listDrivers();
  for (const char* name : {"lavapipe", "swiftshader"}) {
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const DriverCandidate& c) { return c.name == name && c.usable; });
    ASSERT_NE(found, candidates.end()) << name;
    EXPECT_FALSE(found->driver.name.empty());
    EXPECT_EQ(found->limits.framebufferSampleCounts & 5U, 5U);
    const auto fact = std::find_if(found->facts.begin(), found->facts.end(),
                                   [](const auto& f) { return f.first == "lineWidthRange"; });
    ASSERT_NE(fact, found->facts.end());
    EXPECT_FALSE(fact->second.empty());
  }
  for (const DriverCandidate& candidate : candidates) EXPECT_EQ(candidate.usable, candidate.refusal.empty());
}

}  // namespace
}  // namespace rasterdiff::vkref
