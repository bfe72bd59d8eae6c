#include "harness/compare/placement/placement_problem.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <unordered_map>

#include "rasterizer/freedom_band.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/sample_grid.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/snap.hpp"
#include "rasterizer/target_area.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::FreedomBand;
using rasterizer::Primitive;
using rasterizer::SampleQuery;

constexpr size_t kMostSamples = 4'000'000;

bool placeable(const Primitive& primitive) {
  return primitive.assembled.count == 3 && !primitive.cut && primitive.polygon.size() == 3 && primitive.figures.empty();
}

class DisjointSets {
 public:
  uint32_t add() {
    parent_.push_back(static_cast<uint32_t>(parent_.size()));
    return parent_.back();
  }
  uint32_t find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(uint32_t a, uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<uint32_t> parent_;
};

// Vertices are one where the same position goes through the same viewport: the same arithmetic gives the same place.
// [vk:invariance]
using VertexKey = std::array<uint32_t, 5>;

VertexKey keyOf(const ClipPosition& p, uint32_t viewportIndex) {
  return {std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y), std::bit_cast<uint32_t>(p.z),
          std::bit_cast<uint32_t>(p.w), viewportIndex};
}

class Builder {
 public:
  Builder(const Scene& scene, const rasterizer::Rules& rules, const Frame& actual)
      : scene_(scene), rules_(rules), actual_(actual), bare_(scene) {
    // Coverage alone: values and the depth test have no part in where a vertex is.
    for (Draw& draw : bare_.draws) draw.varyings.clear();
    bare_.builtIns.clear();
    bare_.target.resolve = false;
    bare_.target.depthFormat.reset();
    bare_.target.depthClearValue = 1;
    bare_.state.depthTestEnable = bare_.state.depthWriteEnable = bare_.state.depthBiasEnable = false;
    bare_.state.sampleShadingEnable = bare_.state.alphaToCoverageEnable = false;
    bare_.state.shaderSampleMask = ShaderSampleMask::NONE;
    for (Draw& draw : bare_.draws) draw.shaderSampleMaskBits = Draw{}.shaderSampleMaskBits;
    problem_.cullMode = scene.state.cullMode;
    problem_.frontFace = scene.state.frontFace;
    problem_.advertisedBits = rasterizer::gridBits(rules);
  }

  Result<PlacementProblem> build(std::span<const SampleQuery> seeds) {
    Result<std::vector<SubpixelPosition>> pattern = rasterizer::samplePattern(scene_.target.samples, rules_);
    if (!pattern) return tl::unexpected<Error>(pattern.error());
    pattern_ = std::move(*pattern);
    collect();
    if (const Result<void> chosen = choose(seeds); !chosen) return tl::unexpected<Error>(chosen.error());
    enumerateBands();
    if (queries_.size() > kMostSamples) {
      problem_.tooLarge = true;
      return std::move(problem_);
    }
    const auto evidence = rasterizer::candidates(bare_, rules_, queries_);
    if (!evidence) return tl::unexpected<Error>(evidence.error());
    for (size_t q = 0; q < queries_.size(); ++q) require(queries_[q], (*evidence)[q]);
    return std::move(problem_);
  }

 private:
  struct Known {
    std::array<uint32_t, 3> vertices{};
    bool placeable = false, chosen = false;
    int64_t area = 0;
    size_t index = 0;  // in problem_.primitives
  };

  uint32_t vertexOf(const Primitive& primitive, size_t corner) {
    const auto [it, isNew] = ids_.try_emplace(keyOf(primitive.clip[corner], primitive.viewportIndex), 0U);
    if (isNew) {
      it->second = sets_.add();
      const rasterizer::RasterVertex& v = primitive.polygon[corner];
      const ClipPosition& p = primitive.clip[corner];
      const auto deviation = [&](float coordinate, const rasterizer::ViewportAxis& axis) {
        return rasterizer::viewportArithmeticBound(coordinate, p.w, axis) + primitive.viewport.boundsUncertainty;
      };
      problem_.vertices.push_back({static_cast<uint32_t>(primitive.draw - scene_.draws.data()),
                                   primitive.assembled.vertices[corner], v.position, deviation(p.x, primitive.viewport.x),
                                   deviation(p.y, primitive.viewport.y), v.snapped, v.lowest, v.highest});
    }
    return it->second;
  }

