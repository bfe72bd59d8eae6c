#include "harness/compare/suspects.hpp"

#include <algorithm>
#include <bit>

#include "harness/compare/compare.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::DeliberateErrorInfo;
using rasterizer::Rules;

uint64_t differingBits(const Plane<float>& a, const Plane<float>& b) {
  uint64_t differing = 0;
  for (size_t i = 0; i < std::min(a.data.size(), b.data.size()); ++i) {
    differing += std::bit_cast<uint32_t>(a.data[i]) != std::bit_cast<uint32_t>(b.data[i]) ? 1U : 0U;
  }
  return differing;
}

/// Resolved values are judged by their own side's samples, whatever a mistaken reference resolves them to: what the two
/// agree on is explained all the same.
uint64_t unexplained(const SceneResult& result, const Frame& reference, const Frame& actual) {
  uint64_t sum = result.differing;
  for (const ValueStats& value : result.values) {
    uint64_t left = value.differing;
    for (size_t v = 0; v < std::min(reference.resolved.size(), actual.resolved.size()); ++v) {
      if (value.name != reference.resolved[v].name + ".resolved") continue;
      left = std::min(left, differingBits(reference.resolved[v].values, actual.resolved[v].values));
    }
    sum += left;
  }
  return sum;
}

class Trial {
 public:
  Trial(const Scene& scene, const Frame& actual, const rasterizer::SampleQuery& query)
      : scene_(scene), actual_(actual), query_(query) {}

  /// What `rules` leave unexplained in the scene; nothing if they do not explain the sample itself.
  [[nodiscard]] Result<std::optional<uint64_t>> left(const Rules& rules) const {
    const Result<Frame> reference = rasterizer::render(scene_, rules);
    if (!reference) return tl::unexpected(reference.error());
    const Frame sample = withOneSampleOf(*reference, actual_, query_);
    const Result<SceneResult> here = compare(scene_, rules, *reference, sample);
    if (!here) return tl::unexpected(here.error());
    if (unexplained(*here, *reference, sample) > 0) return std::optional<uint64_t>{};
    return all(rules, *reference);
  }

  [[nodiscard]] Result<std::optional<uint64_t>> all(const Rules& rules, const Frame& reference) const {
    const Result<SceneResult> everywhere = compare(scene_, rules, reference, actual_);
    if (!everywhere) return tl::unexpected(everywhere.error());
    return std::optional<uint64_t>{unexplained(*everywhere, reference, actual_)};
  }

 private:
  const Scene& scene_;
  const Frame& actual_;
  const rasterizer::SampleQuery query_;
};

}  // namespace

Frame withOneSampleOf(const Frame& reference, const Frame& actual, const rasterizer::SampleQuery& query) {
  Frame frame;
  frame.width = reference.width;
  frame.height = reference.height;
  frame.samples = reference.samples;
  frame.primitive = reference.primitive;
  frame.count = reference.count;
  frame.depth = reference.depth;
  for (const VaryingPlane& varying : reference.varyings) frame.varyings.push_back({varying.name, varying.values, {}});
  for (const VaryingPlane& plane : reference.resolved) frame.resolved.push_back({plane.name, plane.values, {}});
  const auto take = [&](auto& into, const auto& from, uint32_t sample) {
    for (uint32_t c = 0; c < into.components; ++c) into.at(query.x, query.y, sample, c) = from.at(query.x, query.y, sample, c);
  };
  take(frame.primitive, actual.primitive, query.sample);
  take(frame.count, actual.count, query.sample);
  if (frame.depth && actual.depth) take(*frame.depth, *actual.depth, query.sample);
  for (size_t v = 0; v < std::min(frame.varyings.size(), actual.varyings.size()); ++v) {
    take(frame.varyings[v].values, actual.varyings[v].values, query.sample);
  }
  for (size_t v = 0; v < std::min(frame.resolved.size(), actual.resolved.size()); ++v) {
    take(frame.resolved[v].values, actual.resolved[v].values, 0);
  }
  return frame;
}

Result<Suspicion> suspicionOf(const Scene& scene, const Rules& rules, const Frame& actual,
                              const rasterizer::SampleQuery& query, const std::vector<std::string_view>& ruleIds) {
  const Trial trial(scene, actual, query);
  const Result<Frame> reference = rasterizer::render(scene, rules);
  if (!reference) return tl::unexpected(reference.error());
  const Result<std::optional<uint64_t>> differing = trial.all(rules, *reference);
  if (!differing) return tl::unexpected(differing.error());
  Suspicion suspicion;
  suspicion.differing = differing->value_or(0);
  for (const bool atWork : {true, false}) {
    for (const DeliberateErrorInfo& mistake : rasterizer::deliberateErrors()) {
      if ((std::ranges::find(ruleIds, mistake.rule) != ruleIds.end()) != atWork) continue;
      ++suspicion.tried;
      Rules mistaken = rules;
      mistaken.error = mistake.error;
      const Result<std::optional<uint64_t>> left = trial.left(mistaken);
      if (!left) return tl::unexpected(left.error());
      if (*left && **left < suspicion.differing) suspicion.suspects.push_back({mistake.name, mistake.rule, mistake.what, **left});
    }
    if (!suspicion.suspects.empty()) break;
  }
  if (suspicion.suspects.empty()) return suspicion;
  const uint64_t least = std::ranges::min(suspicion.suspects, {}, &Suspect::left).left;
  std::erase_if(suspicion.suspects, [&](const Suspect& suspect) { return suspect.left > least; });
  return suspicion;
}

}  // namespace rasterdiff::harness
