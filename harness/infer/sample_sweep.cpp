#include "harness/infer/sample_sweep.hpp"

#include <algorithm>

#include "harness/infer/scene_sketch.hpp"
#include "harness/profile/sample_tables.hpp"
#include "rasterizer/edge_function.hpp"

namespace rasterdiff::harness {
namespace {

constexpr uint32_t kSteps = 17;  // 0 .. 16 sixteenths
constexpr uint32_t kCell = 16;   // pixels
constexpr uint32_t kEdge = 4;    // pixel of a cell that the edge crosses

// One cell a step: left edges in the upper row, top edges in the lower one. Wound alike.
Scene sweepScene(uint32_t samples) {
  SceneSketch sketch("infer/samples", samples, 512);
  sketch.scene().target.height = 2 * kCell;
  sketch.scene().viewport.height = 2 * kCell;
  for (uint32_t step = 0; step < kSteps; ++step) {
    const double x = step * kCell, offset = kEdge + step / 16.0;
    const auto at = [](double px, double py) { return PixelPosition{px, py, 0.5, 1}; };
    sketch.triangle(at(x + offset, 0), at(x + offset + 10, 8), at(x + offset, 16));
    sketch.triangle(at(x, kCell + offset), at(x + 16, kCell + offset), at(x + 8, kCell + offset + 10));
  }
  return std::move(sketch.scene());
}

rasterizer::SampleTables::Offset place(int32_t lastLeft, int32_t lastTop, bool leftOwns, bool topOwns) {
  const auto sixteenths = [](int32_t last, bool owns) { return std::clamp(owns ? last : last + 1, 0, 15); };
  return {static_cast<uint8_t>(sixteenths(lastLeft, leftOwns) * 16), static_cast<uint8_t>(sixteenths(lastTop, topOwns) * 16)};
}

}  // namespace

Result<SampleSweep> sweepSamples(Subject& subject, uint32_t samples) {
  const Result<Frame> frame = subject.render(sweepScene(samples));
  if (!frame) return tl::unexpected(frame.error());
  SampleSweep sweep{samples, std::vector<int32_t>(samples, -1), std::vector<int32_t>(samples, -1)};
  for (uint32_t step = 0; step < kSteps; ++step) {
    for (uint32_t s = 0; s < samples; ++s) {
      const auto last = static_cast<int32_t>(step);
      if (frame->count.at(step * kCell + kEdge, kCell / 2 - 1, s) != 0) sweep.lastLeft[s] = last;
      if (frame->count.at(step * kCell + kCell / 2 - 1, kCell + kEdge, s) != 0) sweep.lastTop[s] = last;
    }
  }
  return sweep;
}

void placeSamples(std::span<const SampleSweep> sweeps, rasterizer::Choices& choices) {
  const rasterizer::TieRule ties = rasterizer::tieRule(choices);
  const bool leftOwns = rasterizer::ownsTies(ties, 0, -1), topOwns = rasterizer::ownsTies(ties, 1, 0);
  const rasterizer::SampleTables standard = standardTables();
  rasterizer::SampleTables tables = standard;
  for (const SampleSweep& sweep : sweeps) {
    for (uint32_t s = 0; s < sweep.samples; ++s) {
      tables.of(sweep.samples)[s] = place(sweep.lastLeft[s], sweep.lastTop[s], leftOwns, topOwns);
    }
  }
  choices.sampleLocations.reset();
  if (tables != standard) choices.sampleLocations = tables;
}

}  // namespace rasterdiff::harness
