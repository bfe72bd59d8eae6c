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

// Anchors of the Vulkan specification's chapters that this project cites.
const std::set<std::string> kAnchors{
    "drawing-primitive-restart", "drawing-primitive-topologies", "fragops-alpha-coverage", "fragops-covg", "fragops-depth", "fragops-samplemask",
    "fragops-scissor", "interfaces-builtin-variables", "interfaces-builtin", "limits", "limits-lineWidthRange", "limits-pointSizeRange",
    "limits-subPixelPrecisionBits", "limits-subPixelInterpolationOffsetBits", "limits-viewportSubPixelBits", "limits-strictLines",
    "limits-pointSizeGranularity", "limits-lineWidthGranularity",
    "primsrast-depthbias", "primsrast-depthbias-computation", "primsrast-lines", "primsrast-lines-basic", "primsrast-lines-bresenham",
    "primsrast-lines-smooth", "primsrast-lines-stipple", "primsrast-multisampling", "primsrast-multisampling-coverage-mask",
    "primsrast-order", "primsrast-points", "primsrast-polygon-barycentrics", "primsrast-polygonmode", "primsrast-polygons",
    "primsrast-polygons-basic", "primsrast-sampleshading", "primsrast-samplelocations", "renderpass-resolve-operations", "resolve",
    "renderpass", "copies-resolve", "shaders-helper-invocations",
    "shaders-interpolation-decorations", "vertexpostproc-clipping", "vertexpostproc-clipping-shader-outputs",
    "vertexpostproc-coord-transform", "vertexpostproc-flatshading", "vertexpostproc-viewport", "VkViewport", "VkRect2D",
    "VkPipelineRasterizationLineStateCreateInfo"};

TEST(Structure, EveryAnchorIsKnown) {
  static const std::regex kTag(R"(vk:([A-Za-z0-9_-]+))");
  int tags = 0;
  for (const char* room : {"scene", "rasterizer", "vkref", "harness"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(RASTERDIFF_SOURCE_DIR) / room)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".json") continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      for (std::sregex_iterator it(text.begin(), text.end(), kTag), end; it != end; ++it) {
        ++tags;
        EXPECT_EQ(kAnchors.count((*it)[1].str()), 1U) << entry.path().filename() << " cites vk:" << (*it)[1];
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
