// The smallest scenes of differences that the search (`hunt`) found in a driver: a pixel or two each, the numbers as the
// shrinking left them.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Varying one(const std::string& name, Interpolation interpolation, std::vector<float> values) {
  return {.name = name, .interpolation = interpolation, .components = 1, .values = std::move(values)};
}

Scene pixel(PrimitiveTopology topology, std::vector<ClipPosition> vertices, uint32_t samples = 1) {
  Scene scene = square(1, samples);
  scene.state.topology = topology;
  drawClip(scene, std::move(vertices));
  return scene;
}

Scene stippled(PrimitiveTopology topology, uint16_t pattern, std::vector<ClipPosition> vertices) {
  Scene scene = pixel(topology, std::move(vertices));
  scene.state.stippledLineEnable = true;
  scene.state.lineStipplePattern = pattern;
  return scene;
}

Scene outlined(PolygonMode mode, std::vector<ClipPosition> vertices, uint32_t samples = 1) {
  Scene scene = pixel(PrimitiveTopology::TRIANGLE_LIST, std::move(vertices), samples);
  scene.state.polygonMode = mode;
  return scene;
}

Scene biased(Scene scene, float constant, float slope) {
  useDepth(scene, CompareOp::ALWAYS);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = constant;
  scene.state.depthBiasSlopeFactor = slope;
  return scene;
}

void addLines(Family& family) {
  using enum PrimitiveTopology;
  family.add("stipple-strip-built-ins", "the second segment of a stippled strip is drawn in the same places whatever the shader reads",
             {"R32", "R49"}, [] {
               Scene scene = stippled(LINE_STRIP, 0x1C47, {{-1, -0.5625f, 0.5f, 1}, {-1, -0.25f, 0.5f, 1}, {1, -0.3125f, 0.5f, 1}});
               scene.viewport = {0, -11, 1, 32, 0, 1};
               scene.builtIns = {BuiltIn::SamplePosition};
               return scene;
             });
  family.add("stipple-viewport", "a stippled line in viewport 1, where the scissor of viewport 0 is elsewhere", {"R32", "R39"}, [] {
    Scene scene = stippled(LINE_LIST, 0xFFFE, {{-1, 0, 0, 1}, {3, 0, 0, 1}});
    scene.draws[0].viewportIndex = 1;
    scene.scissor = Rect2D{0, 7, 1, 1};
    scene.furtherViewports = {{{-1, 0, 4, 1, 0, 1}}};
    return scene;
  });
  family.add("stipple-perspective", "an input in perspective along a stippled line", {"R21", "R27", "R32"}, [] {
    Scene scene = stippled(LINE_LIST, 0x7FFE, {{-0.9166667f, 0.083333336f, 0, 1}, {-1.5f, 0.33333334f, 0, 2}});
    scene.viewport = {-2, -13, 24, 24, 0, 1};
    scene.draws[0].varyings = {one("smooth", Interpolation::smooth, {0, -1})};
    return scene;
  });
  family.add("cut-line-noperspective", "a constant along a line that is cut behind the eye", {"R9", "R27"}, [] {
    Scene scene = pixel(LINE_LIST, {{1, 1, 0.5f, 1}, {-1, -3, -0.5f, -1}});
    scene.draws[0].varyings = {one("noperspective", Interpolation::noperspective, {1, 1})};
    return scene;
  });
  family.add("line-over-tile-4x", "a level line, half above and half below a row that drivers may begin a tile with", {"R17", "R27"}, [] {
    Scene scene = target(4, 66, 4);
    useLines(scene, LineRasterizationMode::RECTANGULAR);
    draw(scene, {{1, 64}, {3, 64}});
    return scene;
  });
  family.add("smooth-line-reversed-clamp", "the depth of a smooth line, clamped to a reversed depth range", {"R2", "R33", "R38"}, [] {
    Scene scene = pixel(LINE_LIST, {{-0.5f, -1, 3, 1}, {-0.5f, 1, 0.5f, 1}});
    scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR_SMOOTH;
    scene.viewport.minDepth = 0.75f;
    scene.viewport.maxDepth = 0.25f;
    useDepth(scene, CompareOp::LESS);
    scene.state.depthClampEnable = true;
    return scene;
  });
  family.add("smooth-line-shader-mask", "a smooth line whose shader masks every sample out", {"R33", "R40"}, [] {
    Scene scene = pixel(LINE_LIST, {{-1, 0, 0, 1}, {1, 0, 0, 1}});
    scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR_SMOOTH;
    scene.state.shaderSampleMask = ShaderSampleMask::CONSTANT;
    scene.draws[0].shaderSampleMaskBits = 0;
    return scene;
  });
  family.add("line-over-viewport-4x", "the viewport does not cut the width of lines, at four samples either", {"R2", "R27"}, [] {
    Scene scene = pixel(LINE_LIST, {{-0.75f, 1, 0.5f, 1}, {-0.625f, 1, 0.5f, 1}}, 4);
    scene.viewport = {-2, -4, 16, 4, 0, 1};
    return scene;
  });
}

