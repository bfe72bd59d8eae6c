// Every specification anchor and every choice that the sources name is in a known list, so that a typo fails.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

// Anchors of the Vulkan specification's chapters that this project may cite: one a line.
std::set<std::string> anchors() {
  std::ifstream file(fs::path(RASTERDIFF_SOURCE_DIR) / "tests/structure/anchors.txt");
  std::set<std::string> names;
  for (std::string line; std::getline(file, line);) names.insert(line);
  return names;
}

TEST(Structure, EveryAnchorIsKnown) {
  static const std::regex kTag(R"(vk:([A-Za-z0-9_-]+))");
  const std::set<std::string> known = anchors();
  int tags = 0;
  for (const char* room : {"scene", "rasterizer", "vkref", "harness"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(RASTERDIFF_SOURCE_DIR) / room)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".json") continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      for (std::sregex_iterator it(text.begin(), text.end(), kTag), end; it != end; ++it) {
        ++tags;
        EXPECT_EQ(known.count((*it)[1].str()), 1U) << entry.path().filename() << " cites vk:" << (*it)[1];
      }
    }
  }
  EXPECT_GT(tags, 50);
}

TEST(Structure, EveryChoiceIsListedWithTheRules) {
  static const std::regex kTag(R"(\[choice:([a-z-]+)\])");
  const auto read = [](const fs::path& path) {
    std::ifstream file(path);
    return std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  };
  const fs::path root = RASTERDIFF_SOURCE_DIR;
  const std::string listed = read(root / "rasterizer/rules.hpp");
  int tags = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "rasterizer")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = read(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), kTag), end; it != end; ++it) {
      ++tags;
      EXPECT_NE(listed.find(it->str()), std::string::npos) << entry.path().filename() << " names " << it->str();
    }
  }
  EXPECT_GT(tags, 5);
}

}  // namespace
