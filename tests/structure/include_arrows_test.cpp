// The arrows of the architecture: which room may include which.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = RASTERDIFF_SOURCE_DIR;
const std::set<std::string> kRooms{"scene", "rasterizer", "vkref", "harness", "bench"};
const std::map<std::string, std::set<std::string>> kMayInclude{
    {"scene", {"scene"}},
    {"rasterizer", {"rasterizer", "scene"}},
    {"vkref", {"vkref", "scene"}},
    {"harness", {"harness", "rasterizer", "vkref", "scene", "bench"}},
};

template <class Visit>
int forEachInclude(const std::string& room, const Visit& visit) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / room)) {
    const std::string extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".hpp" && extension != ".h") continue;
    ++files;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_search(line, match, kInclude)) visit(fs::relative(entry.path(), kRoot).string(), match[1].str());
    }
  }
  return files;
}

TEST(Structure, RoomsIncludeOnlyAlongTheArrows) {
  for (const auto& [room, allowed] : kMayInclude) {
    const int files = forEachInclude(room, [&, &may = allowed](const std::string& file, const std::string& included) {
      const std::string target = included.substr(0, included.find('/'));
      if (kRooms.count(target) != 0) {
        EXPECT_EQ(may.count(target), 1U) << file << " includes " << included;
      }
    });
    EXPECT_GT(files, 10) << room;
  }
}

TEST(Structure, OnlyTheDriverRoomKnowsVulkan) {
  for (const std::string room : {"scene", "rasterizer", "harness"}) {
    forEachInclude(room, [&](const std::string& file, const std::string& included) {
      EXPECT_EQ(included.rfind("vulkan/", 0), std::string::npos) << file << " includes " << included;
      EXPECT_EQ(included.find("volk"), std::string::npos) << file << " includes " << included;
    });
  }
}

}  // namespace