  void collect() {
    rasterizer::RuleCounts ignored;
    rasterizer::forEachPrimitive(scene_, rules_, ignored, [&](const Primitive& primitive) {
      Known& known = known_[primitive.number];
      known.placeable = placeable(primitive);
      if (!known.placeable) return;
      for (size_t i = 0; i < 3; ++i) known.vertices[i] = vertexOf(primitive, i);
      const auto& p = primitive.polygon;
      known.area = rasterizer::doubleArea(p[0].snapped, p[1].snapped, p[2].snapped);
      sets_.join(known.vertices[0], known.vertices[1]);
      sets_.join(known.vertices[0], known.vertices[2]);
    });
  }

  Result<void> choose(std::span<const SampleQuery> seeds) {
    const auto evidence = rasterizer::candidates(bare_, rules_, seeds);
    if (!evidence) return tl::unexpected<Error>(evidence.error());
    std::vector<bool> wanted(problem_.vertices.size());
    for (const std::vector<Candidate>& list : *evidence) {
      for (const Candidate& candidate : list) {
        const Known& known = known_[candidate.primitive];
        if (candidate.coverage == Coverage::Either && known.placeable) wanted[sets_.find(known.vertices[0])] = true;
      }
    }
    for (auto& [number, known] : known_) {
      if (!known.placeable || !wanted[sets_.find(known.vertices[0])]) continue;
      known.chosen = true;
      known.index = problem_.primitives.size();
      problem_.primitives.push_back({number, known.vertices, {}});
    }
    return {};
  }

  // All samples that are free for a chosen primitive, each once.
  void enumerateBands() {
    rasterizer::RuleCounts ignored;
    std::vector<uint64_t> found;
    rasterizer::forEachPrimitive(scene_, rules_, ignored, [&](const Primitive& primitive) {
      if (!known_[primitive.number].chosen || found.size() > 2 * kMostSamples) return;
      const rasterizer::PixelArea area = rasterizer::targetArea(scene_, primitive.viewportIndex);
      const FreedomBand band(primitive, scene_.state.cullMode, scene_.state.frontFace);
      const int32_t last = std::min(band.lastRow(), area.bottom - 1);
      for (int32_t y = std::max(band.firstRow(), area.top); y <= last; ++y) {
        for (uint32_t s = 0; s < pattern_.size(); ++s) collectRow(band, area, y, s, found);
      }
    });
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    for (const uint64_t packed : found) {
      const uint64_t pixel = packed / pattern_.size();
      queries_.push_back({static_cast<uint32_t>(pixel % scene_.target.width), static_cast<uint32_t>(pixel / scene_.target.width),
                          static_cast<uint32_t>(packed % pattern_.size())});
    }
  }

  void collectRow(const FreedomBand& band, const rasterizer::PixelArea& area, int32_t y, uint32_t sample,
                  std::vector<uint64_t>& found) const {
    const int64_t py = int64_t{y} * kSubpixelOne + pattern_[sample].y;
    const FreedomBand::Row row = band.row(pattern_[sample].x, py, {area.left, area.right});
    const auto part = [&](int32_t begin, int32_t end) {
      for (int32_t x = begin; x < end; ++x) {
        if (band.classifyExactly(int64_t{x} * kSubpixelOne + pattern_[sample].x, py).coverage != Coverage::Either) continue;
        found.push_back((static_cast<uint64_t>(y) * scene_.target.width + static_cast<uint64_t>(x)) * pattern_.size() + sample);
      }
    };
    part(row.possible.begin, std::min(row.possible.end, row.certain.begin));
    part(std::max(row.possible.begin, row.certain.end), row.possible.end);
  }

