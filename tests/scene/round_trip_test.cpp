// writeScene and parseScene are inverse, bit by bit.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "scene/catalogue/catalogue.hpp"
#include "scene/file/number.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

bool sameBits(const std::vector<ClipPosition>& a, const std::vector<ClipPosition>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(ClipPosition)) == 0);
}

/// Equality that tells -0 from 0 and NaNs from one another.
bool identical(Scene a, Scene b) {
  if (a.draws.size() != b.draws.size()) return false;
  if (std::memcmp(&a.viewport, &b.viewport, sizeof a.viewport) != 0) return false;
  for (size_t d = 0; d < a.draws.size(); ++d) {
    if (!sameBits(a.draws[d].positions, b.draws[d].positions)) return false;
    if (a.draws[d].varyings.size() != b.draws[d].varyings.size()) return false;
    for (size_t v = 0; v < a.draws[d].varyings.size(); ++v) {
      if (!sameBits(a.draws[d].varyings[v].values, b.draws[d].varyings[v].values)) return false;
      a.draws[d].varyings[v].values = b.draws[d].varyings[v].values = {};
    }
    a.draws[d].positions = b.draws[d].positions = {};
    if (!sameBits(a.draws[d].clipDistances, b.draws[d].clipDistances)) return false;
    if (!sameBits(a.draws[d].cullDistances, b.draws[d].cullDistances)) return false;
    a.draws[d].clipDistances = b.draws[d].clipDistances = {};
    a.draws[d].cullDistances = b.draws[d].cullDistances = {};
  }
  return a == b;
}

/// Any bit pattern: half of the time one of the awkward ones.
rc::Gen<float> anyFloat(bool nonFinite) {
  const auto bits = rc::gen::oneOf(
      rc::gen::arbitrary<uint32_t>(),
      rc::gen::element<uint32_t>(0u, 0x80000000u, 1u, 0x80000001u, 0x007fffffu, 0x00800000u, 0x7f7fffffu, 0x3dcccccdu,
                                 0x7f800000u, 0xff800000u, 0x7fc00000u, 0xffc00000u, 0x7f800001u, 0x3f800001u));
  return rc::gen::map(bits, [nonFinite](uint32_t b) {
    const float value = std::bit_cast<float>(b);
    return nonFinite || std::isfinite(value) ? value : 1.5f;
  });
}

template <class E>
E pick(std::initializer_list<E> values) {
  return *rc::gen::elementOf(std::vector<E>(values));
}

/// Everything but varyings and draws: polygon, line, point, depth and sample state, viewports and built-ins.
void drawState(Scene& scene) {
  State& state = scene.state;
  const bool triangles = state.topology >= PrimitiveTopology::TRIANGLE_LIST;
  state.primitiveRestartEnable = *rc::gen::arbitrary<bool>();
  if (triangles) state.polygonMode = pick({PolygonMode::FILL, PolygonMode::LINE, PolygonMode::POINT});
  state.depthClampEnable = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) state.depthClipEnable = *rc::gen::arbitrary<bool>();
  state.depthBiasEnable = *rc::gen::arbitrary<bool>();
  state.depthBiasConstantFactor = pick({0.0f, 0.1f, -17.0f});
  state.depthBiasClamp = pick({0.0f, 0.25f, -1e-45f});
  state.depthBiasSlopeFactor = pick({0.0f, 3.4e38f, -1.5f});
  state.lineWidth = pick({1.0f, 0.1f, 255.0f});
  state.lineRasterizationMode = static_cast<LineRasterizationMode>(*rc::gen::inRange(0u, 4u));
  const bool lines = state.topology == PrimitiveTopology::LINE_LIST || state.topology == PrimitiveTopology::LINE_STRIP;
  state.stippledLineEnable = (lines || state.polygonMode == PolygonMode::LINE) && *rc::gen::arbitrary<bool>();
  scene.target.supersample = pick({1u, 2u, 5u});  // larger ones would exceed kMaxFrameBytes
  state.lineStippleFactor = *rc::gen::inRange(1u, state.stippledLineEnable ? 9u : 257u);
  state.lineStipplePattern = *rc::gen::arbitrary<uint16_t>();
  state.pointSize = pick({1.0f, 0.3f, 64.0f});
  state.sampleMask = *rc::gen::arbitrary<uint32_t>();
  state.sampleShadingEnable = *rc::gen::arbitrary<bool>();
  state.minSampleShading = pick({0.0f, 0.1f, 1.0f});
  state.shaderSampleMask = pick({ShaderSampleMask::NONE, ShaderSampleMask::CONSTANT, ShaderSampleMask::INPUT_SHIFTED});
  if (*rc::gen::arbitrary<bool>()) {
    scene.furtherViewports = {{{-0.5f, 0, 8.1f, -8, 1, 0}, std::nullopt}, {{1, 2, 3, 4, 0, 0.1f}, Rect2D{1, 2, 3, 4}}};
  }
  if (*rc::gen::arbitrary<bool>()) scene.builtIns = {BuiltIn::SampleMask, BuiltIn::FragCoord, BuiltIn::FrontFacing};
  const bool points = state.topology == PrimitiveTopology::POINT_LIST || state.polygonMode == PolygonMode::POINT;
  if (points) scene.builtIns.push_back(BuiltIn::PointCoord);
}

