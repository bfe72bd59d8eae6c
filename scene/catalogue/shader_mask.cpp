// The sample mask that the fragment shader writes, ANDed to the coverage before alpha to coverage and the depth test.
// [vk:fragops-covg]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

using enum ShaderSampleMask;

Scene writing(uint32_t samples, ShaderSampleMask mask, uint32_t bits = 0xFFFFFFFF) {
  Scene scene = square(32, samples);
  scene.state.shaderSampleMask = mask;
  draw(scene, {{3.25, 2.5, 0.25}, {28.75, 9, 0.25}, {11, 29.125, 0.25}}).shaderSampleMaskBits = bits;
  return scene;
}

/// A second draw over most of the first, farther away: with a depth test it is seen where the first one left no depth.
void drawBehind(Scene& scene, uint32_t bits) {
  draw(scene, {{1.5, 4.25, 0.5}, {30.25, 3.5, 0.5}, {17.75, 30.5, 0.5}}).shaderSampleMaskBits = bits;
}

Scene shaded(ShaderSampleMask mask, uint32_t bits, float minimum) {
  Scene scene = writing(4, mask, bits);
  scene.state.sampleShadingEnable = true;
  scene.state.minSampleShading = minimum;
  return scene;
}

void setAlpha(Scene& scene, const std::vector<float>& alpha) {
  scene.state.alphaToCoverageEnable = true;
  addVarying(scene, "color", Interpolation::smooth, 4);
  for (Draw& draw : scene.draws) {
    for (size_t i = 0; i < draw.positions.size(); ++i) draw.varyings[0].values[4 * i + 3] = alpha[i % alpha.size()];
  }
}

void addCounts(Family& family) {
  family.add("1x-0", "the only sample is taken", {"R40"}, [] { return writing(1, CONSTANT, 0xFFFFFFFE); });
  family.add("1x-1", "bits beyond the samples mean nothing", {"R40"}, [] { return writing(1, CONSTANT, 0x00000001); });
  family.add("1x-shifted", "the only bit of the input is moved out of the mask", {"R40"}, [] { return writing(1, INPUT_SHIFTED); });
  for (const uint32_t bits : {0x0u, 0x1u, 0x2u, 0x4u, 0x8u, 0x6u, 0xBu, 0xFFFFFFF5u}) {
    family.add(fmt::format("4x-{:x}", bits), "only the samples of the written mask are kept", {"R16", "R40"},
               [bits] { return writing(4, CONSTANT, bits); });
  }
  for (const uint32_t samples : {2u, 8u, 16u}) {
    family.add(fmt::format("{}x-5a5a", samples), "the written mask of other numbers of samples", {"R16", "R40"},
               [samples] { return writing(samples, CONSTANT, 0x5A5A); });
    family.add(fmt::format("{}x-shifted", samples), "a sample is kept where the one before it is covered", {"R24", "R40"},
               [samples] { return writing(samples, INPUT_SHIFTED); });
  }
  family.add("4x-shifted", "a sample is kept where the one before it is covered", {"R24", "R40"}, [] { return writing(4, INPUT_SHIFTED); });
}