  // What the frame tells of the primitives that are free at a sample: its winner covers it, none after the winner does,
  // and without a depth test `count` says how many before it do.
  void require(const SampleQuery& query, const std::vector<Candidate>& candidates) {
    const uint32_t winner = actual_.primitive.at(query.x, query.y, query.sample);
    const int64_t count = actual_.count.at(query.x, query.y, query.sample);
    const bool hidden = scene_.state.depthTestEnable && scene_.target.depthFormat;
    const bool fading = scene_.state.alphaToCoverageEnable || scene_.state.shaderSampleMask != ShaderSampleMask::NONE;
    int64_t certainBefore = 0, freeBefore = 0;
    for (const Candidate& candidate : candidates) {
      if (candidate.primitive >= winner) continue;
      ++(candidate.coverage == Coverage::In ? certainBefore : freeBefore);
    }
    const int64_t needed = count - 1 - certainBefore;
    told_.clear();
    for (const Candidate& candidate : candidates) {
      if (candidate.coverage != Coverage::Either) continue;
      const Known& known = known_[candidate.primitive];
      std::optional<bool> covered;
      if (candidate.primitive == winner) {
        covered = true;
      } else if (hidden || fading) {
        covered = std::nullopt;
      } else if (winner == 0 || candidate.primitive > winner || needed == 0) {
        covered = false;
      } else if (needed == freeBefore) {
        covered = true;
      }
      if (!known.placeable || !covered) {
        ++problem_.leftOut;
      } else if (known.chosen) {
        told_.emplace_back(&known, *covered);
      }
    }
    const SubpixelPosition& offset = pattern_[query.sample];
    const int64_t px = int64_t{query.x} * kSubpixelOne + offset.x, py = int64_t{query.y} * kSubpixelOne + offset.y;
    for (size_t i = 0; i < told_.size(); ++i) {
      uint8_t strict = 0;
      for (size_t j = 0; j < told_.size(); ++j) {
        if (j != i && told_[j].second == told_[i].second) strict |= sharedEdge(*told_[i].first, *told_[j].first);
      }
      problem_.primitives[told_[i].first->index].requirements.push_back({px, py, told_[i].second, strict});
    }
  }

  // The edge of `a` that `b` has on its other side, as a bit; 0 if there is none. [vk:primsrast-polygons-basic]
  static uint8_t sharedEdge(const Known& a, const Known& b) {
    if (a.area == 0 || b.area == 0) return 0;
    for (size_t e = 0; e < 3; ++e) {
      for (size_t f = 0; f < 3; ++f) {
        const uint32_t a0 = a.vertices[e], a1 = a.vertices[(e + 1) % 3], b0 = b.vertices[f], b1 = b.vertices[(f + 1) % 3];
        const bool reversed = a0 == b1 && a1 == b0, alike = a0 == b0 && a1 == b1;
        const bool sameWinding = (a.area > 0) == (b.area > 0);
        if ((reversed && sameWinding) || (alike && !sameWinding)) return static_cast<uint8_t>(1U << e);
      }
    }
    return 0;
  }

  const Scene& scene_;
  const rasterizer::Rules& rules_;
  const Frame& actual_;
  Scene bare_;
  PlacementProblem problem_;
  std::vector<SubpixelPosition> pattern_;
  std::map<VertexKey, uint32_t> ids_;
  std::map<uint32_t, Known> known_;  // by number: in drawing order
  DisjointSets sets_;
  std::vector<SampleQuery> queries_;
  std::vector<std::pair<const Known*, bool>> told_;
};

}  // namespace

Result<PlacementProblem> placementProblem(const Scene& scene, const rasterizer::Rules& rules, const Frame& actual,
                                          std::span<const SampleQuery> seeds) {
  if (scene.target.sampleLocations) {
    const Result<rasterizer::SampleGrid> grid = rasterizer::SampleGrid::of(scene, rules);
    if (!grid) return tl::unexpected<Error>(grid.error());
    const rasterizer::GridPixel& place = grid->at(0, 0);
    if (grid->width() * grid->height() == 1) return placementProblem(place.scene, place.rules, actual, seeds);
    PlacementProblem unsolved;  // its samples are in other places in every pixel of the grid
    unsolved.tooLarge = true;
    return unsolved;
  }
  return Builder(scene, rules, actual).build(seeds);
}

}  // namespace rasterdiff::harness
