#include "rasterizer/kernel_frame.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/depth/format.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/parallel.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr size_t kBandBytes = size_t{3} << 19;      // of a band's planes: they should stay in the cache
constexpr uint32_t kLeastRows = 16, kMostRows = 256;  // of a band

bool ownsTopLeft(const Choices& choices) {
  return choices.tieOwner == TieOwner::TopLeft && choices.slantedTies == SlantedTies::LikeVertical && choices.tieWinding == TieWinding::Same;
}

// Primitive, count, inputs that may wait, and at most a depth that is tested by LESS and written.
bool needsNothingElse(const Scene& scene, const SceneNeeds& needs, const Rules& rules) {
  const uint32_t all = (1U << scene.target.samples) - 1;
  const State& state = scene.state;
  if (needs.builtIns > 0 || state.alphaToCoverageEnable || needs.resolve || scene.target.depthResolveMode || (state.sampleMask & all) != all) return false;
  if (state.shaderSampleMask != ShaderSampleMask::NONE) return false;
  if (needs.depth && !(state.depthTestEnable && state.depthWriteEnable && state.depthCompareOp == CompareOp::LESS)) return false;
  return (!needs.depth && needs.varyings == 0) || PieceValues(scene, needs, rules).mayWait();
}

bool onlyTargetCuts(const Scene& scene, const Rules& rules) {
  const PixelArea whole = wholeTarget(scene);
  for (uint32_t index = 0; index <= scene.furtherViewports.size(); ++index) {
    const PixelArea area = drawingRegion(scene, index, rules).area;
    if (area.left != whole.left || area.top != whole.top || area.right != whole.right || area.bottom != whole.bottom) return false;
  }
  return true;
}

bool cutsByDistance(const Scene& scene) {
  return std::ranges::any_of(scene.draws, [](const Draw& draw) { return draw.clipDistanceCount > 0; });
}

bool atStandardLocations(uint32_t samples, std::span<const SubpixelPosition> pattern) {
  return std::ranges::equal(standardSampleLocations(samples), pattern, [](const SampleLocation& location, const SubpixelPosition& offset) {
    return location.x * kSampleUnit == offset.x && location.y * kSampleUnit == offset.y;
  });
}

BandRows bandRows(const Scene& scene) {
  const size_t rowBytes = size_t{scene.target.width} * scene.target.samples * (scene.target.depthFormat ? 12 : 8);
  const size_t rows = std::clamp<size_t>(kBandBytes / rowBytes, kLeastRows, kMostRows);
  return {static_cast<uint32_t>(std::bit_width(rows)) - 1};
}

// Every sample of which the bands write, but for inputs: they are written where something is drawn.
Frame unwrittenFrame(const Scene& scene) {
  const auto [width, height, samples] = std::array{scene.target.width, scene.target.height, scene.target.samples};
  Frame frame;
  frame.width = width, frame.height = height, frame.samples = samples;
  frame.primitive = Plane<uint32_t>::unwritten(width, height, samples);
  frame.count = Plane<uint32_t>::unwritten(width, height, samples);
  if (!scene.draws.empty()) {
    for (const Varying& varying : scene.draws[0].varyings) {
      VaryingPlane& plane = frame.varyings.emplace_back(VaryingPlane{varying.name, {width, height, samples, varying.components}, {}});
      plane.bounds.emplace(width, height, samples, varying.components);
    }
  }
  if (!scene.target.depthFormat) return frame;
  frame.depth = Plane<float>::unwritten(width, height, samples);
  frame.depthBounds = Plane<Bounds>::unwritten(width, height, samples);
  return frame;
}

void count(RuleCounts& counts, const BandTally& tally, bool deep) {
  counts[Rule::SampleCoverage] += tally.rows.inside;
  counts[Rule::TieBreak] += tally.rows.ties;
  counts[Rule::HelperInvocation] += tally.rows.cutQuads;
  counts[Rule::SamplePattern] += tally.rows.partlyCovered;
  counts[Rule::Order] += tally.drawn - tally.covered;
  counts[Rule::ClipAttribute] += tally.ofCut;
  counts[Rule::CutPolygon] += tally.ofMany;
  if (!deep) return;
  counts[Rule::LinearDepth] += tally.rows.inside;
  counts[Rule::DepthTest] += tally.rows.inside - tally.drawn;
  counts[Rule::Invariance] += tally.met;
}

}  // namespace

std::optional<KernelFrame> KernelFrame::of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern) {
  const bool ruled = !rules.open && rules.error == DeliberateError::None && !rules.variation && ownsTopLeft(rules.choices);
  if (!ruled || !fillsTriangles(scene.state) || !onlyTargetCuts(scene, rules)) return std::nullopt;
  const SceneNeeds needs = needsOf(scene);
  if (!needsNothingElse(scene, needs, rules)) return std::nullopt;
  if (cutsByDistance(scene) || !atStandardLocations(scene.target.samples, pattern)) return std::nullopt;
  return KernelFrame(scene, needs, rules, pattern);
}

std::optional<Frame> KernelFrame::draw(unsigned threads, RuleCounts* counts, const RowsDrawn& drawn) const {
  const bool counted = counts != nullptr;
  const BandRows rows = bandRows(scene_);
  std::vector<RuleCounts> decided(threads);
  const KernelGeometry geometry(scene_, rules_, rows, decided);
  if (geometry.folded()) return std::nullopt;

  const Interpolated clear = scene_.target.depthFormat ? clearedDepth(scene_.target.depthClearValue, *scene_.target.depthFormat) : Interpolated{};
  Frame frame = unwrittenFrame(scene_);
  const uint32_t bands = rows.bandsOf(frame.height);
  std::atomic<uint32_t> next = 0;
  std::vector<BandTally> tallies(threads);
  inParallel(threads, [&](unsigned thread) {
    std::unique_ptr<KernelInputs> inputs;
    if (!frame.varyings.empty()) inputs = std::make_unique<KernelInputs>(scene_, needs_, rules_, geometry, frame);
    BandDrawer drawer(geometry, frame, pattern_, clear, rows, std::move(inputs));
    for (uint32_t band = next++; band < bands; band = next++) {
      tallies[thread] += drawer.draw(band, counted);
      if (drawn) drawn(frame, band << rows.shift, std::min((band + 1) << rows.shift, frame.height));
    }
  });
  if (!counted) return frame;
  BandTally all;
  for (const BandTally& tally : tallies) all += tally;
  count(*counts, all, frame.depth.has_value());
  for (const RuleCounts& part : decided) *counts += part;
  return frame;
}

}  // namespace rasterdiff::rasterizer
