#include "rasterizer/frame_writer.hpp"

#include <cmath>
#include <limits>

#include "rasterizer/depth_test.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kPixel = 1.0 / kSubpixelOne;

State withError(State state, DeliberateError error) {
  if (error == DeliberateError::DepthWriteIgnored) state.depthWriteEnable = false;
  if (error == DeliberateError::DepthTestInverted) {
    switch (state.depthCompareOp) {
      case CompareOp::LESS: state.depthCompareOp = CompareOp::GREATER; break;
      case CompareOp::GREATER: state.depthCompareOp = CompareOp::LESS; break;
      case CompareOp::LESS_OR_EQUAL: state.depthCompareOp = CompareOp::GREATER_OR_EQUAL; break;
      case CompareOp::GREATER_OR_EQUAL: state.depthCompareOp = CompareOp::LESS_OR_EQUAL; break;
      default: break;
    }
  }
  return state;
}

}  // namespace

FrameWriter::FrameWriter(const Scene& scene, const SceneNeeds& needs, const Rules& rules,
                         std::vector<SubpixelPosition> pattern, RuleCounts& counts)
    : state_(withError(scene.state, rules.error)), error_(rules.error), pattern_(std::move(pattern)), counts_(counts) {
  const auto [width, height, samples, depthFormat, clear] = scene.target;
  frame_.width = width;
  frame_.height = height;
  frame_.samples = samples;
  frame_.primitive = Plane<uint32_t>(width, height, samples);
  frame_.count = Plane<uint32_t>(width, height, samples);
  if (rules.open) frame_.coverage.emplace(width, height, samples);
  if (needs.depth) {
    frame_.depth.emplace(width, height, samples, 1, clear);
    frame_.depthBounds.emplace(width, height, samples, 1, Bounds{clear, clear});
  }
  if (needs.varyings > 0) {
    for (const Varying& varying : scene.draws[0].varyings) {
      VaryingPlane plane{varying.name, Plane<float>(width, height, samples, varying.components), std::nullopt};
      plane.bounds.emplace(width, height, samples, varying.components);
      frame_.varyings.push_back(std::move(plane));
    }
  }
}

void FrameWriter::fillCoverage(uint32_t primitive, int32_t y, std::span<const RowSpan> spans) {
  for (size_t s = 0; s < spans.size(); ++s) {
    for (int32_t x = spans[s].begin; x < spans[s].end; ++x) {
      writeSample(primitive, frame_.primitive.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(s)),
                  nullptr, nullptr);
    }
  }
}

void FrameWriter::writeRow(uint32_t primitive, const PieceValues& values, int32_t y, std::span<const RowSpan> spans) {
  const bool hasDepth = frame_.depth.has_value();
  if (!hasDepth && frame_.varyings.empty()) {
    fillCoverage(primitive, y, spans);
    return;
  }
  values_.resize(values.componentCount());
  int32_t begin = std::numeric_limits<int32_t>::max(), end = std::numeric_limits<int32_t>::min();
  for (const RowSpan& span : spans) {
    if (span.empty()) continue;
    begin = std::min(begin, span.begin);
    end = std::max(end, span.end);
  }
  for (int32_t x = begin; x < end; ++x) {
    bool evaluated = false;
    for (size_t s = 0; s < spans.size(); ++s) {
      if (x < spans[s].begin || x >= spans[s].end) continue;
      if (!evaluated && !values_.empty()) values.varyings(x + 0.5, y + 0.5, values_.data());
      evaluated = true;
      Interpolated depth;
      if (hasDepth) {
        depth = values.depth(x + pattern_[s].x * kPixel, y + pattern_[s].y * kPixel);
        if (error_ == DeliberateError::DepthOffByOneStep) {
          depth.value = std::nextafter(depth.bounds.hi, std::numeric_limits<float>::infinity());
        }
      }
      writeSample(primitive,
                  frame_.primitive.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(s)),
                  hasDepth ? &depth : nullptr, values_.data());
    }
  }
}

bool FrameWriter::passesDepth(size_t index, float fragment) {
  if (depthTestPasses(state_.depthCompareOp, fragment, frame_.depth->data[index])) return true;
  ++counts_[Rule::DepthTest];
  return false;
}

void FrameWriter::writeSample(uint32_t primitive, size_t index, const Interpolated* depth, const Interpolated* values) {
  if (depth != nullptr && state_.depthTestEnable) {
    if (!passesDepth(index, depth->value)) return;
    // [vk:fragops-depth] without the depth test, depth is not written either.
    if (state_.depthWriteEnable) {
      frame_.depth->data[index] = depth->value;
      frame_.depthBounds->data[index] = depth->bounds;
    }
  }
  uint32_t& winner = frame_.primitive.data[index];
  ++frame_.count.data[index];
  if (winner != 0) {
    ++counts_[Rule::Order];
    if (error_ == DeliberateError::FirstWins) return;
  }
  winner = primitive;
  for (VaryingPlane& plane : frame_.varyings) {
    const size_t components = plane.values.components;
    for (size_t c = 0; c < components; ++c) {
      plane.values.data[index * components + c] = values->value;
      plane.bounds->data[index * components + c] = values->bounds;
      ++values;
    }
  }
}

void FrameWriter::markCoverage(int32_t y, uint32_t sample, RowSpan certain) {
  for (int32_t x = certain.begin; x < certain.end; ++x) markCoverage(x, y, sample, Coverage::In);
}

void FrameWriter::markCoverage(int32_t x, int32_t y, uint32_t sample, Coverage coverage) {
  Coverage& known = frame_.coverage->at(static_cast<uint32_t>(x), static_cast<uint32_t>(y), sample);
  if (known != Coverage::In && coverage != Coverage::Out) known = coverage;
}

}  // namespace rasterdiff::rasterizer
