// The evidence behind a verdict: for queried samples, every primitive that may cover them, with legal values.
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "rasterizer/freedom_band.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/target_area.hpp"

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

bool covers(const SetupTriangle& piece, int64_t px, int64_t py) {
  return std::all_of(piece.edges.begin(), piece.edges.end(), [&](const EdgeFunction& e) { return e.covers(px, py); });
}

class CandidateFinder {
 public:
  CandidateFinder(const Scene& scene, const Rules& rules, std::span<const SampleQuery> queries,
                  std::vector<SubpixelPosition> pattern)
      : scene_(scene), rules_(rules), needs_(needsOf(scene)), queries_(queries), pattern_(std::move(pattern)),
        area_(targetArea(scene)), index_(queries, scene.target.height), values_(scene, needs_, rules), found(queries.size()) {}

  void visit(const Primitive& primitive) {
    if (primitive.unprojectable) {
      for (size_t q = 0; q < queries_.size(); ++q) {
        if (area_.contains(static_cast<int32_t>(queries_[q].x), static_cast<int32_t>(queries_[q].y))) {
          add(q, primitive, nullptr, {Coverage::Either, Freedom::DivisionByZero, std::nullopt});
        }
      }
      return;
    }
    const Box box = pixelBox(primitive);
    std::optional<FreedomBand> band;
    index_.inBox(box.x0, box.y0, box.x1, box.y1, [&](size_t q) {
      const SampleQuery& query = queries_[q];
      if (!area_.contains(static_cast<int32_t>(query.x), static_cast<int32_t>(query.y))) return;
      const SubpixelPosition& offset = pattern_[query.sample];
      const int64_t px = int64_t{query.x} * kSubpixelOne + offset.x, py = int64_t{query.y} * kSubpixelOne + offset.y;
      if (rules_.open) {
        if (!band) band.emplace(primitive, scene_.state.cullMode, scene_.state.frontFace);
        const BandVerdict verdict = band->classifyExactly(px, py);
        if (verdict.coverage != Coverage::Out) add(q, primitive, pieceAt(primitive, px, py), verdict);
        return;
      }
      for (const SetupTriangle& piece : primitive.pieces) {
        if (!piece.culled && covers(piece, px, py)) add(q, primitive, &piece, {Coverage::In, Freedom::None, std::nullopt});
      }
    });
  }

 private:
  void add(size_t q, const Primitive& primitive, const SetupTriangle* piece, BandVerdict verdict) {
    Candidate candidate;
    candidate.primitive = primitive.number;
    candidate.coverage = verdict.coverage;
    candidate.freedom = verdict.freedom;
    candidate.tieEdge = verdict.tieEdge;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    candidate.depth = {-kInfinity, kInfinity};
    candidate.varyings.assign(values_.componentCount(), Bounds{-kInfinity, kInfinity});
    if (piece != nullptr && (needs_.depth || needs_.varyings > 0)) {
      const SampleQuery& query = queries_[q];
      values_.setUp(primitive, *piece);
      if (needs_.depth) {
        candidate.depth = values_.depth(query.x + pattern_[query.sample].x / double{kSubpixelOne},
                                        query.y + pattern_[query.sample].y / double{kSubpixelOne}).bounds;
      }
      std::vector<Interpolated> interpolated(values_.componentCount());
      values_.varyings(query.x + 0.5, query.y + 0.5, interpolated.data());
      for (size_t c = 0; c < interpolated.size(); ++c) candidate.varyings[c] = interpolated[c].bounds;
    }
    found[q].push_back(std::move(candidate));
  }

  const Scene& scene_;
  const Rules& rules_;
  const SceneNeeds needs_;
  std::span<const SampleQuery> queries_;
  const std::vector<SubpixelPosition> pattern_;
  const PixelArea area_;
  const QueryIndex index_;
  PieceValues values_;

 public:
  std::vector<std::vector<Candidate>> found;
};

}  // namespace

Result<std::vector<std::vector<Candidate>>> candidates(const Scene& scene, const Rules& rules,
                                                       std::span<const SampleQuery> queries) {
  if (const Result<void> valid = validate(scene); !valid) return tl::unexpected<Error>(valid.error());
  Result<std::vector<SubpixelPosition>> pattern = samplePattern(scene.target.samples, rules);
  if (!pattern) return tl::unexpected<Error>(pattern.error());
  for (const SampleQuery& query : queries) {
    if (query.x >= scene.target.width || query.y >= scene.target.height || query.sample >= scene.target.samples) {
      return fail(ErrorCode::BadInput, "sample", "the sample is outside the target");
    }
  }
  CandidateFinder finder(scene, rules, queries, std::move(*pattern));
  RuleCounts ignored;
  forEachPrimitive(scene, rules, ignored, [&](const Primitive& primitive) { finder.visit(primitive); });
  return std::move(finder.found);
}

}  // namespace rasterdiff::rasterizer
