#include "rasterizer/kernel_pieces.hpp"

#include <algorithm>
#include <utility>

#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/geometry_parts.hpp"
#include "rasterizer/parallel.hpp"
#include "rasterizer/piece_maker.hpp"
#include "rasterizer/target_area.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint32_t kVerticesAtOnce = 1024;  // of one thread, a multiple of every vector's length

bool readsIndicesAsTheyAre(const State& state) {
  return state.topology == PrimitiveTopology::TRIANGLE_LIST && !state.primitiveRestartEnable;
}

bool hasInputs(const Scene& scene) { return !scene.draws.empty() && !scene.draws[0].varyings.empty(); }

bool hasFlat(const Scene& scene) {
  return hasInputs(scene) && std::ranges::any_of(scene.draws[0].varyings, [](const Varying& v) { return v.interpolation == Interpolation::flat; });
}

size_t vertexCountOf(const Scene& scene) {
  size_t vertices = 0;
  for (const Draw& draw : scene.draws) vertices += draw.positions.size();
  return vertices;
}

}  // namespace

/// Fills one part from a range of primitives.
class KernelGeometry::Maker {
 public:
  Maker(const KernelGeometry& all, KernelPieces& part, RuleCounts& counts)
      : all_(all), part_(part), counts_(counts), places_(all.rules_), pieceMaker_(all.scene_.state, all.rules_, counts),
        deep_(all.scene_.target.depthFormat.has_value()), inputs_(hasInputs(all.scene_)),
        flat_(hasFlat(all.scene_)), mayWiden_(all.rules_.openValues()) {
    part_.bands.resize(all.rows_.bandsOf(all.scene_.target.height));
  }

  void reserve(size_t pieces) {
    part_.positions.reserve(pieces);
    part_.primitives.reserve(pieces);
    if (deep_) part_.corners.reserve(pieces);
    if (inputs_) part_.origins.reserve(pieces);
  }

  /// Primitives [first, end) of a draw.
  void add(const Draw& draw, const DrawPlace& place, size_t first, size_t end) {
    PrimitiveMaker others(all_.scene_, all_.rules_, draw, place.clipped, counts_, [this](const Primitive& primitive) { addMade(primitive); });
    for (size_t i = first; i < end; ++i) {
      const AssembledTriangle assembled = all_.assembled(draw, place, i);
      const uint32_t number = place.firstPrimitive + static_cast<uint32_t>(i) + 1;
      if (!addWhole(draw, assembled.vertices, place.firstVertex, number)) others.make(number, assembled);
    }
  }

  /// Pieces of a primitive that geometry.hpp made.
  void addMade(const Primitive& primitive) {
    part_.folded = part_.folded || primitive.folded || (mayWiden_ && isFolded(primitive.polygon, CutFill::Polygon));
    for (size_t place = 0; place < primitive.pieces.size(); ++place) {
      const SetupTriangle& piece = primitive.pieces[place];
      if (piece.culled) continue;
      std::array<uint32_t, 3> corners{};
      SnappedTriangle positions;
      for (size_t k = 0; k < 3; ++k) {
        const RasterVertex& vertex = primitive.polygon[piece.corner[k]];
        positions.v[k] = vertex.snapped;
        if (!deep_) continue;
        corners[k] = kMade + static_cast<uint32_t>(part_.made.size());
        part_.made.push_back(depthVertex(vertex, places_));
      }
      if (inputs_) countInputs(primitive.clip);
      put(positions, corners, primitive.number, {true, static_cast<uint8_t>(place), primitive.cut, primitive.polygon.size() > 3});
    }
  }