Scene anyScene() {
  Scene scene;
  scene.name = pick<std::string>({"", "a", "fill/x-1", "quote\"d", "\xc3\xa4/b.c"});
  scene.allowNonFinite = *rc::gen::arbitrary<bool>();
  scene.target.width = *rc::gen::inRange(1u, 100u);
  scene.target.height = *rc::gen::inRange(1u, 100u);
  scene.target.samples = pick({1u, 2u, 4u, 8u, 16u});
  if (*rc::gen::arbitrary<bool>()) {
    scene.target.depthFormat = pick({DepthFormat::D16_UNORM, DepthFormat::X8_D24_UNORM_PACK32, DepthFormat::D32_SFLOAT,
                                     DepthFormat::D24_UNORM_S8_UINT, DepthFormat::D32_SFLOAT_S8_UINT});
    scene.target.depthClearValue = pick({0.0f, -0.0f, 0.1f, 1.0f, 1e-45f});
    if (scene.target.samples > 1 && *rc::gen::arbitrary<bool>()) {
      scene.target.depthResolveMode = pick({ResolveMode::SAMPLE_ZERO, ResolveMode::AVERAGE, ResolveMode::MIN, ResolveMode::MAX});
    }
    scene.state.depthTestEnable = *rc::gen::arbitrary<bool>();
    scene.state.depthWriteEnable = *rc::gen::arbitrary<bool>();
  }
  scene.viewport = {
      pick({0.0f, -0.0f, 0.1f, -3.5f}), pick({0.0f, 1.0f / 512}), pick({64.0f, 0.3f}), pick({64.0f, -7.7f}),
      pick({0.0f, 0.1f, 1.0f}),         pick({0.0f, 0.7f, 1.0f})};
  if (*rc::gen::arbitrary<bool>()) scene.scissor = Rect2D{3, 0, 5, 0xffffff};
  using enum PrimitiveTopology;
  scene.state.topology = pick({POINT_LIST, LINE_LIST, LINE_STRIP, TRIANGLE_LIST, TRIANGLE_STRIP, TRIANGLE_FAN});
  drawState(scene);
  scene.state.cullMode = pick({CullMode::NONE, CullMode::FRONT, CullMode::BACK, CullMode::FRONT_AND_BACK});
  scene.state.frontFace = pick({FrontFace::CLOCKWISE, FrontFace::COUNTER_CLOCKWISE});
  scene.state.provokingVertexMode = pick({ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX});
  scene.state.depthCompareOp = static_cast<CompareOp>(*rc::gen::inRange(0u, 8u));
  scene.state.negativeOneToOne = *rc::gen::arbitrary<bool>();
  const auto varyings = *rc::gen::inRange<uint32_t>(0, 4);
  std::vector<Varying> kinds;
  for (uint32_t v = 0; v < varyings; ++v) {
    kinds.push_back({.name = fmt::format("v{}", v),
                     .interpolation = static_cast<Interpolation>(*rc::gen::inRange(0u, 6u)),
                     .components = *rc::gen::inRange(1u, 5u)});
    if (kinds.back().interpolation == Interpolation::offset) {
      kinds.back().offsetX = pick({-0.5f, -0.0f, 0.1f});
      kinds.back().offsetY = pick({0.0f, 0.4375f, 1e-45f});
    }
  }
  const bool atSamples = std::ranges::any_of(kinds, [](const Varying& v) { return v.interpolation == Interpolation::sample; });
  if (atSamples && scene.state.shaderSampleMask == ShaderSampleMask::INPUT_SHIFTED) {
    scene.state.sampleShadingEnable = true;
    scene.state.minSampleShading = 1;
  }
  scene.target.resolve = varyings > 0 && scene.target.samples > 1 && *rc::gen::arbitrary<bool>();
  scene.state.alphaToCoverageEnable =
      varyings > 0 && kinds[0].components == 4 && scene.target.samples > 1 && *rc::gen::arbitrary<bool>();
  const auto clipDistances = *rc::gen::inRange<uint32_t>(0, 5), cullDistances = *rc::gen::inRange<uint32_t>(0, 5);
  const auto draws = *rc::gen::inRange<uint32_t>(1, 4);
  for (uint32_t d = 0; d < draws; ++d) {
    Draw& draw = scene.draws.emplace_back();
    const auto vertices = *rc::gen::inRange<size_t>(1, 9);
    const auto floats = [&](size_t count) {
      return *rc::gen::container<std::vector<float>>(count, anyFloat(scene.allowNonFinite));
    };
    const std::vector<float> p = floats(4 * vertices);
    for (size_t i = 0; i < vertices; ++i)
      draw.positions.push_back({p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]});
    if (scene.state.shaderSampleMask != ShaderSampleMask::NONE) draw.shaderSampleMaskBits = *rc::gen::arbitrary<uint32_t>();
    if (*rc::gen::arbitrary<bool>()) {
      draw.indices = *rc::gen::container<std::vector<uint32_t>>(rc::gen::inRange(0u, static_cast<uint32_t>(vertices)));
    }
    if (*rc::gen::arbitrary<bool>()) {
      for (size_t i = 0; i < vertices; ++i) draw.pointSizes.push_back(pick({1.0f, 0.1f, 1e-45f, 3.4e38f}));
    }
    draw.clipDistanceCount = clipDistances;
    draw.clipDistances = floats(vertices * clipDistances);
    draw.cullDistanceCount = cullDistances;
    draw.cullDistances = floats(vertices * cullDistances);
    draw.viewportIndex = *rc::gen::inRange<uint32_t>(0, 1 + static_cast<uint32_t>(scene.furtherViewports.size()));
    if (draw.indices && scene.state.primitiveRestartEnable) draw.indices->push_back(kRestartIndex);
    draw.varyings = kinds;
    for (Varying& varying : draw.varyings) varying.values = floats(vertices * varying.components);
  }
  return scene;
}

