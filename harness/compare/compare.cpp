#include "harness/compare/compare.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <span>

#include "harness/compare/legal_outcomes.hpp"
#include "harness/compare/sample_pass.hpp"
#include "harness/compare/whole_pixels.hpp"
#include "rasterizer/choice_table.hpp"
#include "rasterizer/depth/format.hpp"
#include "rasterizer/depth/resolve_depth.hpp"
#include "rasterizer/fragment/resolve.hpp"
#include "rasterizer/fragment/value_freedoms.hpp"
#include "rasterizer/parallel.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::Freedom;
using rasterizer::SampleQuery;

constexpr size_t kQueriesAtOnce = size_t{1} << 18;   // bounds the memory of evidence
constexpr size_t kSamplesAThread = size_t{1} << 16;  // at least: a thread takes some 20 µs to start
constexpr size_t kPieceStep = 1024;                  // samples

std::string describe(uint32_t primitive) { return primitive == 0 ? "none" : fmt::format("primitive {}", primitive); }

std::string whatIsWrong(const SampleDifference& d) {
  if (d.expectedPrimitive == d.actualPrimitive) {
    return fmt::format("written {} time(s) where {} is right", d.actualCount, d.expectedCount);
  }
  return fmt::format("{} where {} is right", describe(d.actualPrimitive), describe(d.expectedPrimitive));
}

class Comparison {
 public:
  Comparison(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual)
      : scene_(scene), rules_(rules), reference_(reference), actual_(actual), mayOverlapItself_(mayOverlapItself(scene, rules)), pass_(reference, actual, mayOverlapItself_) {
    if (reference.depth) clearDepth_ = rasterizer::clearedDepth(scene.target.depthClearValue, *scene.target.depthFormat).bounds;
  }

  Result<SceneResult> run(unsigned threads, const RowPasses* early) {
    result_.id = scene_.name;
    result_.samples = reference_.primitive.data.size();
    for (size_t first = 0; first < result_.samples; first += kSamplesAtOnce) {
      if (early == nullptr || !early->addTo(pass_)) pass(first, std::min(first + kSamplesAtOnce, static_cast<size_t>(result_.samples)), threads);
      if (std::max(pass_.questions.size(), pass_.overlaps.size()) < kQueriesAtOnce) continue;
      if (Result<void> judged = judgeQueries(); !judged) return tl::unexpected<Error>(judged.error());
    }
    if (Result<void> judged = judgeQueries(); !judged) return tl::unexpected<Error>(judged.error());
    result_.same = pass_.same;
    result_.coveredSamples = pass_.coveredSamples;
    compareResolved();
    finish();
    return std::move(result_);
  }

 private:
  // Each thread has the same number of samples in one piece; the pieces are put together in their order.
  void pass(size_t first, size_t end, unsigned threads) {
    threads = static_cast<unsigned>(std::clamp<size_t>((end - first) / kSamplesAThread, 1, threads));
    if (threads == 1) return pass_.run(first, end);
    const size_t share = (end - first) / threads / kPieceStep * kPieceStep;
    std::vector<SamplePass> further(threads - 1, SamplePass(reference_, actual_, mayOverlapItself_));
    rasterizer::inParallel(threads, [&](unsigned k) {
      const size_t from = first + k * share, to = k + 1 == threads ? end : from + share;
      (k == 0 ? pass_ : further[k - 1]).run(from, to);
    });
    for (const SamplePass& piece : further) pass_.append(piece);
  }

  // All that the parts of one primitive that may cover a sample allow there; none if no part may.
  static std::optional<Candidate> merged(const std::vector<Candidate>& candidates, uint32_t primitive) {
    std::optional<Candidate> all;
    for (const Candidate& candidate : candidates) {
      if (candidate.primitive != primitive) continue;
      if (!all) {
        all = candidate;
        continue;
      }
      all->depth = hull(all->depth, candidate.depth);
      for (size_t c = 0; c < all->varyings.size(); ++c) all->varyings[c] = hull(all->varyings[c], candidate.varyings[c]);
    }
    return all;
  }

  // Values of a sample that several parts of its winner may cover: judged against all of them.
  void compareOverlap(const SampleQuery& place, const std::vector<Candidate>& candidates) {
    const size_t index = reference_.primitive.index(place.x, place.y, place.sample);
    const std::optional<Candidate> all = merged(candidates, reference_.primitive.data[index]);
    pass_.compareValues(place, index, true, all ? &*all : nullptr);
  }