 private:
  /// False: some corner is outside of what clips it, or has no place.
  bool addWhole(const Draw& draw, const std::array<uint32_t, 3>& ofDraw, uint32_t firstVertex, uint32_t number) {
    const std::array<uint32_t, 3> v{ofDraw[0] + firstVertex, ofDraw[1] + firstVertex, ofDraw[2] + firstVertex};
    const StagedVertices& vertices = all_.vertices_;
    const uint32_t codes[]{vertices.codes[v[0]], vertices.codes[v[1]], vertices.codes[v[2]]};
    if ((codes[0] | codes[1] | codes[2]) != 0) {
      const bool outside = (codes[0] & codes[1] & codes[2] & ~kNoPlace) != 0;  // of one and the same plane
      if (outside) ++counts_[Rule::ViewVolume];
      return outside;
    }
    SnappedTriangle positions{{vertices.snapped[v[0]], vertices.snapped[v[1]], vertices.snapped[v[2]]}};
    const int64_t area = doubleArea(positions.v[0], positions.v[1], positions.v[2]);
    const CullMode cullMode = all_.scene_.state.cullMode;
    if (cullMode != CullMode::NONE) {
      const bool culled = pieceMaker_.isCulled(static_cast<double>(area));  // only its sign counts
      if (cullMode != CullMode::FRONT_AND_BACK) ++counts_[Rule::Facing];
      if (culled) ++counts_[Rule::Culling];
      if (culled) return true;
    }
    if (area == 0) return true;
    const bool turned = area < 0;
    const std::array<SubpixelPosition, 2> last{positions.v[turned ? 2 : 1], positions.v[turned ? 1 : 2]};
    positions.v[1] = last[0], positions.v[2] = last[1];
    if (inputs_) countInputs({draw.positions[ofDraw[0]], draw.positions[ofDraw[1]], draw.positions[ofDraw[2]]});
    put(positions, {v[0], v[turned ? 2 : 1], v[turned ? 1 : 2]}, number, {});
    return true;
  }

  // What drawing a piece with inputs decides, wherever it is drawn.
  void countInputs(const std::array<ClipPosition, 3>& v) {
    if (v[0].w != v[1].w || v[0].w != v[2].w) ++counts_[Rule::Perspective];
    if (flat_) ++counts_[Rule::ProvokingVertex];
  }

  void put(const SnappedTriangle& positions, const std::array<uint32_t, 3>& corners, uint32_t number, const PieceOrigin& origin) {
    const auto [low, high] = std::minmax({positions.v[0].y, positions.v[1].y, positions.v[2].y});
    const auto shift = static_cast<int>(kSubpixelBits + all_.rows_.shift);
    const int32_t first = std::max(low, 0) >> shift, last = std::min(high >> shift, static_cast<int32_t>(part_.bands.size()) - 1);
    if (first > last) return;
    const auto piece = static_cast<uint32_t>(part_.positions.size());
    part_.positions.push_back(positions);
    part_.primitives.push_back(number);
    if (deep_) part_.corners.push_back(corners);
    if (inputs_) part_.origins.push_back(origin);
    for (int32_t band = first; band <= last; ++band) part_.bands[static_cast<size_t>(band)].push_back(piece);
  }

  const KernelGeometry& all_;
  KernelPieces& part_;
  RuleCounts& counts_;
  const PlanePlaces places_;
  const PieceMaker pieceMaker_;
  const bool deep_, inputs_, flat_, mayWiden_;
};

KernelGeometry::KernelGeometry(const Scene& scene, const Rules& rules, BandRows rows, std::span<RuleCounts> counts)
    : scene_(scene), rules_(rules), rows_(rows), vertices_(stagesInVectors(rules) ? vertexCountOf(scene) : 0, scene.target.depthFormat || hasInputs(scene)),
      parts_(counts.size()) {
  stage(counts);
  const bool inVectors = std::ranges::all_of(draws_, &DrawPlace::inVectors);
  const size_t primitives = primitiveCount(scene);
  std::vector<Maker> makers;
  for (size_t k = 0; k < counts.size(); ++k) makers.emplace_back(*this, parts_[k], counts[k]);
  if (!inVectors) {
    std::vector<PrimitiveVisitor> visitors;
    for (Maker& maker : makers) visitors.emplace_back([&maker](const Primitive& primitive) { maker.addMade(primitive); });
    forEachPrimitive(scene, rules, counts, visitors);
    return;
  }
  inParallel(static_cast<unsigned>(counts.size()), [&](unsigned k) {
    const size_t first = primitives * k / counts.size(), end = primitives * (k + 1) / counts.size();
    makers[k].reserve(end - first);
    for (size_t d = 0; d < draws_.size(); ++d) {
      const DrawPlace& place = draws_[d];
      const size_t from = std::max<size_t>(first, place.firstPrimitive), to = std::min<size_t>(end, size_t{place.firstPrimitive} + place.primitives);
      if (from < to) makers[k].add(scene.draws[d], place, from - place.firstPrimitive, to - place.firstPrimitive);
    }
  });
}

