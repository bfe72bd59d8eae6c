#include "rasterizer/kernel_frame.hpp"

#include <algorithm>
#include <atomic>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/depth/format.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/fragment/plane_corners.hpp"
#include "rasterizer/geometry_parts.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/parallel.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint64_t kFewTriangles = 1000;            // drawn one by one sooner than they are sorted into bands
constexpr size_t kBandBytes = size_t{3} << 20;      // of a band's planes: they should stay in the cache
constexpr uint32_t kLeastRows = 16, kMostRows = 256;  // of a band

bool ownsTopLeft(const Choices& choices) {
  return choices.tieOwner == TieOwner::TopLeft && choices.slantedTies == SlantedTies::LikeVertical && choices.tieWinding == TieWinding::Same;
}

// Primitive, count and at most a depth that is tested by LESS and written.
bool needsNothingElse(const Scene& scene, const SceneNeeds& needs, const Rules& rules) {
  const uint32_t all = (1U << scene.target.samples) - 1;
  const State& state = scene.state;
  if (needs.varyings > 0 || needs.builtIns > 0 || needs.resolve || scene.target.depthResolveMode || (state.sampleMask & all) != all) return false;
  if (state.shaderSampleMask != ShaderSampleMask::NONE) return false;
  if (!needs.depth) return true;
  return state.depthTestEnable && state.depthWriteEnable && state.depthCompareOp == CompareOp::LESS &&
         PieceValues(scene, needs, rules).mayWait();
}

bool drawsManyTriangles(const Scene& scene) {
  return fillsTriangles(scene.state) && primitiveCount(scene) > kFewTriangles;
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

uint32_t bandRows(const Scene& scene) {
  const size_t rowBytes = size_t{scene.target.width} * scene.target.samples * (scene.target.depthFormat ? 12 : 8);
  return static_cast<uint32_t>(std::clamp<size_t>(kBandBytes / rowBytes, kLeastRows, kMostRows)) / 8 * 8;
}

Frame emptyFrame(const Scene& scene) {
  const auto [width, height, samples] = std::array{scene.target.width, scene.target.height, scene.target.samples};
  Frame frame;
  frame.width = width, frame.height = height, frame.samples = samples;
  frame.primitive = Plane<uint32_t>(width, height, samples);
  frame.count = Plane<uint32_t>(width, height, samples);
  if (!scene.target.depthFormat) return frame;
  frame.depth.emplace(width, height, samples);
  frame.depthBounds.emplace(width, height, samples);
  return frame;
}

// Sorts the pieces of primitives into bands.
class PieceSorter {
 public:
  PieceSorter(const Scene& scene, const Rules& rules, uint32_t rows)
      : places_(rules), deep_(scene.target.depthFormat.has_value()), mayWiden_(rules.openValues()), rows_(static_cast<int32_t>(rows)),
        bands_((scene.target.height + rows - 1) / rows) {}

  void add(const Primitive& primitive) {
    if (mayWiden_) overlap_ = overlap_ || isFolded(primitive.polygon, CutFill::Polygon);
    for (const SetupTriangle& piece : primitive.pieces) {
      if (!piece.culled) addPiece(primitive, piece);
    }
  }

  [[nodiscard]] bool overlap() const { return overlap_; }
  [[nodiscard]] const std::vector<BandPieces>& bands() const { return bands_; }

 private:
  void addPiece(const Primitive& primitive, const SetupTriangle& piece) {
    const std::array<const RasterVertex*, 3> v{&primitive.polygon[piece.corner[0]], &primitive.polygon[piece.corner[1]],
                                               &primitive.polygon[piece.corner[2]]};
    const auto [low, high] = std::minmax({v[0]->snapped.y, v[1]->snapped.y, v[2]->snapped.y});
    const int32_t first = std::max(low >> kSubpixelBits, 0) / rows_;
    const int32_t last = std::min((high >> kSubpixelBits) / rows_, static_cast<int32_t>(bands_.size()) - 1);
    if (high < 0 || first > last) return;
    DepthCorners corners;
    CornerErrors errors;
    if (deep_) {
      const PlaneCorners plane = planeCorners(places_, v);
      errors.deviation = plane.deviation;
      for (size_t i = 0; i < 3; ++i) {
        corners.x[i] = plane.corners[i].x, corners.y[i] = plane.corners[i].y, corners.z[i] = plane.corners[i].z;
        errors.inputError = std::max(errors.inputError, v[i]->depthError);
      }
    }
    for (int32_t band = first; band <= last; ++band) {
      BandPieces& pieces = bands_[static_cast<size_t>(band)];
      pieces.positions.push_back({{v[0]->snapped, v[1]->snapped, v[2]->snapped}});
      pieces.primitives.push_back(primitive.number);
      if (!deep_) continue;
      pieces.corners.push_back(corners);
      pieces.errors.push_back(errors);
    }
  }

  const PlanePlaces places_;
  const bool deep_, mayWiden_;
  const int32_t rows_;
  bool overlap_ = false;
  std::vector<BandPieces> bands_;
};

void count(RuleCounts& counts, const BandTally& tally, bool deep) {
  counts[Rule::SampleCoverage] += tally.rows.inside;
  counts[Rule::TieBreak] += tally.rows.ties;
  counts[Rule::HelperInvocation] += tally.rows.cutQuads;
  counts[Rule::SamplePattern] += tally.rows.partlyCovered;
  counts[Rule::Order] += tally.drawn - tally.covered;
  if (!deep) return;
  counts[Rule::LinearDepth] += tally.rows.inside;
  counts[Rule::DepthTest] += tally.rows.inside - tally.drawn;
  counts[Rule::Invariance] += tally.met;
}

}  // namespace

