// Polygons drawn as their edges or corners, after clipping and culling. [vk:primsrast-polygonmode]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene wire(PolygonMode mode, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  scene.state.polygonMode = mode;
  draw(scene, {{6.5, 5.5}, {56.5, 12.5}, {20.5, 57.5}, {60.25, 20.75}, {57.5, 60.5}, {30.25, 58.5}});
  return scene;
}

}  // namespace

void addPolygonMode(Entries& entries) {
  Family family(entries, "polygon-mode");
  using enum PolygonMode;
  const std::vector<std::string> rules{"R34"};
  family.add("line-1x", "triangles as three lines each", {"R27", "R34"}, [] { return wire(LINE); });
  family.add("line-4x", "triangles as lines at four samples", {"R27", "R34"}, [] { return wire(LINE, 4); });
  family.add("line-bresenham", "triangles as Bresenham lines", {"R29", "R34"}, [] {
    Scene scene = wire(LINE);
    scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
    return scene;
  });
  family.add("line-wide", "edges three pixels wide", {"R27", "R34"}, [] {
    Scene scene = wire(LINE, 4);
    scene.state.lineWidth = 3;
    return scene;
  });
  family.add("point-1x", "triangles as three points each", {"R25", "R34"}, [] { return wire(POINT); });
  family.add("point-sizes", "corners of their own sizes", {"R25", "R34"}, [] {
    Scene scene = wire(POINT, 4);
    scene.draws[0].pointSizes = {1, 2.5f, 7, 4, 0.5f, 3};
    return scene;
  });
  for (const CullMode cull : {CullMode::FRONT, CullMode::BACK}) {
    family.add(cull == CullMode::FRONT ? "cull-front" : "cull-back", "culling goes before: a culled triangle has no edges",
               {"R13", "R34"}, [cull] {
                 Scene scene = wire(LINE);
                 draw(scene, {{8.5, 40.5}, {14.5, 60.5}, {24.5, 44.5}});
                 draw(scene, {{40.5, 4.5}, {60.5, 4.5}, {50.5, 16.5}});
                 scene.state.cullMode = cull;
                 return scene;
               });
  }
  for (const CullMode cull : {CullMode::NONE, CullMode::FRONT, CullMode::BACK}) {
    const std::string name = cull == CullMode::NONE ? "zero-area" : cull == CullMode::FRONT ? "zero-area-front" : "zero-area-back";
    family.add(name, "a triangle without area is back-facing, and still has edges", {"R12", "R34"}, [cull] {
      Scene scene = square(32);
      scene.state.polygonMode = LINE;
      scene.state.cullMode = cull;
      draw(scene, {{4.5, 4.5}, {28.5, 4.5}, {16.5, 4.5}, {5.5, 9.5}, {5.5, 28.5}, {5.5, 9.5}});
      if (cull != CullMode::BACK) scene.builtIns = {BuiltIn::FrontFacing};
      return scene;
    });
  }
  family.add("clipped", "edges of a cut triangle, those along the planes among them", {"R3", "R34"}, [] {
    Scene scene = square(64);
    scene.state.polygonMode = LINE;
    drawClip(scene, {{-2, -0.5f, 0.5f, 1}, {0.75f, -0.75f, 0.5f, 1}, {0.25f, 1.75f, 0.5f, 1}});
    return scene;
  });
  family.add("corner-outside", "corners outside of a side plane are cut off, however large their points", {"R7", "R34"}, [] {
    Scene scene = square(32);
    scene.state.polygonMode = POINT;
    scene.state.pointSize = 7;
    drawClip(scene, {{-1.05f, -0.9f, 0.5f, 1}, {-0.9f, 0.9f, 0.5f, 1}, {-0.95f, 0.3f, 0.5f, 1}});
    return scene;
  });
  family.add("near-cut", "edges and corners where the near plane and a distance cut", {"R3", "R5", "R34"}, [] {
    Scene scene = square(64);
    scene.state.polygonMode = LINE;
    Draw& d = drawClip(scene, {{-0.8f, -0.5f, -0.5f, 1}, {0.75f, -0.75f, 0.5f, 1}, {0.25f, 0.75f, 0.5f, 1}});
    d.clipDistanceCount = 1;
    d.clipDistances = {1, 1, -0.5f};
    return scene;
  });
  family.add("shared-edge", "the shared edge of two triangles is drawn twice", {"R34", "R50"}, [] {
    Scene scene = square(32);
    scene.state.polygonMode = LINE;
    draw(scene, rectangle(4.5, 4.5, 27.5, 27.5));
    return scene;
  });
  family.add("strip-values", "values along the edges of a strip", {"R21", "R34"}, [] {
    Scene scene = square(32);
    scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
    scene.state.polygonMode = LINE;
    draw(scene, {{3.5, 4.5}, {5.5, 28.5}, {16.5, 3.5}, {18.5, 27.5}, {29.5, 4.5}});
    addVarying(scene, "smooth", Interpolation::smooth, 1);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("point-flat", "a triangle's points have the flat inputs of its provoking vertex", {"R11", "R34"}, [] {
    Scene scene = square(8);
    scene.state.polygonMode = PolygonMode::POINT;
    draw(scene, {{1.5, 1.5}, {6.5, 1.5}, {1.5, 6.5}});
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("biased", "depth bias applies to the edges too", {"R34", "R37", "R38"}, [] {
    Scene scene = wire(LINE);
    useDepth(scene);
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasConstantFactor = 4;
    scene.state.depthBiasSlopeFactor = 1;
    return scene;
  });
}

}  // namespace rasterdiff::families