  // [vk:VkResolveModeFlagBits] A resolved value is the mean of the samples that the same side drew, whatever they are.
  void compareResolved() {
    const size_t first = pass_.values.size() - actual_.resolved.size();
    std::vector<Bounds> exact;
    const std::optional<ResolveMode> depthMode = scene_.target.depthResolveMode;
    const size_t colours = actual_.resolved.size() - (depthMode ? 1 : 0);
    if (depthMode) compareResolvedDepth(pass_.values.back(), *depthMode);
    for (size_t v = 0; v < colours; ++v) {
      const Plane<float>& samples = actual_.varyings[v].values;
      const Plane<float>& means = actual_.resolved[v].values;
      const size_t components = samples.components, perPixel = samples.samples * components;
      for (size_t i = 0; i < means.data.size(); ++i) {
        const size_t pixel = i / components, component = i % components;
        const std::span<const float> own = std::span(samples.data).subspan(pixel * perPixel + component, perPixel - component);
        exact.clear();
        for (const float value : own) exact.push_back({value, value});
        const rasterizer::Interpolated mean = rasterizer::meanOf(own, exact, components, rules_.choices.resolveArithmetic);
        pass_.values[first + v].add({static_cast<uint32_t>(pixel % means.width), static_cast<uint32_t>(pixel / means.width), 0,
                                static_cast<uint32_t>(component)},
                               mean.value, means.data[i], mean.bounds);
      }
    }
  }

  void compareResolvedDepth(ValueAccumulator& values, ResolveMode mode) const {
    const Plane<float>& samples = *actual_.depth;
    const Plane<float>& depths = actual_.resolved.back().values;
    std::vector<Bounds> exact;
    for (size_t pixel = 0; pixel < depths.data.size(); ++pixel) {
      const std::span<const float> own = std::span(samples.data).subspan(pixel * samples.samples, samples.samples);
      exact.clear();
      for (const float depth : own) exact.push_back({depth, depth});
      const rasterizer::Interpolated one = rasterizer::resolvedDepth(own, exact, mode, *scene_.target.depthFormat);
      values.add({static_cast<uint32_t>(pixel % depths.width), static_cast<uint32_t>(pixel / depths.width), 0, 0}, one.value,
                 depths.data[pixel], one.bounds);
    }
  }

  // Values of a sample whose legal winner is not the nominal one: judged against that winner's own intervals.
  void compareOtherWinner(const SampleQuery& place, size_t index, const Candidate& winner) {
    size_t plane = 0, flattened = 0;
    const auto middle = [](Bounds b) { return b.lo == b.hi ? b.lo : b.lo + (b.hi - b.lo) / 2; };
    const auto compareOne = [&](uint32_t component, float actual, Bounds legal) {
      if (legal.hi - legal.lo == std::numeric_limits<float>::infinity()) return;
      pass_.values[plane].add({place.x, place.y, place.sample, component}, middle(legal), actual, legal);
    };
    if (actual_.depth) {
      if (scene_.state.depthTestEnable && scene_.state.depthWriteEnable) {
        compareOne(0, actual_.depth->data[index], winner.depth);
      }
      ++plane;
    }
    for (const VaryingPlane& varying : actual_.varyings) {
      const size_t components = varying.values.components;
      for (size_t c = 0; c < components; ++c) {
        compareOne(static_cast<uint32_t>(c), varying.values.data[index * components + c], winner.varyings[flattened++]);
      }
      ++plane;
    }
  }

  Result<void> judgeQueries() {
    Result<void> judged = withEvidence(pass_.questions, [&](const SampleQuery& place, const std::vector<Candidate>& evidence) {
      judge(place, evidence);
    });
    if (!judged) return judged;
    return withEvidence(pass_.overlaps, [&](const SampleQuery& place, const std::vector<Candidate>& evidence) {
      compareOverlap(place, evidence);
    });
  }

  template <class Judge>
  Result<void> withEvidence(std::vector<SampleQuery>& queries, const Judge& judgeOne) {
    for (size_t first = 0; first < queries.size(); first += kQueriesAtOnce) {
      const std::span<const SampleQuery> some = std::span(queries).subspan(first, std::min(kQueriesAtOnce, queries.size() - first));
      const auto evidence = rasterizer::candidates(scene_, rules_, some);
      if (!evidence) return tl::unexpected<Error>(evidence.error());
      for (size_t q = 0; q < some.size(); ++q) judgeOne(some[q], (*evidence)[q]);
    }
    queries.clear();
    return {};
  }