void addPoints(Family& family) {
  using enum PrimitiveTopology;
  family.add("point-coord-small", "where a point below one pixel is drawn, its coordinates are those of its size", {"R25"}, [] {
    Scene scene = pixel(POINT_LIST, {{1, 1, 0, 1}});
    scene.state.pointSize = 0.125f;
    scene.builtIns = {BuiltIn::PointCoord};
    return scene;
  });
  family.add("points-outside-viewports", "points outside of a side plane, in viewport 1", {"R7", "R49"}, [] {
    Scene scene = square(8);
    scene.state.topology = POINT_LIST;
    scene.state.pointSize = 3;
    drawClip(scene, {{3, 5, 0, 1}});
    scene.furtherViewports = {{scene.viewport}};
    scene.draws[0].viewportIndex = 1;
    return scene;
  });
  family.add("point-values", "a point's fragments have its vertex's data: nothing is interpolated", {"R25"}, [] {
    Scene scene = target(3, 1);
    scene.state.topology = POINT_LIST;
    const float w[] = {0.93314356f, 0.13288045f, 1.7139955f};
    drawClip(scene, {{w[0] * -2 / 3, 0, 0, w[0]}, {0, 0, 0, w[1]}, {w[2] * 2 / 3, 0, 0, w[2]}});
    scene.draws[0].varyings = {one("smooth", Interpolation::smooth, {-4.859337f, 4.9850955f, -1.75f}),
                               one("noperspective", Interpolation::noperspective, {-4.859337f, 4.9850955f, -1.75f})};
    return scene;
  });
}

