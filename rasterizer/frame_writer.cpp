#include "rasterizer/frame_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/depth_test.hpp"
#include "rasterizer/fragment/alpha_to_coverage.hpp"
#include "rasterizer/depth/resolve_depth.hpp"
#include "rasterizer/fragment/resolve.hpp"
#include "scene/built_ins.hpp"

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

// `widen`: what was legal before stays legal.
void set(Bounds& bounds, const Bounds& written, bool widen) {
  bounds = widen ? Bounds{std::min(bounds.lo, written.lo), std::max(bounds.hi, written.hi)} : written;
}

uint32_t maskUnder(const State& state, uint32_t samples, DeliberateError error) {
  const uint32_t all = (1U << samples) - 1;
  if (error == DeliberateError::SampleMaskIgnored) return all;
  return (error == DeliberateError::SampleMaskShifted ? state.sampleMask << 1 : state.sampleMask) & all;
}

}  // namespace

FrameWriter::FrameWriter(const Scene& scene, const SceneNeeds& needs, const Rules& rules,
                         std::vector<SubpixelPosition> pattern, const PieceValues& values, RuleCounts& counts)
    : state_(withError(scene.state, rules.error)), rules_(rules), error_(rules.error), pattern_(std::move(pattern)), counts_(counts), shaderMask_(scene, rules.error),
      sampleMask_(maskUnder(scene.state, scene.target.samples, rules.error)), open_(rules.open),
      openValues_(rules.openValues()), resolve_(scene.target.resolve),
      depthResolveMode_(scene.target.depthResolveMode), depthFormat_(scene.target.depthFormat.value_or(DepthFormat::D32_SFLOAT)) {
  const auto [width, height, samples] = std::array{scene.target.width, scene.target.height, scene.target.samples};
  depthPattern_ = pattern_;
  if (error_ == DeliberateError::DepthAtCentre) depthPattern_.assign(samples, {kSubpixelOne / 2, kSubpixelOne / 2});
  ditheredAlpha_ = rules.variation && rules.variation->ditheredAlpha;
  alphaComponent_ = error_ == DeliberateError::AlphaFromRed ? 0 : 3;
  masks_ = sampleMask_ != (1U << samples) - 1;
  const bool hasVaryings = !scene.draws.empty() && !scene.draws[0].varyings.empty();
  alpha_ = scene.state.alphaToCoverageEnable && hasVaryings && scene.draws[0].varyings[0].components == 4;
  frame_.width = width;
  frame_.height = height;
  frame_.samples = samples;
  frame_.primitive = Plane<uint32_t>(width, height, samples);
  frame_.count = Plane<uint32_t>(width, height, samples);
  if (rules.open || alpha_ || shaderMask_.isFree()) frame_.coverage.emplace(width, height, samples);
  if (needs.depth) {
    const Interpolated clear = clearedDepth(scene.target.depthClearValue, *scene.target.depthFormat);
    frame_.depth.emplace(width, height, samples, 1, clear.value);
    frame_.depthBounds.emplace(width, height, samples, 1, clear.bounds);
  }
  if (hasVaryings) {
    for (const Varying& varying : scene.draws[0].varyings) addPlane(varying.name, varying.components);
  }
  varyings_ = frame_.varyings.size();
  for (const BuiltIn builtIn : scene.builtIns) addPlane(builtInName(builtIn), builtInComponents(builtIn));
  if (LateValues::serve(scene, needs, values)) late_.emplace(state_, pattern_, openValues_, frame_, counts_);
}

void FrameWriter::beginPiece(uint32_t primitive, const PieceValues& values) {
  if (late_) late_->begin(primitive, values);
}

void FrameWriter::endPiece(const PieceValues& values) {
  if (late_) late_->end(values);
}

void FrameWriter::addPlane(std::string_view name, uint32_t components) {
  VaryingPlane plane{std::string(name), Plane<float>(frame_.width, frame_.height, frame_.samples, components), std::nullopt};
  plane.bounds.emplace(frame_.width, frame_.height, frame_.samples, components);
  frame_.varyings.push_back(std::move(plane));
}

// [vk:fragops-samplemask]
std::span<const RowSpan> FrameWriter::masked(std::span<const RowSpan> spans) {
  if (!masks_) return spans;
  masked_.assign(spans.begin(), spans.end());
  for (size_t s = 0; s < masked_.size(); ++s) {
    if ((sampleMask_ & (1U << s)) != 0) continue;
    counts_[Rule::SampleMask] += static_cast<uint64_t>(masked_[s].length());
    masked_[s] = {};
  }
  return masked_;
}

// [vk:fragops-covg] the shader's mask is ANDed to the coverage, before alpha is.
std::span<const RowSpan> FrameWriter::keptByShader(int32_t y, std::span<const RowSpan> spans) {
  const std::span<const RowSpan> kept = shaderMask_.kept(spans);
  for (uint32_t s = 0; s < spans.size(); ++s) {
    counts_[Rule::ShaderSampleMask] += static_cast<uint64_t>(std::max(0, spans[s].length() - kept[s].length()));
    if (open_ || !shaderMask_.isFree()) continue;
    for (int32_t x = spans[s].begin; x < spans[s].end; ++x) {
      frame_.coverage->at(static_cast<uint32_t>(x), static_cast<uint32_t>(y), s) = Coverage::Either;
    }
  }
  return kept;
}