AssembledTriangle KernelGeometry::assembled(const Draw& draw, const DrawPlace& place, size_t i) const {
  if (!readsIndicesAsTheyAre(scene_.state)) return place.assembled[i];
  std::array<uint32_t, 3> v{};
  for (size_t k = 0; k < 3; ++k) v[k] = draw.indices ? (*draw.indices)[3 * i + k] : static_cast<uint32_t>(3 * i + k);
  return {v, v[scene_.state.provokingVertexMode == ProvokingVertexMode::FIRST_VERTEX ? 0 : 2]};
}

KernelGeometry::Assembled KernelGeometry::assembled(uint32_t number) const {
  size_t d = draws_.size() - 1;
  while (draws_[d].firstPrimitive >= number) --d;
  return {d, assembled(scene_.draws[d], draws_[d], number - draws_[d].firstPrimitive - 1)};
}

bool KernelGeometry::folded() const { return std::ranges::any_of(parts_, &KernelPieces::folded); }

bool KernelGeometry::servesInVectors(const Draw& draw, bool clipped) const {
  const State& state = scene_.state;
  if (draw.cullDistanceCount > 0 || !state.depthClipEnable.value_or(!state.depthClampEnable)) return false;
  // [choice:cull-position] all by what is snapped.
  const CullPosition position = rules_.choices.cullPosition;
  return position == CullPosition::Snapped || (position == CullPosition::AlsoFloat && (state.cullMode == CullMode::NONE || !clipped));
}

void KernelGeometry::stage(std::span<RuleCounts> counts) {
  DrawPlace place;
  std::vector<RuleCounts> decided(counts.size());
  for (const Draw& draw : scene_.draws) {
    place.primitives = primitiveCount(scene_.state, draw);
    if (!readsIndicesAsTheyAre(scene_.state)) place.assembled = assemble(draw, scene_.state);
    if (stagesInVectors(rules_)) {
      const VertexStage stage = vertexStage(scene_, rules_, draw.viewportIndex);
      const ClipVolume volume = clipVolume(scene_.state, draw, rules_.error);
      const size_t size = draw.positions.size(), pieces = (size + kVerticesAtOnce - 1) / kVerticesAtOnce;
      const auto threads = static_cast<unsigned>(counts.size());
      inParallel(threads, [&](unsigned k) {
        const size_t first = std::min(size, pieces * k / threads * kVerticesAtOnce), end = std::min(size, pieces * (k + 1) / threads * kVerticesAtOnce);
        decided[k][Rule::Division] +=
            stageVertices(std::span(draw.positions).subspan(first, end - first), stage, volume, place.firstVertex + first, vertices_);
      });
      if (!isWholeTarget(scene_, draw.viewportIndex)) decided[0][Rule::ViewportMap] += size;
      const auto codes = std::span(vertices_.codes).subspan(place.firstVertex, size);
      place.clipped = std::ranges::any_of(codes, [](uint32_t code) { return (code & ~kNoPlace) != 0; });
      place.inVectors = servesInVectors(draw, place.clipped);
    }
    draws_.push_back(place);
    place.firstVertex += static_cast<uint32_t>(draw.positions.size());
    place.firstPrimitive += place.primitives;
  }
  if (!std::ranges::all_of(draws_, &DrawPlace::inVectors)) return;  // geometry.hpp counts for itself
  for (size_t k = 0; k < counts.size(); ++k) counts[k] += decided[k];
}

}  // namespace rasterdiff::rasterizer