void addOutlines(Family& family) {
  using enum PolygonMode;
  family.add("edges-bresenham-4x", "a Bresenham edge of a polygon has all samples of its pixels", {"R31", "R34"}, [] {
    Scene scene = outlined(LINE, {{-0.5f, -0.25f, 0, 1}, {0.5f, 0.25f, 0, 1}, {0, 0.5f, 0, 1}}, 4);
    scene.target.width = scene.target.height = 8;
    scene.viewport = {0, 0, 8, 8, 0, 1};
    scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;
    return scene;
  });
  family.add("edges-before-depth", "two edges of one triangle in a pixel, nearer and farther: they come in any order", {"R34", "R38", "R50"}, [] {
    Scene scene = outlined(LINE, {{-1, -1, 1, 1}, {1, 1, 1, 1}, {1, 1, 0, 1}});
    useDepth(scene, CompareOp::LESS_OR_EQUAL);
    return scene;
  });
  family.add("edges-culled-apart", "a back-facing triangle whose corner is just inside of the view volume: no edge in view is culled", {"R3", "R13", "R34"}, [] {
    Scene scene = outlined(LINE, {{-17, 3, 0, 1}, {-0.99999976f, 0, 0, 1}, {7, -1, 0, 1}});
    scene.state.cullMode = CullMode::FRONT;
    return scene;
  });
  family.add("edges-behind-eye-culled", "a triangle with a vertex behind the eye: what of it is in view is culled by how it turns there", {"R12", "R13", "R34"}, [] {
    Scene scene = outlined(LINE, {{7, -1, 0.5f, 1}, {-1.5f, -1, -0.5f, -1}, {1, 0.75f, 0.5f, 1}});
    scene.target.width = scene.target.height = 4;
    scene.viewport = {0, 0, 4, 4, 0, 1};
    scene.state.cullMode = CullMode::FRONT;
    return scene;
  });
  family.add("corner-values", "a corner of a triangle without area has its vertex's data", {"R25", "R34"}, [] {
    Scene scene = outlined(POINT, {{-1, -1, 0, 1}, {-1, -1, 0, 1}, {14.583162f, 14.583162f, 0, 14.583162f}});
    scene.draws[0].varyings = {one("smooth", Interpolation::smooth, {0, 0, -1})};
    return scene;
  });
  family.add("edge-values-outside-4x", "the edges of a triangle that touches the view volume in one corner: what may be drawn has that corner's data",
             {"R9", "R34"}, [] {
               Scene scene = outlined(LINE, {{-1, -1, 0, 1}, {-1, -1, 0, 1}, {1, -1.03125f, 0, 1}}, 4);
               scene.draws[0].varyings = {{.name = "offset", .interpolation = Interpolation::offset, .components = 1, .values = {0, 0, 1}, .offsetX = 0, .offsetY = -0.3125f}};
               return scene;
             });
  family.add("edges-viewport", "the edges of a cut triangle in viewport 1, where the scissor of viewport 0 is elsewhere", {"R34", "R39"}, [] {
    Scene scene = outlined(LINE, {{0, 0, 0, 1}, {0.125f, 3, 0, 1}, {-0.03125f, -1, 0, 1}});
    scene.target.width = 16;
    scene.viewport = {0, 0, 16, 1, 0, 1};
    scene.scissor = Rect2D{6, 4, 1, 1};
    scene.furtherViewports = {{{-16, 0, 64, 2, 0, 1}}};
    scene.draws[0].viewportIndex = 1;
    return scene;
  });
  family.add("corner-viewport", "a corner that a clip distance made in viewport 1, where the scissor of viewport 0 is elsewhere", {"R5", "R34", "R39"}, [] {
    Scene scene = outlined(POINT, {{-1, -0.7894737f, 0.5f, 1}, {-1, -0.7894737f, 0.5f, 1}, {-0.75f, -0.75f, 0.5f, 1}});
    scene.scissor = Rect2D{5, 3, 1, 1};
    scene.furtherViewports = {{scene.viewport}};
    scene.draws[0].viewportIndex = 1;
    scene.draws[0].clipDistanceCount = 1;
    scene.draws[0].clipDistances = {1, 0, -1};
    return scene;
  });
  family.add("edges-biased-beyond", "a slope bias that takes one end of an edge beyond the depth range", {"R34", "R37", "R38"}, [] {
    return biased(outlined(LINE, {{-1, -1, 0.25f, 1}, {1, 1, 1, 1}, {0.75f, 1, 1, 1}}), 0, 0.25f);
  });
  family.add("edges-biased-slope", "the slope of a triangle's bias is that of the triangle, on its edges too", {"R34", "R35", "R37"}, [] {
    return biased(outlined(LINE, {{-1, -1, 0.25f, 1}, {1, -1, 0.20510776f, 1}, {-1, 1, 0.25f, 1}}), 0, 0.5f);
  });
  family.add("edges-biased-no-area", "a bias of zero on the edges of a triangle without area", {"R12", "R34", "R37"},
             [] { return biased(outlined(LINE, {{1, 1, 0.5f, 1}, {-1, -1, 0.5f, 1}, {-1, -1, 0.5f, 1}}), 0, 0); });
  family.add("corner-without-area", "a triangle without area is back-facing, at its corners too", {"R12", "R34", "R44"}, [] {
    Scene scene = outlined(POINT, {{0, 0, 0, 1}, {1, 1, 0, 1}, {0, 0, 0, 1}});
    scene.builtIns = {BuiltIn::FrontFacing};
    return scene;
  });
  family.add("edge-outside-4x", "the edges of a triangle wholly outside of the view volume", {"R3", "R34"},
             [] { return outlined(LINE, {{103, -17, 0, 1}, {-9, 3, 0, 1}, {7, 3, 0, 1}}, 4); });
  family.add("edges-behind-eye", "a triangle with a vertex behind the eye: its edge in front of it", {"R3", "R8", "R34"},
             [] { return outlined(LINE, {{-1, -1, 0, 1}, {6, -6, 0, -2}, {-1, 1, 0, 1}}); });
}

