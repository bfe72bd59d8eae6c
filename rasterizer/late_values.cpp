#include "rasterizer/late_values.hpp"

#include <algorithm>

#include "rasterizer/depth_test.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kPixel = 1.0 / kSubpixelOne;

Bounds hull(const Bounds& a, const Bounds& b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

}  // namespace

bool LateValues::serve(const Scene& scene, const SceneNeeds& needs, const PieceValues& values) {
  return fillsTriangles(scene.state) && !scene.state.alphaToCoverageEnable &&
         (needs.depth || needs.varyings > 0) && values.mayWait();
}

LateValues::LateValues(const State& state, std::span<const SubpixelPosition> pattern, bool widen, Frame& frame, RuleCounts& counts)
    : state_(state), pattern_(pattern), widen_(widen), frame_(frame), counts_(counts) {}

void LateValues::begin(uint32_t primitive, const PieceValues& values) {
  piece_ = static_cast<uint32_t>(primitives_.size()) + 1;
  if (primitives_.empty() || primitives_.back() != primitive) firstOfPrimitive_ = piece_;
  primitives_.push_back(primitive);
  depth_ = values.depthPlane();
  written_ = false;
}

// A piece that no sample keeps needs no planes.
void LateValues::end(const PieceValues& values) {
  if (written_) {
    values.save(planes_, constants_);
  } else {
    primitives_.pop_back();
  }
}

// The same arithmetic, in the same order, as LinearFunction::at; no branches, which random depths would make unpredictable.
template <size_t kStride, class Passes>
void LateValues::drawSpan(int32_t y, uint32_t sample, RowSpan span, Passes passes) {
  const size_t stride = kStride == 0 ? pattern_.size() : kStride;
  const size_t first = frame_.primitive.index(static_cast<uint32_t>(span.begin), static_cast<uint32_t>(y), sample);
  rememberHidden(first, span.length(), stride);
  const double offset = pattern_[sample].x * kPixel, x0 = depth_.x0, value = depth_.value, dx = depth_.dx;
  const double rise = depth_.dy * (y + pattern_[sample].y * kPixel - depth_.y0);
  uint32_t* const winner = frame_.primitive.data.data() + first;
  uint32_t* const count = frame_.count.data.data() + first;
  float* const stored = frame_.depth->data.data() + first;
  const uint32_t piece = piece_;
  const bool writes = state_.depthWriteEnable;
  uint32_t drawnBefore = 0, equal = 0, passed = 0;
  for (int32_t k = 0; k < span.length(); ++k) {
    const size_t i = static_cast<size_t>(k) * stride;
    const auto z = static_cast<float>(value + dx * (span.begin + k + offset - x0) + rise);
    const float old = stored[i];
    const uint32_t before = winner[i] != 0 ? 1 : 0;
    const uint32_t pass = passes(z, old) ? 1 : 0;
    equal += before & (z == old ? 1U : 0U);
    passed += pass;
    drawnBefore += before & pass;
    stored[i] = pass != 0 && writes ? z : old;
    winner[i] = pass != 0 ? piece : winner[i];
    count[i] += pass;
  }
  written_ = written_ || passed > 0;
  counts_[Rule::Invariance] += equal;
  counts_[Rule::DepthTest] += static_cast<uint32_t>(span.length()) - passed;
  counts_[Rule::Order] += drawnBefore;
}

void LateValues::drawSpanUndeep(int32_t y, uint32_t sample, RowSpan span) {
  const size_t first = frame_.primitive.index(static_cast<uint32_t>(span.begin), static_cast<uint32_t>(y), sample);
  rememberHidden(first, span.length(), pattern_.size());
  uint32_t drawnBefore = 0;
  for (int32_t k = 0; k < span.length(); ++k) {
    const size_t i = first + static_cast<size_t>(k) * pattern_.size();
    drawnBefore += frame_.primitive.data[i] != 0 ? 1U : 0U;
    frame_.primitive.data[i] = piece_;
    ++frame_.count.data[i];
  }
  written_ = true;
  counts_[Rule::Order] += drawnBefore;
}

// Pieces of one primitive may overlap where snapping folded them.
void LateValues::rememberHidden(size_t first, int32_t length, size_t stride) {
  if (!widen_ || firstOfPrimitive_ == piece_) return;
  for (int32_t k = 0; k < length; ++k) {
    const size_t i = first + static_cast<size_t>(k) * stride;
    if (frame_.primitive.data[i] >= firstOfPrimitive_) hidden_.push_back({i, frame_.primitive.data[i]});
  }
}

