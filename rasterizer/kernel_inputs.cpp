#include "rasterizer/kernel_inputs.hpp"

#include <algorithm>
#include <utility>

#include "rasterizer/edge_function.hpp"

namespace rasterdiff::rasterizer {

KernelInputs::KernelInputs(const Scene& scene, const SceneNeeds& needs, const Rules& rules, const KernelGeometry& geometry, Frame& frame)
    : scene_(scene), geometry_(geometry), frame_(frame), values_(scene, needs, rules), kinds_(values_.lateKinds()), anywhere_(values_.lateAnywhere()) {
  for (size_t d = 0; d < scene.draws.size(); ++d) {
    makers_.push_back(std::make_unique<PrimitiveMaker>(scene, rules, scene.draws[d], geometry.isClipped(d), ignored_, [this](const Primitive& primitive) {
      values_.setUp(primitive, primitive.pieces[place_]);
      values_.save(planes_, constants_);
    }));
  }
  whole_.polygon.resize(3);
  for (size_t i = 0; i < 3; ++i) {
    RasterVertex& vertex = whole_.polygon[i];
    vertex.smoothWeights = vertex.linearWeights = {};
    vertex.smoothWeights[i] = vertex.linearWeights[i] = 1;
  }
  const bool divides = std::ranges::find(kinds_, ValueKind::Perspective) != kinds_.end();
  reciprocalW_ = needs.depth ? 1 : 0;
  planesEach_ = reciprocalW_ + (divides ? 1 : 0) + kinds_.size();
}

void KernelInputs::clear() {
  planes_.clear();
  constants_.clear();
}

void KernelInputs::add(uint32_t primitive, const PieceOrigin& origin) {
  const KernelGeometry::Assembled made = geometry_.assembled(primitive);
  if (!origin.made) return addWhole(primitive, made);
  place_ = origin.place;
  makers_[made.draw]->make(primitive, made.triangle);
}

// From what was staged: the same bits as geometry.hpp's. PieceValues that may wait ask for nothing else.
void KernelInputs::addWhole(uint32_t primitive, const KernelGeometry::Assembled& made) {
  const StagedVertices& staged = geometry_.vertices();
  const uint32_t first = geometry_.firstVertex(made.draw);
  whole_.number = primitive;
  whole_.draw = &scene_.draws[made.draw];
  whole_.assembled = made.triangle;
  for (size_t i = 0; i < 3; ++i) {
    const uint32_t at = made.triangle.vertices[i];
    const DepthVertex& v = staged.depths[first + at];
    RasterVertex& vertex = whole_.polygon[i];
    vertex.position = {v.x, v.y, v.z};
    vertex.deviation = v.deviation;
    vertex.depthError = v.error;
    vertex.snapped = staged.snapped[first + at];
    vertex.reciprocalW = 1.0 / whole_.draw->positions[at].w;
  }
  SetupTriangle piece;
  piece.corner = {0, 1, 2};
  if (doubleArea(whole_.polygon[0].snapped, whole_.polygon[1].snapped, whole_.polygon[2].snapped) < 0) std::swap(piece.corner[1], piece.corner[2]);
  values_.setUp(whole_, piece);
  values_.save(planes_, constants_);
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
