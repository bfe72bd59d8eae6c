#include "harness/compare/placement/placement.hpp"

#include <algorithm>
#include <array>

#include "harness/compare/placement/placement_solver.hpp"
#include "rasterizer/freedoms.hpp"

namespace rasterdiff::harness {
namespace {

using State = PlacementAnswer::State;

std::vector<rasterizer::SampleQuery> differing(const Frame& reference, const Frame& actual) {
  std::vector<rasterizer::SampleQuery> seeds;
  for (size_t i = 0; i < reference.primitive.data.size(); ++i) {
    if (reference.primitive.data[i] == actual.primitive.data[i] && reference.count.data[i] == actual.count.data[i]) continue;
    const size_t pixel = i / reference.samples;
    seeds.push_back({static_cast<uint32_t>(pixel % reference.width), static_cast<uint32_t>(pixel / reference.width),
                     static_cast<uint32_t>(i % reference.samples)});
  }
  return seeds;
}

// The question on one grid.
class GridQuestion {
 public:
  GridQuestion(const PlacementProblem& problem, int bits) : problem_(problem) {
    for (const PlacedVertex& vertex : problem.vertices) {
      std::optional<std::vector<FinePosition>> places = legalPlaces(vertex, problem.advertisedBits, bits);
      counts_.push_back(places ? places->size() : 1);
      places_.push_back(places ? std::move(*places) : std::vector<FinePosition>{});
    }
    tables_.reserve(problem.primitives.size());
    for (const PlacedPrimitive& primitive : problem.primitives) {
      const auto& v = primitive.vertices;
      const std::array<const std::vector<FinePosition>*, 3> lists{&places_[v[0]], &places_[v[1]], &places_[v[2]]};
      if (std::ranges::any_of(lists, [](const auto* list) { return list->empty(); })) {
        ++leftOut_;
        continue;
      }
      tables_.push_back(placementTable(problem, primitive, lists));
      if (!tables_.back().constrains) continue;
      constraints_.push_back({v, &tables_.back()});
      numbers_.push_back(primitive.number);
    }
  }

  [[nodiscard]] uint64_t leftOut() const { return leftOut_; }
  [[nodiscard]] Solution solve() const { return solvePlacement(counts_, constraints_); }

  [[nodiscard]] std::vector<uint32_t> conflict() const {
    std::vector<uint32_t> numbers;
    for (const size_t c : conflictOf(counts_, constraints_)) numbers.push_back(numbers_[c]);
    return numbers;
  }

  void name(const Solution& solution, PlacementAnswer& answer) const {
    constexpr double kUnit = 1.0 / (1 << kFinestGridBits), kNominalUnit = 1.0 / kSubpixelOne;
    std::vector<uint32_t> used;
    for (const TableConstraint& constraint : constraints_) used.insert(used.end(), constraint.vertices.begin(), constraint.vertices.end());
    std::ranges::sort(used);
    const auto repeated = std::ranges::unique(used);
    used.erase(repeated.begin(), repeated.end());
    for (const uint32_t v : used) {
      const PlacedVertex& vertex = problem_.vertices[v];
      const FinePosition& place = places_[v][solution.places[v]];
      const VertexPlacement moved{vertex.draw, vertex.vertex, vertex.nominal.x * kNominalUnit, vertex.nominal.y * kNominalUnit,
                                  static_cast<double>(place.x) * kUnit, static_cast<double>(place.y) * kUnit};
      if (moved.x == moved.nominalX && moved.y == moved.nominalY) continue;
      ++answer.movedVertices;
      if (answer.moved.size() < kListedVertices) answer.moved.push_back(moved);
    }
  }

 private:
  const PlacementProblem& problem_;
  std::vector<std::vector<FinePosition>> places_;  // empty: unbounded
  std::vector<size_t> counts_;
  std::vector<PlacementTable> tables_;
  std::vector<TableConstraint> constraints_;
  std::vector<uint32_t> numbers_;
  uint64_t leftOut_ = 0;
};

// Freedoms of where a vertex is.
constexpr std::array kPositionFreedoms{rasterizer::Freedom::SnapRounding, rasterizer::Freedom::ViewportArithmetic,
                                       rasterizer::Freedom::ViewportBounds, rasterizer::Freedom::NearZeroArea};

bool isPositionFreedom(std::string_view id) {
  return std::ranges::any_of(kPositionFreedoms, [&](rasterizer::Freedom f) { return rasterizer::info(f).id == id; });
}

bool drawsFilledTriangles(const Scene& scene) {
  const bool triangles = primitiveCount(scene.state.topology, 3) == 1 && primitiveCount(scene.state.topology, 2) == 0;
  return triangles && scene.state.polygonMode == PolygonMode::FILL;
}

}  // namespace

Result<PlacementAnswer> explainByPlacement(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference,
                                           const Frame& actual) {
  const Result<PlacementProblem> problem = placementProblem(scene, rules, actual, differing(reference, actual));
  if (!problem) return tl::unexpected<Error>(problem.error());
  PlacementAnswer answer;
  answer.primitives = problem->primitives.size();
  answer.leftOut = problem->leftOut;
  std::vector<uint32_t> vertices;
  for (const PlacedPrimitive& primitive : problem->primitives) {
    answer.requirements += primitive.requirements.size();
    vertices.insert(vertices.end(), primitive.vertices.begin(), primitive.vertices.end());
  }
  std::ranges::sort(vertices);
  answer.vertices = static_cast<uint64_t>(std::ranges::unique(vertices).begin() - vertices.begin());
  if (problem->tooLarge) {
    answer.state = State::Undecided;
    answer.why = "too many free samples";
    return answer;
  }
  bool givenUp = false;
  for (int bits = problem->advertisedBits; bits <= kFinestGridBits; ++bits) {
    const GridQuestion question(*problem, bits);
    const Solution solution = question.solve();
    if (solution.outcome == SolverOutcome::Solved) {
      answer.gridBits = bits;
      answer.leftOut += question.leftOut();
      question.name(solution, answer);
      return answer;
    }
    givenUp = givenUp || solution.outcome == SolverOutcome::GivenUp;
    if (bits == problem->advertisedBits && !givenUp) answer.conflict = question.conflict();
  }
  answer.state = givenUp ? State::Undecided : State::Impossible;
  if (givenUp) answer.why = "the search was given up";
  return answer;
}

Result<void> judgeJointly(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual,
                          SceneResult& result) {
  uint64_t placed = 0;
  for (const auto& [freedom, samples] : result.freedoms) placed += isPositionFreedom(freedom) ? samples : 0;
  if (!rules.open || result.verdict != Verdict::Allowed || placed == 0 || !drawsFilledTriangles(scene)) return {};
  Result<PlacementAnswer> answer = explainByPlacement(scene, rules, reference, actual);
  if (!answer) return tl::unexpected<Error>(answer.error());
  if (answer->state == State::Impossible) {
    result.verdict = Verdict::Differs;
    result.reason = describe(*answer);
    result.allowed -= placed;
    result.differing += placed;
    for (SampleDifference& difference : result.differences) {
      if (!isPositionFreedom(difference.reason)) continue;
      difference.verdict = Verdict::Differs;
      difference.reason = result.reason;
    }
    std::ranges::stable_sort(result.differences, {}, [](const SampleDifference& d) { return d.verdict != Verdict::Differs; });
  }
  result.placement = std::move(*answer);
  return {};
}

}  // namespace rasterdiff::harness
