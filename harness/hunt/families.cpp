// The table of families.
#include <algorithm>

#include "harness/hunt/random_scene.hpp"

namespace rasterdiff::harness::hunt {
namespace {

using enum PrimitiveTopology;
using Topologies = std::vector<PrimitiveTopology>;
using Names = std::vector<std::string_view>;

const Topologies kTriangles{TRIANGLE_LIST, TRIANGLE_LIST, TRIANGLE_STRIP, TRIANGLE_FAN};
const Topologies kEverything{TRIANGLE_LIST, TRIANGLE_LIST, TRIANGLE_STRIP, TRIANGLE_FAN, LINE_LIST, LINE_STRIP, POINT_LIST};

const std::vector<Family>& table() {
  static const std::vector<Family> families{
      {"any", "everything with everything", kEverything,
       {"culling", "polygon-mode", "provoking", "depth", "depth-bias", "depth-clip", "clip-control", "lines", "stipple", "point-size",
        "samples", "samples", "sample-locations", "sample-mask", "shader-mask", "sample-shading", "alpha", "resolve", "scissor", "viewport", "viewports", "target",
        "perspective", "leave", "clip-distances", "cull-distances", "varyings", "varyings", "built-ins", "indices", "topology"},
       {}},
      {"fill", "filled triangles: ties, facing, strips, fans, indices", kTriangles,
       {"culling", "samples", "indices", "target", "perspective", "scissor"}, {}},
      {"line", "lines, and triangles drawn as lines", {LINE_LIST, LINE_LIST, LINE_STRIP, LINE_STRIP, TRIANGLE_LIST},
       {"lines", "stipple", "samples", "leave", "perspective", "varyings", "target", "polygon-mode", "indices"}, {"lines"}},
      {"point", "points, and triangles drawn as points", {POINT_LIST, POINT_LIST, POINT_LIST, TRIANGLE_LIST},
       {"point-size", "samples", "leave", "perspective", "varyings", "built-ins", "polygon-mode", "target"}, {"point-size"}},
      {"clip", "the view volume, clip and cull distances, points behind the eye", kEverything,
       {"clip-distances", "cull-distances", "depth-clip", "clip-control", "perspective", "samples", "varyings", "viewport", "leave"}, {"leave"}},
      {"depth", "depth formats, tests, bias, clamp", kTriangles,
       {"depth", "depth-bias", "depth-clip", "samples", "perspective", "viewport", "polygon-mode", "clip-control", "leave"}, {"depth"}},
      {"values", "varyings and built-ins", kEverything,
       {"varyings", "built-ins", "samples", "sample-shading", "perspective", "provoking", "resolve", "leave", "polygon-mode", "indices", "lines"},
       {"varyings"}},
      {"samples", "masks, shading, alpha and resolve of several samples", kTriangles,
       {"sample-mask", "shader-mask", "sample-locations", "sample-shading", "alpha", "resolve", "varyings", "built-ins", "scissor", "clip-distances", "depth"}, {"samples"}},
      {"state", "views and scissors with everything", kEverything,
       {"scissor", "viewport", "viewports", "samples", "culling", "depth", "polygon-mode", "target", "varyings", "leave"}, {"viewport"}},
  };
  return families;
}

}  // namespace

std::span<const Family> families() { return table(); }

const Family* familyByName(std::string_view name) {
  const auto at = std::find_if(table().begin(), table().end(), [&](const Family& family) { return family.name == name; });
  return at == table().end() ? nullptr : &*at;
}

}  // namespace rasterdiff::harness::hunt