TEST(WriteScene, WhatIsWrittenIsReadBackBitByBit) {
  const bool holds = rc::check("read(write(scene)) == scene", [] {
    const Scene scene = anyScene();
    const auto sound = validate(scene);
    RC_ASSERT(sound.has_value());
    const std::string text = writeScene(scene);
    const Result<Scene> read = parseScene(text, "other.scene.json");
    if (!read) RC_FAIL(read.error().where + ": " + read.error().what + "\n" + text);
    RC_ASSERT(identical(*read, scene));
  });
  EXPECT_TRUE(holds);
}

TEST(JsonNumber, EveryFloatIsReadBackBitByBit) {
  const bool holds = rc::check("read(jsonNumber(x)) == x", [] {
    const float value = *anyFloat(true);
    const std::string text =
        "{\"target\":{\"width\":1,\"height\":1},\"allowNonFinite\":true,\"draws\":[{\"positions\":[[0,0,0," +
        jsonNumber(value) + "]]}]}";
    const Result<Scene> read = parseScene(text, "x");
    RC_ASSERT(read.has_value());
    RC_ASSERT(std::bit_cast<uint32_t>(read->draws[0].positions[0].w) == std::bit_cast<uint32_t>(value));
  });
  EXPECT_TRUE(holds);
}

TEST(WriteScene, TheCatalogueRoundTrips) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name.starts_with("mesh/")) continue;  // 2 MB of text each; the same draws as any indexed one
    const Result<Scene> scene = entry.make();
    ASSERT_TRUE(scene.has_value()) << entry.name;
    const Result<Scene> read = parseScene(writeScene(*scene), "x");
    ASSERT_TRUE(read.has_value()) << entry.name << ": " << read.error().where << " " << read.error().what;
    EXPECT_TRUE(identical(*read, *scene)) << entry.name;
  }
}

TEST(WriteScene, ReadsWell) {
  Scene scene;
  scene.name = "fill/one";
  scene.target = {.width = 8, .height = 8, .samples = 4};
  scene.viewport = {0, 0, 8, 8, 0, 1};
  Draw& draw = scene.draws.emplace_back();
  draw.positions = {{0, -0.5f, 0.1f, 1}, {-0.0f, HUGE_VALF, 1e-45f, 1}};
  draw.indices = {0, 1, 0};
  draw.varyings = {{.name = "c", .interpolation = Interpolation::flat, .components = 1, .values = {1, 2}}};
  EXPECT_EQ(writeScene(scene), R"({
  "name": "fill/one",
  "target": {"width": 8, "height": 8, "samples": 4},
  "viewport": {"x": 0, "y": 0, "width": 8, "height": 8, "minDepth": 0, "maxDepth": 1},
  "state": {"topology": "TRIANGLE_LIST"},
  "draws": [
    {"positions": [
      [0, -0.5, 0.1, 1],
      [-0.0, "inf", 1e-45, 1]],
     "indices": [0, 1, 0],
     "varyings": [
      {"name": "c", "interpolation": "flat", "values": [[1], [2]]}]}]
}
)");
}

}  // namespace
}  // namespace rasterdiff
