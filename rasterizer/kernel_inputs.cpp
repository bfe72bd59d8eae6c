#include "rasterizer/kernel_inputs.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {

KernelInputs::KernelInputs(const Scene& scene, const SceneNeeds& needs, const Rules& rules, const KernelGeometry& geometry, Frame& frame)
    : geometry_(geometry), frame_(frame), values_(scene, needs, rules), kinds_(values_.lateKinds()), anywhere_(values_.lateAnywhere()) {
  for (size_t d = 0; d < scene.draws.size(); ++d) {
    makers_.push_back(std::make_unique<PrimitiveMaker>(scene, rules, scene.draws[d], geometry.isClipped(d), ignored_, [this](const Primitive& primitive) {
      values_.setUp(primitive, primitive.pieces[place_]);
      values_.save(planes_, constants_);
    }));
  }
  const bool divides = std::ranges::find(kinds_, ValueKind::Perspective) != kinds_.end();
  reciprocalW_ = needs.depth ? 1 : 0;
  planesEach_ = reciprocalW_ + (divides ? 1 : 0) + kinds_.size();
}

void KernelInputs::clear() {
  planes_.clear();
  constants_.clear();
}

void KernelInputs::add(uint32_t primitive, uint8_t place) {
  place_ = place;
  const KernelGeometry::Assembled made = geometry_.assembled(primitive);
  makers_[made.draw]->make(primitive, made.triangle);
}

void KernelInputs::settle(std::span<const SettledRun> runs, uint32_t y, uint32_t sample, const uint32_t* numbers, const uint32_t* firstNumbers) {
  rows_.clear();
  for (VaryingPlane& plane : frame_.varyings) {
    for (uint32_t c = 0; c < plane.values.components; ++c) {
      const size_t from = plane.values.index(0, y, sample, c);
      rows_.push_back({plane.values.data.data() + from, plane.bounds->data.data() + from, size_t{frame_.samples} * plane.values.components});
    }
  }
  own_.clear();
  if (sample == 0) {
    std::ranges::copy_if(runs, std::back_inserter(own_), [](const SettledRun& run) { return run.plane != 0; });
  } else {
    copyFromFirst(runs, y, sample, numbers, firstNumbers);
  }
  settleInputs(own_, {kinds_, planes_, planesEach_, reciprocalW_, constants_, anywhere_}, y, rows_);
}

void KernelInputs::copyFromFirst(std::span<const SettledRun> runs, uint32_t y, uint32_t sample, const uint32_t* numbers, const uint32_t* firstNumbers) {
  for (const SettledRun& run : runs) {
    if (run.plane == 0) continue;
    uint32_t x = run.begin;
    while (x < run.end) {
      SettledRun part = run;
      part.begin = x;
      while (x < run.end && numbers[x] != firstNumbers[x]) ++x;
      part.end = x;
      if (part.begin < part.end) own_.push_back(part);
      const uint32_t from = x;
      while (x < run.end && numbers[x] == firstNumbers[x]) ++x;
      for (VaryingPlane& plane : frame_.varyings) {
        const size_t components = plane.values.components, back = sample * components;
        for (uint32_t pixel = from; pixel < x; ++pixel) {
          const size_t to = plane.values.index(pixel, y, sample);
          std::copy_n(plane.values.data.data() + to - back, components, plane.values.data.data() + to);
          std::copy_n(plane.bounds->data.data() + to - back, components, plane.bounds->data.data() + to);
        }
      }
    }
  }
}

}  // namespace rasterdiff::rasterizer
