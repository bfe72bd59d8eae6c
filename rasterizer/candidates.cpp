// The evidence behind a verdict: for queried samples, every primitive that may cover them, with legal values.
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/fragment/alpha_to_coverage.hpp"
#include "rasterizer/fragment/coverage_freedom.hpp"
#include "rasterizer/fragment/shader_mask.hpp"
#include "rasterizer/figure_verdict.hpp"
#include "rasterizer/freedom_band.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/sample_grid.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Query numbers sorted by row, then column, with the start of each row.
class QueryIndex {
 public:
  QueryIndex(std::span<const SampleQuery> queries, uint32_t height) : queries_(queries), order_(queries.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(), [&](size_t a, size_t b) {
      return std::pair(queries[a].y, queries[a].x) < std::pair(queries[b].y, queries[b].x);
    });
    rowStart_.assign(height + 1, queries.size());
    for (size_t i = order_.size(); i-- > 0;) rowStart_[queries[order_[i]].y] = i;
    for (size_t y = height; y-- > 0;) rowStart_[y] = std::min(rowStart_[y], rowStart_[y + 1]);
  }

  template <class Visit>
  void inBox(int32_t x0, int32_t y0, int32_t x1, int32_t y1, const Visit& visit) const {
    const auto rows = static_cast<int32_t>(rowStart_.size()) - 1;
    for (int32_t y = std::max(y0, 0); y <= std::min(y1, rows - 1); ++y) {
      const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(rowStart_[static_cast<size_t>(y)]);
      const auto end = order_.begin() + static_cast<std::ptrdiff_t>(rowStart_[static_cast<size_t>(y) + 1]);
      auto it = std::lower_bound(begin, end, x0, [&](size_t q, int32_t x) { return static_cast<int32_t>(queries_[q].x) < x; });
      for (; it != end && static_cast<int32_t>(queries_[*it].x) <= x1; ++it) visit(*it);
    }
  }

 private:
  std::span<const SampleQuery> queries_;
  std::vector<size_t> order_, rowStart_;
};

struct Box {
  int32_t x0, y0, x1, y1;  // pixels, inclusive
};

Box pixelBox(const Primitive& primitive) {
  constexpr int32_t kMax = std::numeric_limits<int32_t>::max(), kMin = std::numeric_limits<int32_t>::min();
  Box box{kMax, kMax, kMin, kMin};
  for (const RasterVertex& v : primitive.polygon) {
    box = {std::min(box.x0, v.lowest.x), std::min(box.y0, v.lowest.y), std::max(box.x1, v.highest.x), std::max(box.y1, v.highest.y)};
  }
  return {box.x0 >> kSubpixelBits, box.y0 >> kSubpixelBits, box.x1 >> kSubpixelBits, box.y1 >> kSubpixelBits};
}

// The piece a sample belongs to, or the one it is least outside of.
const SetupTriangle* pieceAt(const Primitive& primitive, int64_t px, int64_t py) {
  const SetupTriangle* best = nullptr;
  double bestDistance = -std::numeric_limits<double>::infinity();
  for (const SetupTriangle& piece : primitive.pieces) {
    double distance = std::numeric_limits<double>::infinity();
    for (const EdgeFunction& edge : piece.edges) {
      const double length = static_cast<double>(std::llabs(edge.dx) + std::llabs(edge.dy)) + 1;
      distance = std::min(distance, static_cast<double>(edge.at(px, py)) / length);
    }
    if (best == nullptr || distance > bestDistance) {
      best = &piece;
      bestDistance = distance;
    }
  }
  return best;
}

class CandidateFinder {
 public:
  CandidateFinder(const Scene& scene, const Rules& rules, std::span<const SampleQuery> queries,
                  std::vector<SubpixelPosition> pattern)
      : scene_(scene), rules_(rules), needs_(needsOf(scene)), queries_(queries), pattern_(std::move(pattern)),
        index_(queries, scene.target.height), values_(scene, needs_, rules), shaderMask_(scene), coverage_(scene.state),
        found(queries.size()) {}