  void judge(const SampleQuery& place, const std::vector<Candidate>& candidates) {
    const size_t index = reference_.primitive.index(place.x, place.y, place.sample);
    SampleDifference d;
    d.x = place.x;
    d.y = place.y;
    d.sample = place.sample;
    d.expectedPrimitive = reference_.primitive.data[index];
    d.actualPrimitive = actual_.primitive.data[index];
    d.expectedCount = reference_.count.data[index];
    d.actualCount = actual_.count.data[index];
    const Outcome outcome = judgeOutcome(scene_.state, clearDepth_, reference_.depth.has_value(),
                                         candidates, d.actualPrimitive, d.actualCount);
    if (outcome.legal && (!wholePixels_ || pixelIsWhole(scene_, actual_, place.x, place.y))) {
      const rasterizer::FreedomInfo& freedom = rasterizer::info(outcome.freedom);
      d.verdict = Verdict::Allowed;
      d.reason = freedom.id;
      d.anchor = freedom.anchor;
      ++result_.allowed;
      ++result_.freedoms[d.reason];
      if (outcome.winner != nullptr && d.actualPrimitive != d.expectedPrimitive) {
        compareOtherWinner(place, index, *merged(candidates, outcome.winner->primitive));
      }
    } else {
      d.verdict = Verdict::Differs;
      d.reason = whatIsWrong(d);
      d.anchor = "vk:primsrast-polygons-basic";
      ++result_.differing;
    }
    list(std::move(d));
  }

  void list(SampleDifference d) {
    std::vector<SampleDifference>& listed = d.verdict == Verdict::Differs ? differing_ : allowed_;
    if (listed.size() < kListedDifferences) listed.push_back(std::move(d));
  }

  void finish() {
    result_.differences = std::move(differing_);
    for (SampleDifference& d : allowed_) {
      if (result_.differences.size() == kListedDifferences) break;
      result_.differences.push_back(std::move(d));
    }
    uint64_t valuesAllowed = 0, valuesDiffering = 0;
    std::string wrongPlanes;
    const std::vector<Freedom> planeFreedoms = rasterizer::valueFreedoms(scene_, rules_);
    for (size_t plane = 0; plane < pass_.values.size(); ++plane) {
      result_.values.push_back(pass_.values[plane].take());
      const ValueStats& stats = result_.values.back();
      if (stats.allowed > 0 && planeFreedoms[plane] != Freedom::None) {
        result_.freedoms[std::string(rasterizer::info(planeFreedoms[plane]).id)] += 0;
      }
      valuesAllowed += stats.allowed;
      valuesDiffering += stats.differing;
      if (stats.differing > 0) wrongPlanes += fmt::format("{}{}", wrongPlanes.empty() ? "" : ", ", stats.name);
    }
    if (valuesAllowed > 0) result_.freedoms[std::string(rasterizer::info(Freedom::Evaluation).id)] += 0;
    if (result_.differing > 0 || valuesDiffering > 0) {
      result_.verdict = Verdict::Differs;
      if (result_.differing > 0) result_.reason = fmt::format("{} sample(s) differ in coverage", result_.differing);
      if (valuesDiffering > 0) {
        result_.reason += fmt::format("{}{} value(s) outside their interval: {}", result_.reason.empty() ? "" : "; ",
                                      valuesDiffering, wrongPlanes);
      }
      return;
    }
    if (result_.allowed == 0 && valuesAllowed == 0) return;
    result_.verdict = Verdict::Allowed;
    for (const auto& [freedom, count] : result_.freedoms) {
      result_.reason += (result_.reason.empty() ? "" : ", ") + freedom;
    }
  }

  const Scene& scene_;
  const rasterizer::Rules& rules_;
  const Frame& reference_;
  const Frame& actual_;
  SceneResult result_;
  Bounds clearDepth_;
  const bool wholePixels_ = coversWholePixels(scene_);
  const bool mayOverlapItself_;
  SamplePass pass_;  // its values: depth, varyings, built-ins, resolved planes
  std::vector<SampleDifference> differing_, allowed_;
};

}  // namespace

Result<SceneResult> compare(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference,
                            const Frame& actual, unsigned threads, const RowPasses* early) {
  if (!alike(reference, actual)) {
    return fail(ErrorCode::BadInput, scene.name, "the two frames do not have the same planes",
                "both have to be rendered from this scene");
  }
  const rasterizer::Rules applied = rasterizer::rulesFor(scene, rules);
  return Comparison(scene, applied, reference, actual).run(threads, early);
}

}  // namespace rasterdiff::harness
