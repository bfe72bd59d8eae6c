// Collects the families in a fixed order and matches names; what is in a scene is each family's business.
#include "scene/catalogue/catalogue.hpp"

#include "scene/catalogue/build.hpp"

namespace rasterdiff {
namespace {

std::vector<CatalogueEntry> collect() {
  namespace f = families;
  f::Entries entries;
  for (auto* add :
       {f::addFill,          f::addSharedEdge,    f::addStrip,        f::addFan,          f::addIndexed,
        f::addFacing,        f::addClip,          f::addNearPlane,    f::addViewport,     f::addScissor,
        f::addDepth,         f::addVaryings,      f::addSamples,      f::addOverlap,      f::addOrder,
        f::addSliver,        f::addTiny,          f::addFar,          f::addPoint,        f::addPointClip,
        f::addLineRect,      f::addLineBresenham, f::addLineWide,     f::addLineStipple,  f::addLineStrip,
        f::addPolygonMode,   f::addRestart,       f::addDepthClip,    f::addDepthFormat,  f::addDepthBias,
        f::addDepthPrecision, f::addClipDistance, f::addCullDistance, f::addViewports,    f::addSampleMask, f::addShaderMask,
        f::addSampleShading, f::addCentroid,      f::addOffset,       f::addAlphaToCoverage, f::addBuiltIns,
        f::addResolve,       f::addSupersample,   f::addCrowd,        f::addFound,        f::addRandom,       f::addRandomLines,  f::addRandomPoints,
        f::addRandomStrips,  f::addRandomOutlines, f::addRandomCuts,  f::addRandomDepth,
        f::addSampleLocations, f::addLineSmooth, f::addPolygon,       f::addMesh}) {
    add(entries);
  }
  return entries;
}

/// `*` matches any run of characters ('/' too), `?` any one character; linear time but for the last star.
bool matches(std::string_view glob, std::string_view text) {
  size_t g = 0, t = 0, star = std::string_view::npos, resume = 0;
  while (t < text.size()) {
    if (g < glob.size() && glob[g] == '*') {
      star = g++;
      resume = t;
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == text[t])) {
      ++g;
      ++t;
    } else if (star != std::string_view::npos) {
      g = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', g) == std::string_view::npos;
}

}  // namespace

std::span<const CatalogueEntry> catalogue() {
  static const std::vector<CatalogueEntry> entries = collect();
  return entries;
}

std::vector<const CatalogueEntry*> matchCatalogue(std::string_view glob) {
  std::vector<const CatalogueEntry*> found;
  for (const CatalogueEntry& entry : catalogue()) {
    if (matches(glob, entry.name)) found.push_back(&entry);
  }
  return found;
}

}  // namespace rasterdiff