  void visit(const Primitive& primitive) {
    region_ = drawingRegion(scene_, primitive.viewportIndex, rules_);
    shaderMask_.begin(*primitive.draw);
    coverage_.setUp(primitive, nullptr);
    for (const Figure& figure : primitive.figures) visitFigure(primitive, figure);
    if (primitive.polygon.empty() && !primitive.unprojectable) return;
    if (primitive.unprojectable) {
      for (size_t q = 0; q < queries_.size(); ++q) {
        if (region_.area.contains(static_cast<int32_t>(queries_[q].x), static_cast<int32_t>(queries_[q].y))) {
          add(q, primitive, nullptr, {Coverage::Either, Freedom::DivisionByZero, std::nullopt});
        }
      }
      return;
    }
    const Box box = pixelBox(primitive);
    std::optional<FreedomBand> band;
    index_.inBox(box.x0, box.y0, box.x1, box.y1, [&](size_t q) {
      const SampleQuery& query = queries_[q];
      const auto x = static_cast<int32_t>(query.x), y = static_cast<int32_t>(query.y);
      const SubpixelPosition& offset = pattern_[query.sample];
      const int64_t px = int64_t{query.x} * kSubpixelOne + offset.x, py = int64_t{query.y} * kSubpixelOne + offset.y;
      const auto mayWrite = [&](const SetupTriangle& piece) { return !piece.culled && region_.of(primitive, piece).contains(x, y, offset); };
      if (rules_.open) {
        if (!region_.area.contains(x, y)) return;
        if (!band) band.emplace(primitive, scene_.state.cullMode, scene_.state.frontFace);
        const BandVerdict verdict = band->classifyExactly(px, py);
        if (verdict.coverage != Coverage::Out) add(q, primitive, pieceAt(primitive, px, py), verdict);
        return;
      }
      if (primitive.folded) {
        const std::optional<size_t> drawn = CutPolygon(primitive, rules_).pieceAt(px, py);
        if (drawn && mayWrite(primitive.pieces[*drawn])) add(q, primitive, &primitive.pieces[*drawn], {Coverage::In, Freedom::None, std::nullopt});
        return;
      }
      for (const SetupTriangle& piece : primitive.pieces) {
        if (piece.covers(px, py) && mayWrite(piece)) add(q, primitive, &piece, {Coverage::In, Freedom::None, std::nullopt});
      }
    });
  }

 private:
  void visitFigure(const Primitive& primitive, const Figure& figure) {
    const Shape::Rows rows = figure.shape->rows();
    coverage_.setUp(primitive, &figure);
    index_.inBox(0, rows.first, static_cast<int32_t>(scene_.target.width), rows.last, [&](size_t q) {
      const SampleQuery& query = queries_[q];
      const auto x = static_cast<int32_t>(query.x), y = static_cast<int32_t>(query.y);
      const RowSpan columns = figure.shape->columns(y);
      if (!region_.allows(figure, x, y) || x < columns.begin || x >= columns.end) return;
      const int64_t px = int64_t{x} * kSubpixelOne + pattern_[query.sample].x;
      const int64_t py = int64_t{y} * kSubpixelOne + pattern_[query.sample].y;
      BandVerdict verdict;
      if (rules_.open) {
        verdict = legalVerdict(figure, px, py);
      } else {
        bool tie = false;
        verdict.coverage = figure.nominal && figure.shape->covers(px, py, tie) ? Coverage::In : Coverage::Out;
      }
      if (verdict.coverage != Coverage::Out) addFigure(q, primitive, figure, verdict);
    });
  }

  void addFigure(size_t q, const Primitive& primitive, const Figure& figure, BandVerdict verdict) {
    Candidate candidate = unbounded(primitive, verdict);
    if (valuesMatter() || shaderMask_.writes()) {
      values_.setUp(primitive, figure);
      bound(q, candidate);
    }
    push(q, std::move(candidate));
  }

  void add(size_t q, const Primitive& primitive, const SetupTriangle* piece, BandVerdict verdict) {
    Candidate candidate = unbounded(primitive, verdict);
    if (piece != nullptr && (valuesMatter() || shaderMask_.writes())) {
      values_.setUp(primitive, *piece);
      bound(q, candidate);
    }
    push(q, std::move(candidate));
  }

  void push(size_t q, Candidate candidate) {
    const uint32_t sample = queries_[q].sample;
    const bool masked = (scene_.state.sampleMask & (1U << sample)) == 0 ||  // [vk:fragops-samplemask]
                        shaderMask_.keeps(sample, 0, ~0U) == Coverage::Out;
    if (!masked && candidate.coverage != Coverage::Out) found[q].push_back(std::move(candidate));
  }

  [[nodiscard]] bool valuesMatter() const { return needs_.depth || values_.componentCount() > 0; }