void FrameWriter::fillCoverage(uint32_t primitive, int32_t y, std::span<const RowSpan> spans) {
  const bool firstWins = error_ == DeliberateError::FirstWins;
  uint64_t replaced = 0;
  for (size_t s = 0; s < spans.size(); ++s) {
    if (spans[s].empty()) continue;
    const size_t first = frame_.primitive.index(static_cast<uint32_t>(spans[s].begin), static_cast<uint32_t>(y), static_cast<uint32_t>(s));
    uint32_t* const winner = frame_.primitive.data.data() + first;
    uint32_t* const count = frame_.count.data.data() + first;
    const size_t end = static_cast<size_t>(spans[s].length()) * spans.size();
    for (size_t i = 0; i < end; i += spans.size()) {
      const bool again = winner[i] != 0;
      replaced += again ? 1 : 0;
      ++count[i];
      winner[i] = again && firstWins ? winner[i] : primitive;
    }
  }
  counts_[Rule::Order] += replaced;
}

void FrameWriter::expect(int32_t x, int32_t firstRow, int32_t lastRow) const {
#if defined(__GNUC__)
  const auto column = static_cast<uint32_t>(std::clamp(x, 0, static_cast<int32_t>(frame_.width) - 1));
  for (int32_t y = firstRow; y <= lastRow; ++y) {
    const size_t i = frame_.primitive.index(column, static_cast<uint32_t>(y), 0);
    __builtin_prefetch(&frame_.primitive.data[i], 1);
    __builtin_prefetch(&frame_.count.data[i], 1);
    if (!frame_.depth) continue;
    __builtin_prefetch(&frame_.depth->data[i], 1);
    if (!late_) __builtin_prefetch(&frame_.depthBounds->data[i], 1);
  }
#endif
}

void FrameWriter::writeRow(uint32_t primitive, PieceValues& values, int32_t y, std::span<const RowSpan> rasterized) {
  const std::span<const RowSpan> spans = masked(rasterized);
  const bool unmasked = error_ == DeliberateError::ShaderMaskOfUnmasked;
  const std::span<const RowSpan> kept = shaderMask_.writes() ? keptByShader(y, unmasked ? rasterized : spans) : spans;
  if (error_ != DeliberateError::None) mistakeRow(values, y, rasterized, kept);
  if (!frame_.depth && frame_.varyings.empty()) {
    fillCoverage(primitive, y, kept);
    return;
  }
  if (late_) {
    late_->writeRow(y, kept);
    return;
  }
  values_.resize(values.componentCount());
  int32_t begin = std::numeric_limits<int32_t>::max(), end = std::numeric_limits<int32_t>::min();
  for (const RowSpan& span : spans) {
    if (span.empty()) continue;
    begin = std::min(begin, span.begin);
    end = std::max(end, span.end);
  }
  for (int32_t x = begin; x < end; ++x) writePixel(primitive, values, x, y, spans, kept);
}

void FrameWriter::mistakeRow(const PieceValues& values, int32_t y, std::span<const RowSpan> rasterized, std::span<const RowSpan> kept) {
  const auto each = [&](const RowSpan& span, size_t s, const auto& visit) {
    for (int32_t x = span.begin; x < span.end; ++x) {
      visit(x, frame_.primitive.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(s)));
    }
  };
  for (size_t s = 0; s < rasterized.size(); ++s) {
    const RowSpan& span = rasterized[s];
    if (span.empty()) continue;
    if (error_ == DeliberateError::HelpersCounted) {
      // The other pixels of the quads at both ends.
      const RowSpan quads{span.begin & ~1, std::min((span.end + 1) & ~1, static_cast<int32_t>(frame_.width))};
      each({quads.begin, span.begin}, s, [&](int32_t, size_t index) { ++frame_.count.data[index]; });
      each({span.end, quads.end}, s, [&](int32_t, size_t index) { ++frame_.count.data[index]; });
    }
    const bool maskedOut = (sampleMask_ & (1U << s)) == 0;
    if (!frame_.depth || !state_.depthTestEnable || !state_.depthWriteEnable) continue;
    const auto writeDepth = [&](int32_t x, size_t index) {
      const float depth = values.depth(x + pattern_[s].x * kPixel, y + pattern_[s].y * kPixel).value;
      if (passesDepth(index, depth)) frame_.depth->data[index] = depth;
    };
    if (error_ == DeliberateError::SampleMaskAfterDepth && maskedOut) each(span, s, writeDepth);
    if (error_ == DeliberateError::ShaderMaskAfterDepth && !maskedOut) {
      const RowSpan left = kept[s].empty() ? RowSpan{span.end, span.end} : kept[s];
      each({span.begin, left.begin}, s, writeDepth);
      each({left.end, span.end}, s, writeDepth);
    }
  }
}