template <class Passes>
void LateValues::drawSpans(int32_t y, std::span<const RowSpan> spans, Passes passes) {
  for (uint32_t s = 0; s < spans.size(); ++s) {
    if (spans[s].empty()) continue;
    if (spans.size() == 1) {
      drawSpan<1>(y, s, spans[s], passes);
    } else {
      drawSpan<0>(y, s, spans[s], passes);
    }
  }
}

void LateValues::writeRow(int32_t y, std::span<const RowSpan> spans) {
  if (!frame_.depth || !state_.depthTestEnable) {
    for (uint32_t s = 0; s < spans.size(); ++s) {
      if (!spans[s].empty()) drawSpanUndeep(y, s, spans[s]);
    }
  } else if (state_.depthCompareOp == CompareOp::LESS) {
    drawSpans(y, spans, [](float z, float stored) { return z < stored; });
  } else {
    drawSpans(y, spans, [op = state_.depthCompareOp](float z, float stored) { return depthTestPasses(op, z, stored); });
  }
}

void LateValues::restore(PieceValues& values, uint32_t piece) {
  if (piece == restored_) return;
  values.restore(piece - 1, planes_, constants_);
  restored_ = piece;
}

bool LateValues::writesDepth() const { return frame_.depth && state_.depthTestEnable && state_.depthWriteEnable; }

Bounds LateValues::depthBounds(const PieceValues& values, size_t x, size_t y, size_t sample) const {
  const SubpixelPosition& at = pattern_[sample];
  const Spot spot{static_cast<double>(x) + at.x * kPixel, static_cast<double>(y) + at.y * kPixel};
  return roundedDepth(linearOver(values.depthPlane(), pixelRegion<0>(spot))).bounds;
}

template <class Write>
void LateValues::forEachInput(size_t sample, Write write) {
  const Interpolated* input = inputs_.data();
  for (VaryingPlane& plane : frame_.varyings) {
    const size_t components = plane.values.components;
    for (size_t c = sample * components; c < (sample + 1) * components; ++c, ++input) {
      write(plane.values.data[c], plane.bounds->data[c], *input);
    }
  }
}

void LateValues::settle(PieceValues& values) {
  const auto samples = static_cast<uint32_t>(pattern_.size());
  inputs_.resize(values.componentCount());
  size_t index = 0;
  for (uint32_t y = 0; y < frame_.height; ++y) {
    for (uint32_t x = 0; x < frame_.width; ++x) {
      const FragmentPlace place{static_cast<int32_t>(x), static_cast<int32_t>(y), 0, 0};
      uint32_t evaluated = 0;
      for (uint32_t s = 0; s < samples; ++s, ++index) {
        uint32_t& winner = frame_.primitive.data[index];
        if (winner == 0) continue;
        restore(values, winner);
        if (writesDepth()) frame_.depthBounds->data[index] = depthBounds(values, x, y, s);
        if (evaluated != winner && !inputs_.empty()) values.fragment(place, inputs_.data());
        evaluated = winner;
        forEachInput(index, [](float& value, Bounds& bounds, const Interpolated& input) {
          value = input.value;
          bounds = input.bounds;
        });
        winner = primitives_[winner - 1];
      }
    }
  }
  widenHidden(values);
}

void LateValues::widenHidden(PieceValues& values) {
  for (const Hidden& hidden : hidden_) {
    if (frame_.primitive.data[hidden.sample] != primitives_[hidden.piece - 1]) continue;
    restore(values, hidden.piece);
    const size_t pixel = hidden.sample / pattern_.size();
    const size_t x = pixel % frame_.width, y = pixel / frame_.width;
    if (writesDepth()) {
      Bounds& bounds = frame_.depthBounds->data[hidden.sample];
      bounds = hull(bounds, depthBounds(values, x, y, hidden.sample % pattern_.size()));
    }
    const FragmentPlace place{static_cast<int32_t>(x), static_cast<int32_t>(y), 0, 0};
    if (!inputs_.empty()) values.fragment(place, inputs_.data());
    forEachInput(hidden.sample, [](float&, Bounds& bounds, const Interpolated& input) { bounds = hull(bounds, input.bounds); });
  }
}

}  // namespace rasterdiff::rasterizer