std::optional<KernelFrame> KernelFrame::of(const Scene& scene, const Rules& rules, std::span<const SubpixelPosition> pattern) {
  const bool ruled = !rules.open && rules.error == DeliberateError::None && !rules.variation && ownsTopLeft(rules.choices);
  if (!ruled || !drawsManyTriangles(scene) || !needsNothingElse(scene, needsOf(scene), rules) || !onlyTargetCuts(scene, rules)) return std::nullopt;
  if (rules.choices.cutFill != CutFill::Fan && mayClip(scene)) return std::nullopt;  // a cut polygon may be folded
  if (cutsByDistance(scene) || !atStandardLocations(scene.target.samples, pattern)) return std::nullopt;
  return KernelFrame(scene, rules, pattern);
}

std::optional<Frame> KernelFrame::draw(unsigned threads, RuleCounts* counts) const {
  const bool counted = counts != nullptr;
  const uint32_t rows = bandRows(scene_);
  std::vector<PieceSorter> sorters(threads, PieceSorter(scene_, rules_, rows));
  std::vector<RuleCounts> decided(threads);
  std::vector<PrimitiveVisitor> visitors;
  for (PieceSorter& sorter : sorters) visitors.emplace_back([&sorter](const Primitive& primitive) { sorter.add(primitive); });
  forEachPrimitive(scene_, rules_, decided, visitors);
  if (std::ranges::any_of(sorters, [](const PieceSorter& sorter) { return sorter.overlap(); })) return std::nullopt;

  const Interpolated clear = scene_.target.depthFormat ? clearedDepth(scene_.target.depthClearValue, *scene_.target.depthFormat) : Interpolated{};
  Frame frame = emptyFrame(scene_);
  std::atomic<size_t> next = 0;
  std::vector<BandTally> tallies(threads);
  inParallel(threads, [&](unsigned thread) {
    BandDrawer drawer(frame, pattern_, clear, rows);
    std::vector<const BandPieces*> pieces(threads);
    for (size_t band = next++; band < sorters[0].bands().size(); band = next++) {
      std::ranges::transform(sorters, pieces.begin(), [band](const PieceSorter& sorter) { return &sorter.bands()[band]; });
      const auto firstRow = static_cast<uint32_t>(band) * rows;
      tallies[thread] += drawer.draw(pieces, firstRow, std::min(firstRow + rows, frame.height), counted);
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