void addTriangles(Family& family) {
  using enum PrimitiveTopology;
  family.add("cut-triangle-noperspective", "an input of a triangle cut at a side that its first vertex lies on", {"R9"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{-1, -0.75f, 0, 1}, {-20.5f, -20, 0, 1}, {0, -1, 0, 1}});
    scene.viewport = {0, 0, 16, 8, 0, 1};
    scene.draws[0].varyings = {one("noperspective", Interpolation::noperspective, {0, 0, -1})};
    return scene;
  });
  family.add("frag-coord-behind-eye", "1 / w of a triangle with a vertex behind the eye", {"R10", "R23"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{-30, -20, 0, -2}, {15, 9.203125f, 0, 1}, {-1, 9, 0, 1}});
    scene.builtIns = {BuiltIn::FragCoord};
    return scene;
  });
  family.add("cut-sliver-folds", "a sliver that the near plane cuts: whatever snapping makes of it, a sample is covered once", {"R3", "R14"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{0.277f, 1.0986f, -0.4f, 2.1555f}, {0.3518f, 0.764f, 0.8f, 1.3325f}, {0.3734f, 0.74175f, 0.0046f, 1.26087f}});
    scene.viewport = {-80, -100, 128, 128, 0, 1};
    return scene;
  });
  family.add("alpha-of-samples", "alpha to coverage of samples that are shaded one by one: each has its own alpha, of 1 and more or less than 0",
             {"R19", "R41"}, [] {
               Scene scene = pixel(TRIANGLE_LIST, {{-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1}}, 4);
               scene.state.alphaToCoverageEnable = true;
               scene.draws[0].varyings = {
                   {.name = "sample", .interpolation = Interpolation::sample, .components = 4, .values = {0, 0, 0, -4, 0, 0, 0, -4, 0, 0, 0, 28}}};
               return scene;
             });
  family.add("values-without-area", "a triangle that has an area only once its corners are snapped: a constant stays one", {"R14", "R21"}, [] {
    Scene scene = target(29, 14, 4);
    drawClip(scene, {{0.39864865f, 0.2548564f, 0, 1}, {0.5236486f, -0.2779772f, 0, 1}, {0.6486486f, -0.8108108f, 0, 1}});
    scene.viewport = {0, 0, 37, 37, 0, 1};
    scene.draws[0].varyings = {one("smooth", Interpolation::smooth, {0, 0, 0})};
    return scene;
  });
  family.add("between-no-area", "a triangle between two without area, whatever the shader reads", {"R12", "R14", "R23"}, [] {
    const ClipPosition a{-1, -1, 0.5f, 1}, b{1, 0, 0.5f, 1}, c{-1, 1, 0.5f, 1}, d{-1, 0, 0.5f, 1};
    Scene scene = pixel(TRIANGLE_LIST, {a, a, a, a, b, c, d, d, d});
    scene.builtIns = {BuiltIn::FragCoord};
    return scene;
  });
  family.add("facing-of-three", "a front-facing triangle and two that have all corners in one place", {"R12", "R44"}, [] {
    const ClipPosition a{-1, -1, 0, 1};
    Scene scene = pixel(TRIANGLE_LIST, {{1, 1, 0, 1}, {1, -1, 0, 1}, a, a, a, a, a, a, a});
    scene.builtIns = {BuiltIn::FrontFacing};
    return scene;
  });
  family.add("clipped-without-area", "a triangle with two corners in one place, whose pieces have an area once clipping and snapping are done", {"R5", "R14", "R23"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{0.1625f, 0.171875f, 0, 1}, {0.1625f, 0.171875f, 0, 1}, {-1, -1, 0, 1}});
    scene.viewport = {-15, -12, 80, 64, 0, 1};
    scene.draws[0].clipDistanceCount = 1;
    scene.draws[0].clipDistances = {0, -3, 0.5f};
    scene.builtIns = {BuiltIn::FragCoord};
    return scene;
  });
  family.add("cut-sliver-frag-coord", "a sliver that reaches far outside, whose snapped corners are in line: z of FragCoord is a number", {"R3", "R14", "R23"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{127.875f, 39.9375f, 0, 1}, {127.875f, 40, 0, 1}, {-32, -10, 0, 1}});
    scene.builtIns = {BuiltIn::FragCoord};
    return scene;
  });
  family.add("edges-of-two-sides", "a triangle in line that clipping cuts: parts of it may show either side, and their edges with them", {"R3", "R12", "R34", "R44"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{0.109375f, -0.1171875f, -0.0625f, 1}, {0.1171875f, -0.125f, 0.75f, 1}, {0.421875f, -0.4296875f, 1.25f, 1}});
    scene.viewport = {-53, -20, 80, 64, 0, 1};
    scene.state.polygonMode = PolygonMode::LINE;
    scene.builtIns = {BuiltIn::FrontFacing};
    return scene;
  });
  family.add("behind-eye-turned", "a triangle with a vertex behind the eye, seen almost edge-on: what of it is in view is drawn", {"R3", "R4"}, [] {
    Scene scene = pixel(TRIANGLE_LIST, {{-0.06f, 0.786f, 4, -10.9f}, {-0.005f, -0.021f, 0.06f, 0.28f}, {0.014f, -0.167f, 3, 2.3f}});
    scene.viewport = {-1, -1, 128, 128, 0, 1};
    scene.state.depthClampEnable = true;
    return scene;
  });
  family.add("bias-of-largest-depth", "the unit of a float bias comes from the largest depth, whichever vertex has it", {"R36"}, [] {
    return biased(pixel(TRIANGLE_LIST, {{-1, -1, 0.3f, 1}, {1, -1, 0.15f, 1}, {1, 1, 0.15f, 1}}), -70000, 0);
  });
  family.add("bias-reversed-range", "the unit of a float bias where the viewport's depth range is reversed", {"R2", "R36"}, [] {
    Scene scene = biased(pixel(TRIANGLE_LIST, {{-1, -1, 0.5f, 1}, {1, 1, 0.5f, 1}, {1, -1, 0.5f, 1}}), -70000, 0);
    scene.viewport.minDepth = 1;
    scene.viewport.maxDepth = 0;
    return scene;
  });
}

}  // namespace

void addFound(Entries& entries) {
  Family family(entries, "found");
  addTriangles(family);
  addOutlines(family);
  addLines(family);
  addPoints(family);
}

}  // namespace rasterdiff::families
