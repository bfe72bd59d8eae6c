#include "harness/method_subject.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rasterizer/geometry.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/target_area.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::CoverageMask;
using rasterizer::CoverageMethod;
using rasterizer::PixelArea;

/// What the scene wants beyond the coverage of filled triangles; empty if nothing.
std::string beyondCoverage(const Scene& scene) {
  const State& state = scene.state;
  const SceneNeeds needs = needsOf(scene);
  if (state.topology == PrimitiveTopology::POINT_LIST) return "points";
  if (state.topology == PrimitiveTopology::LINE_LIST || state.topology == PrimitiveTopology::LINE_STRIP) return "lines";
  if (state.polygonMode != PolygonMode::FILL) return "edges or corners of triangles";
  if (needs.depth) return "depth";
  if (needs.varyings + needs.builtIns > 0 || state.alphaToCoverageEnable || needs.resolve) return "values";
  if (state.sampleMask != State{}.sampleMask || state.shaderSampleMask != ShaderSampleMask::NONE) return "a sample mask";
  return {};
}

/// Samples that the mask has within `box`, written as one primitive.
void write(Frame& frame, uint32_t primitive, const CoverageMask& mask, const PixelArea& box) {
  for (int32_t y = box.top; y < box.bottom; ++y) {
    for (int32_t x = box.left; x < box.right; ++x) {
      for (uint32_t s = 0; s < frame.samples; ++s) {
        const auto px = static_cast<uint32_t>(x), py = static_cast<uint32_t>(y);
        if (!mask.at(px, py, s)) continue;
        frame.primitive.at(px, py, s) = primitive;
        ++frame.count.at(px, py, s);
      }
    }
  }
}

/// The pixels that a method may touch for the triangle: its box and a pixel around it, within the scissor.
PixelArea boxOf(const rasterizer::SnappedTriangle& triangle, const PixelArea& area) {
  const auto [left, right] = std::minmax({triangle.v[0].x, triangle.v[1].x, triangle.v[2].x});
  const auto [top, bottom] = std::minmax({triangle.v[0].y, triangle.v[1].y, triangle.v[2].y});
  const auto pixel = [](int32_t v) { return v >> kSubpixelBits; };
  return {std::max(area.left, pixel(left) - 1), std::max(area.top, pixel(top) - 1), std::min(area.right, pixel(right) + 2),
          std::min(area.bottom, pixel(bottom) + 2)};
}

class MethodSubject final : public Subject {
 public:
  MethodSubject(std::string name, const CoverageMethod& method, rasterizer::Rules rules)
      : name_(std::move(name)), method_(method), rules_(std::move(rules)) {}

  std::string name() const override { return name_; }
  std::string info() const override { return method_.what; }
  const Limits& limits() const override { return rules_.limits; }

  Result<Frame> render(const Scene& scene) override {
    if (const std::string beyond = beyondCoverage(scene); !beyond.empty()) {
      return fail(ErrorCode::NotOffered, name_, "draws the coverage of filled triangles only, not " + beyond);
    }
    const auto [width, height, samples] = std::array{scene.target.width, scene.target.height, scene.target.samples};
    Result<CoverageMask> mask = CoverageMask::create(width, height, samples);
    if (!mask) return tl::unexpected(mask.error());
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.samples = samples;
    frame.primitive = Plane<uint32_t>(width, height, samples);
    frame.count = Plane<uint32_t>(width, height, samples);
    rasterizer::RuleCounts ignored;
    rasterizer::forEachPrimitive(scene, rules_, ignored, [&](const rasterizer::Primitive& primitive) {
      const PixelArea area = rasterizer::targetArea(scene, primitive.viewportIndex);
      for (const rasterizer::SetupTriangle& piece : primitive.pieces) {
        if (piece.culled) continue;
        const auto corner = [&](size_t k) { return primitive.polygon[piece.corner[k]].snapped; };
        const rasterizer::SnappedTriangle triangle{{corner(0), corner(1), corner(2)}};
        mask->clear();
        method_.draw({&triangle, 1}, *mask);
        write(frame, primitive.number, *mask, boxOf(triangle, area));
      }
    });
    return frame;
  }

 private:
  std::string name_;
  const CoverageMethod& method_;
  rasterizer::Rules rules_;
};

}  // namespace

Result<std::unique_ptr<Subject>> openMethod(const SubjectOptions& options, std::string_view name) {
  const CoverageMethod* method = rasterizer::coverageMethod(name);
  if (method == nullptr) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("there is no coverage method named '{}'", name),
                "rasterdiff methods coverage");
  }
  Limits limits;
  limits.framebufferSampleCounts = 0x1F;
  Result<rasterizer::Rules> rules = rasterizer::Rules::profile(options.profile, limits);
  if (!rules) return tl::unexpected(rules.error());
  return std::make_unique<MethodSubject>(options.driver, *method, std::move(*rules));
}

}  // namespace rasterdiff::harness