void FrameWriter::writePixel(uint32_t primitive, PieceValues& values, int32_t x, int32_t y, std::span<const RowSpan> covered,
                             std::span<const RowSpan> kept) {
  FragmentPlace place{x, y, 0, 0};
  if (values.needsMask()) {
    for (size_t s = 0; s < covered.size(); ++s) {
      if (x >= covered[s].begin && x < covered[s].end) place.covered |= 1U << s;
    }
  }
  bool evaluated = values_.empty();
  for (uint32_t s = 0; s < kept.size(); ++s) {
    if (x < kept[s].begin || x >= kept[s].end) continue;
    place.sample = s;
    if (!evaluated) values.fragment(place, values_.data());
    evaluated = !values.perSample() || values_.empty();
    if (alpha_ && !alphaKeeps(place)) continue;
    Interpolated depth;
    if (frame_.depth) {
      depth = values.depth(x + depthPattern_[s].x * kPixel, y + depthPattern_[s].y * kPixel);
      if (error_ == DeliberateError::DepthOffByOneStep) {
        depth.value = std::nextafter(depth.bounds.hi, std::numeric_limits<float>::infinity());
      }
    }
    writeSample(primitive, frame_.primitive.index(static_cast<uint32_t>(x), static_cast<uint32_t>(y), s),
                frame_.depth ? &depth : nullptr, values_.data());
  }
}

// [vk:fragops-covg] before the depth test.
bool FrameWriter::alphaKeeps(const FragmentPlace& place) {
  const Interpolated& alpha = values_[alphaComponent_];
  const float value = error_ == DeliberateError::AlphaInverted ? 1 - alpha.value : alpha.value;
  const uint32_t turned = ditheredAlpha_ ? (place.sample + static_cast<uint32_t>(place.x + 3 * place.y)) % frame_.samples : place.sample;
  const bool keeps = alphaCovers(value, turned, frame_.samples);
  if (!keeps) ++counts_[Rule::AlphaToCoverage];
  if (!open_) {
    Coverage& known = frame_.coverage->at(static_cast<uint32_t>(place.x), static_cast<uint32_t>(place.y), place.sample);
    const Coverage legal = shaderMask_.isFree() ? Coverage::Either : alphaCoverage(alpha.bounds);
    if (known != Coverage::In && legal != Coverage::Out) known = legal;
  }
  return keeps;
}

bool FrameWriter::passesDepth(size_t index, float fragment) {
  if (frame_.primitive.data[index] != 0 && fragment == frame_.depth->data[index]) ++counts_[Rule::Invariance];
  if (depthTestPasses(state_.depthCompareOp, fragment, frame_.depth->data[index])) return true;
  ++counts_[Rule::DepthTest];
  return false;
}

void FrameWriter::writeSample(uint32_t primitive, size_t index, const Interpolated* depth, const Interpolated* values) {
  uint32_t& winner = frame_.primitive.data[index];
  // Edges of one triangle may overlap, and which of them is drawn last is not stated.
  const bool again = winner == primitive && openValues_;
  if (depth != nullptr && state_.depthTestEnable) {
    if (!passesDepth(index, depth->value)) {
      if (error_ == DeliberateError::DepthWriteAfterFailure && state_.depthWriteEnable) frame_.depth->data[index] = depth->value;
      return;
    }
    // [vk:fragops-depth] without the depth test, depth is not written either.
    if (state_.depthWriteEnable) {
      frame_.depth->data[index] = depth->value;
      set(frame_.depthBounds->data[index], depth->bounds, again);
    }
  }
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
      set(plane.bounds->data[index * components + c], values->bounds, again);
      ++values;
    }
  }
}

void FrameWriter::markCoverage(int32_t y, uint32_t sample, RowSpan certain) {
  for (int32_t x = certain.begin; x < certain.end; ++x) markCoverage(x, y, sample, Coverage::In);
}

void FrameWriter::markCoverage(int32_t x, int32_t y, uint32_t sample, Coverage coverage) {
  if (coverage == Coverage::Out || (sampleMask_ & (1U << sample)) == 0) return;
  // Nor are the fragment's other samples, so a mask that is made of them is as if all of them were free.
  const Coverage shader = shaderMask_.keeps(sample, 0, ~0U);
  if (shader == Coverage::Out) return;
  Coverage& known = frame_.coverage->at(static_cast<uint32_t>(x), static_cast<uint32_t>(y), sample);
  // What alpha keeps of it is not this function's to know.
  if (known != Coverage::In) known = alpha_ ? Coverage::Either : std::max(coverage, shader);
}

Frame FrameWriter::take(PieceValues& values) {
  if (late_) late_->settle(values);
  for (size_t v = 0; resolve_ && v < varyings_; ++v) {
    frame_.resolved.push_back(resolved(frame_.varyings[v], rules_, counts_));
  }
  if (depthResolveMode_) {
    frame_.resolved.push_back(resolvedDepth(*frame_.depth, *frame_.depthBounds, *depthResolveMode_, depthFormat_, error_, counts_));
  }
  return std::move(frame_);
}

}  // namespace rasterdiff::rasterizer
