// Fragment shader built-ins: where a fragment is, which side it shows, which samples it stands for.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene observed(std::vector<BuiltIn> builtIns, uint32_t samples, bool perspective = false) {
  Scene scene = square(32, samples);
  scene.builtIns = std::move(builtIns);
  draw(scene, {{3.25, 2.5, 0.125, perspective ? 0.5 : 1}, {28.75, 9, 0.875, 1}, {11, 29.125, 0.5, perspective ? 3.0 : 1}});
  return scene;
}

}  // namespace

void addBuiltIns(Entries& entries) {
  Family family(entries, "built-ins");
  for (const uint32_t samples : {1u, 4u}) {
    family.add(fmt::format("frag-coord-{}x", samples), "x and y are the centre's, z the depth, w one over w", {"R22", "R23"},
               [samples] { return observed({BuiltIn::FragCoord}, samples, true); });
    family.add(fmt::format("sample-mask-{}x", samples), "the mask has a bit for every covered sample", {"R16", "R24"},
               [samples] { return observed({BuiltIn::SampleMask}, samples); });
  }
  family.add("frag-coord-depth-range", "z is within the viewport's depth range", {"R2", "R22", "R23"}, [] {
    Scene scene = observed({BuiltIn::FragCoord}, 1);
    scene.viewport.minDepth = 0.75f;
    scene.viewport.maxDepth = 0.25f;
    return scene;
  });
  family.add("front-facing", "both windings, and a strip's", {"R12", "R44"}, [] {
    Scene scene = observed({BuiltIn::FrontFacing}, 1);
    draw(scene, {{30.5, 12.5}, {18.5, 30.5}, {30.5, 30.5}, {28.5, 1.5}, {31.5, 1.5}, {30, 8.5}});
    return scene;
  });
  family.add("front-facing-clockwise", "frontFace CLOCKWISE turns all of them round", {"R12", "R44"}, [] {
    Scene scene = observed({BuiltIn::FrontFacing}, 1);
    draw(scene, {{30.5, 12.5}, {18.5, 30.5}, {30.5, 30.5}});
    scene.state.frontFace = FrontFace::CLOCKWISE;
    return scene;
  });
  family.add("front-facing-lines", "lines are always front-facing", {"R27", "R44"}, [] {
    Scene scene = square(32);
    useLines(scene, LineRasterizationMode::RECTANGULAR);
    scene.state.frontFace = FrontFace::CLOCKWISE;
    scene.builtIns = {BuiltIn::FrontFacing, BuiltIn::FragCoord};
    draw(scene, {{3.5, 4.5, 0.25, 1}, {28.5, 9.5, 0.75, 2}, {28.5, 28.5}, {3.5, 20.5}});
    return scene;
  });
  family.add("front-facing-points", "points are always front-facing", {"R25", "R44"}, [] {
    Scene scene = square(32);
    usePoints(scene, 5);
    scene.builtIns = {BuiltIn::FrontFacing, BuiltIn::PointCoord, BuiltIn::FragCoord};
    draw(scene, {{8.5, 8.5, 0.25, 2}, {20.25, 9.75}, {14, 22.5, 0.75}});
    return scene;
  });
  family.add("front-facing-edges", "a polygon's edges show its side", {"R34", "R44"}, [] {
    Scene scene = observed({BuiltIn::FrontFacing}, 1);
    draw(scene, {{30.5, 12.5}, {18.5, 30.5}, {30.5, 30.5}});
    scene.state.polygonMode = PolygonMode::LINE;
    return scene;
  });
  family.add("clipped-facing", "the sign of the area of the polygon before or after it is cut", {"R3", "R12", "R44"}, [] {
    Scene scene = square(64);
    scene.builtIns = {BuiltIn::FrontFacing};
    drawClip(scene, {{-3, -0.5f, 0.5f, 1}, {2, -0.75f, 0.5f, 1}, {0.25f, 1.75f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1},
                     {0.875f, 0.25f, 0.5f, 1}, {0.75f, 3, -2, -1}});
    return scene;
  }, issue("KhronosGroup/Vulkan-Docs", 320));
  family.add("sample-mask-mask", "the mask of the pipeline and the mask in the shader", {"R24", "R40"}, [] {
    Scene scene = observed({BuiltIn::SampleMask}, 4);
    scene.state.sampleMask = 0x6;
    return scene;
  });
  family.add("sample-id", "each sample's number and place", {"R17", "R19"},
             [] { return observed({BuiltIn::SampleId, BuiltIn::SamplePosition}, 4); });
  family.add("frag-coord-depth-4x", "FragCoord.z where each sample is shaded: the depth at the sample", {"R19", "R22", "R23"}, [] {
    Scene scene = square(8, 4);
    scene.builtIns = {BuiltIn::FragCoord, BuiltIn::SamplePosition};
    drawClip(scene, {{-1, -1, 1, 1}, {1, -1, 0.5f, 1}, {-1, 1, 0.75f, 1}});
    return scene;
  });
  family.add("helper-invocations", "invocations outside of the triangle leave no trace", {"R43"}, [] {
    Scene scene = square(32, 4);
    std::vector<Px> v;
    for (int i = 0; i < 28; ++i) v.insert(v.end(), {{2.0 + i, 3.0 + i}, {2.4 + i, 3.1 + i}, {2.1 + i, 3.7 + i}});
    draw(scene, v);
    addVarying(scene, "smooth", Interpolation::smooth, 1);
    return scene;
  });
}

}  // namespace rasterdiff::families