  [[nodiscard]] Candidate unbounded(const Primitive& primitive, const BandVerdict& verdict) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Candidate candidate;
    candidate.primitive = primitive.number;
    candidate.coverage = verdict.coverage;
    candidate.freedom = verdict.freedom;
    candidate.tieEdge = verdict.tieEdge;
    candidate.depth = {-kInfinity, kInfinity};
    candidate.varyings.assign(values_.componentCount(), Bounds{-kInfinity, kInfinity});
    return candidate;
  }

  // Bounds at the queried sample from the planes that values_ is set up with.
  void bound(size_t q, Candidate& candidate) {
    const SampleQuery& query = queries_[q];
    if (needs_.depth) {
      candidate.depth = values_.depth(query.x + pattern_[query.sample].x / double{kSubpixelOne},
                                      query.y + pattern_[query.sample].y / double{kSubpixelOne}).bounds;
    }
    FragmentPlace place{static_cast<int32_t>(query.x), static_cast<int32_t>(query.y), query.sample, 0};
    if (values_.needsMask() || shaderMask_.writes()) {
      place.covered = (values_.coveredSamples(place.x, place.y) & scene_.state.sampleMask) | 1U << query.sample;
    }
    if (shaderMask_.writes()) applyShaderMask(place, candidate);
    std::vector<Interpolated> interpolated(values_.componentCount());
    values_.fragment(place, interpolated.data());
    for (size_t c = 0; c < interpolated.size(); ++c) candidate.varyings[c] = interpolated[c].bounds;
    if (scene_.state.alphaToCoverageEnable) applyAlpha(candidate);
  }

  // [vk:fragops-covg] the shader's mask, made of what the shader sees: a freedom of its own where that is free.
  void applyShaderMask(const FragmentPlace& place, Candidate& candidate) {
    uint32_t certain = place.covered, possible = place.covered;
    if (rules_.open) {
      const CoverageFreedom::Masks masks = coverage_.masks(place, pattern_);
      certain &= masks.certain;
      possible |= masks.possible & scene_.state.sampleMask;
    }
    limit(candidate, shaderMask_.keeps(place.sample, certain, possible), Freedom::ShaderSampleMask);
  }

  // Where a fragment operation may take the sample, what owns a tie matters no more.
  static void limit(Candidate& candidate, Coverage kept, Freedom freedom) {
    if (kept == Coverage::In || candidate.coverage == Coverage::Out) return;
    candidate.coverage = kept;
    candidate.freedom = freedom;
    candidate.tieEdge.reset();
  }

  // [vk:fragops-covg] whether alpha keeps the sample.
  void applyAlpha(Candidate& candidate) const {
    const std::vector<Varying>& varyings = scene_.draws[0].varyings;
    if (varyings.empty() || varyings[0].components != 4) return;
    limit(candidate, alphaCoverage(candidate.varyings[3]), Freedom::AlphaToCoverage);
  }

  const Scene& scene_;
  const Rules& rules_;
  const SceneNeeds needs_;
  std::span<const SampleQuery> queries_;
  const std::vector<SubpixelPosition> pattern_;
  DrawingRegion region_;  // of the primitive being visited
  const QueryIndex index_;
  PieceValues values_;
  ShaderMask shaderMask_;
  CoverageFreedom coverage_;  // of the triangle or figure being visited

 public:
  std::vector<std::vector<Candidate>> found;
};

}  // namespace

Result<std::vector<std::vector<Candidate>>> candidates(const Scene& scene, const Rules& profile,
                                                       std::span<const SampleQuery> queries) {
  const Rules rules = rulesFor(scene, profile);
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected<Error>(valid.error());
  Result<std::vector<SubpixelPosition>> pattern = samplePattern(scene.target.samples, rules);
  if (!pattern) return tl::unexpected<Error>(pattern.error());
  for (const SampleQuery& query : queries) {
    if (query.x >= scene.target.width || query.y >= scene.target.height || query.sample >= scene.target.samples) {
      return fail(ErrorCode::BadInput, "sample", "the sample is outside the target");
    }
  }
  if (scene.target.sampleLocations) return gridCandidates(scene, rules, queries);
  CandidateFinder finder(scene, rules, queries, std::move(*pattern));
  RuleCounts ignored;
  forEachPrimitive(scene, rules, ignored, [&](const Primitive& primitive) { finder.visit(primitive); });
  return std::move(finder.found);
}

}  // namespace rasterdiff::rasterizer