void addStages(Family& family) {
  family.add("draws", "every draw writes its own mask", {"R40", "R50"}, [] {
    Scene scene = writing(4, CONSTANT, 0x3);
    drawBehind(scene, 0x6);
    return scene;
  });
  family.add("depth", "samples that the mask takes keep their depth, and are not tested", {"R38", "R40"}, [] {
    Scene scene = writing(4, CONSTANT, 0x9);
    drawBehind(scene, 0xFFFFFFFF);
    useDepth(scene);
    return scene;
  });
  family.add("1x-depth", "a fragment without samples writes no depth", {"R38", "R40"}, [] {
    Scene scene = writing(1, CONSTANT, 0);
    drawBehind(scene, 1);
    useDepth(scene);
    return scene;
  });
  family.add("shifted-depth", "the input is the mask of before the depth test", {"R24", "R38", "R40"}, [] {
    Scene scene = writing(4, INPUT_SHIFTED);
    drawBehind(scene, 0xFFFFFFFF);
    useDepth(scene);
    return scene;
  });
  family.add("with-state", "the pipeline's mask and the written one", {"R40"}, [] {
    Scene scene = writing(4, CONSTANT, 0x6);
    scene.state.sampleMask = 0xC;
    return scene;
  });
  family.add("shifted-with-state", "the input lacks the samples that the pipeline's mask has taken", {"R24", "R40"}, [] {
    Scene scene = writing(4, INPUT_SHIFTED);
    scene.state.sampleMask = 0xD;
    scene.builtIns = {BuiltIn::SampleMask};
    return scene;
  });
  family.add("shifted-offset", "interpolateAtOffset is no sample shading: the input has all samples of the fragment", {"R19", "R24", "R40", "R48"}, [] {
    Scene scene = square(1, 4);
    scene.state.shaderSampleMask = INPUT_SHIFTED;
    scene.viewport = {0, 0, 2, 2, 0, 1};  // of which the target is one quarter, wholly covered
    drawClip(scene, {{-1, -1, 0.5f, 1}, {1, -1, 0.5f, 1}, {-1, 1, 0.5f, 1}});
    addVarying(scene, "offset", Interpolation::offset, 1);
    for (Varying& varying : scene.draws[0].varyings) varying.offsetX = varying.offsetY = 0.25f;
    return scene;
  });
  family.add("alpha", "alpha to coverage of what the mask leaves", {"R40", "R41"}, [] {
    Scene scene = writing(4, CONSTANT, 0x5);
    setAlpha(scene, {1});
    return scene;
  });
  family.add("alpha-ramp", "a mask and alphas from 0 to 1", {"R40", "R41"}, [] {
    Scene scene = writing(4, CONSTANT, 0xA);
    setAlpha(scene, {0, 1, 0.5f});
    useDepth(scene);
    return scene;
  });
  family.add("resolve", "samples without their bit go into the average as they were", {"R40", "R42"}, [] {
    Scene scene = writing(4, CONSTANT, 0x7);
    drawBehind(scene, 0xC);
    addVarying(scene, "color", Interpolation::flat, 4);
    scene.target.resolve = true;
    return scene;
  });
  family.add("values", "a written mask does not move where values are evaluated", {"R20", "R24", "R40"}, [] {
    Scene scene = writing(4, CONSTANT, 0x6);
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "centroid", Interpolation::centroid, 2);
    scene.builtIns = {BuiltIn::SampleMask};
    return scene;
  });
}

void addShading(Family& family) {
  family.add("shading", "an invocation for each sample writes all bits: its own counts", {"R19", "R40"},
             [] { return shaded(CONSTANT, 0x6, 1); });
  family.add("shading-half", "at least two invocations a pixel", {"R19", "R40"}, [] { return shaded(CONSTANT, 0xB, 0.5f); });
  family.add("shading-shifted", "an invocation that writes the bit of the next sample keeps nothing", {"R19", "R24", "R40"},
             [] { return shaded(INPUT_SHIFTED, 0xFFFFFFFF, 1); });
  family.add("shading-depth", "each invocation's sample, then its depth", {"R19", "R38", "R40"}, [] {
    Scene scene = shaded(CONSTANT, 0x9, 1);
    drawBehind(scene, 0xE);
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    useDepth(scene);
    return scene;
  });
  family.add("shading-ids", "SampleId shades every sample by itself", {"R19", "R40"}, [] {
    Scene scene = writing(4, CONSTANT, 0xA);
    scene.builtIns = {BuiltIn::SampleId};
    return scene;
  });
  family.add("shading-alpha", "a mask and alpha of every invocation", {"R19", "R40", "R41"}, [] {
    Scene scene = shaded(CONSTANT, 0xC, 1);
    setAlpha(scene, {1});
    return scene;
  });
}

void addFigures(Family& family) {
  family.add("points", "points have a mask too", {"R25", "R40"}, [] {
    Scene scene = square(32, 4);
    usePoints(scene, 5);
    scene.state.shaderSampleMask = INPUT_SHIFTED;
    draw(scene, {{6.5, 7.25}, {20.125, 12}, {11, 25.75}});
    return scene;
  });
  family.add("lines", "lines have a mask too", {"R27", "R40"}, [] {
    Scene scene = square(32, 4);
    useLines(scene, LineRasterizationMode::RECTANGULAR, 3);
    scene.state.shaderSampleMask = CONSTANT;
    draw(scene, {{3.5, 4.25}, {28.25, 13}, {5.5, 27}, {25.75, 18.5}}).shaderSampleMaskBits = 0x9;
    return scene;
  });
  for (const ShaderSampleMask mask : {CONSTANT, INPUT_SHIFTED}) {
    family.add(mask == CONSTANT ? "bresenham" : "bresenham-shifted", "every sample of a Bresenham line's pixels has its own bit", {"R24", "R31", "R40"}, [mask] {
      Scene scene = square(16, 4);
      useLines(scene, LineRasterizationMode::BRESENHAM);
      scene.state.shaderSampleMask = mask;
      draw(scene, {{1.25, 2.5}, {14.75, 8.25}}).shaderSampleMaskBits = 0xB;
      return scene;
    });
  }
}

}  // namespace

void addShaderMask(Entries& entries) {
  Family family(entries, "shader-mask");
  addCounts(family);
  addStages(family);
  addShading(family);
  addFigures(family);
}

}  // namespace rasterdiff::families
