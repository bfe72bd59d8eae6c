#include "harness/export/amber_expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "harness/compare/legal_outcomes.hpp"
#include "harness/export/amber_text.hpp"
#include "rasterizer/depth/format.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::SampleQuery;
using Candidates = std::vector<std::vector<Candidate>>;

/// Consecutive numbers of a buffer as one command each; a gap begins the next one.
class Runs {
 public:
  Runs(std::string buffer, std::string_view comparator, std::string& out) : buffer_(std::move(buffer)), comparator_(comparator), out_(out) {}
  Runs(const Runs&) = delete;
  Runs& operator=(const Runs&) = delete;
  ~Runs() { end(); }

  /// `at`: bytes from the start of the buffer.
  void add(uint64_t at, std::string_view number) {
    if (at != next_ || length_ == kLongest) end();
    if (length_ == 0) out_ += fmt::format("EXPECT {} IDX {} {}", buffer_, at, comparator_);
    fmt::format_to(std::back_inserter(out_), " {}", number);
    next_ = at + 4;
    ++length_;
  }

  void end() {
    if (length_ > 0) out_ += '\n';
    length_ = 0;
  }

 private:
  static constexpr uint32_t kLongest = 64;  // numbers
  const std::string buffer_;
  const std::string_view comparator_;
  std::string& out_;
  uint64_t next_ = 0;
  uint32_t length_ = 0;
};

Result<Candidates> candidatesOf(const Scene& scene, const rasterizer::Rules& rules) {
  std::vector<SampleQuery> queries;
  for (uint32_t y = 0; y < scene.target.height; ++y) {
    for (uint32_t x = 0; x < scene.target.width; ++x) {
      for (uint32_t s = 0; s < scene.target.samples; ++s) queries.push_back({x, y, s});
    }
  }
  return rasterizer::candidates(scene, rules, queries);
}

/// The only primitive that may be the last one at a sample, 0 for none; nothing if several may.
class SettledWinner {
 public:
  explicit SettledWinner(const Scene& scene) : state_(scene.state), hasDepth_(scene.target.depthFormat.has_value()) {
    if (hasDepth_) clear_ = rasterizer::clearedDepth(scene.target.depthClearValue, *scene.target.depthFormat).bounds;
  }

  [[nodiscard]] std::optional<uint32_t> of(const std::vector<Candidate>& candidates) const {
    std::optional<uint32_t> winner;
    const auto may = [&](uint32_t primitive) {
      for (uint32_t count = primitive == 0 ? 0 : 1; count <= (primitive == 0 ? 0 : candidates.size()); ++count) {
        if (judgeOutcome(state_, clear_, hasDepth_, candidates, primitive, count).legal) return true;
      }
      return false;
    };
    if (may(0)) winner = 0;
    for (size_t i = 0; i < candidates.size(); ++i) {
      if ((i > 0 && candidates[i].primitive == candidates[i - 1].primitive) || !may(candidates[i].primitive)) continue;
      if (winner && *winner != candidates[i].primitive) return std::nullopt;
      winner = candidates[i].primitive;
    }
    return winner;
  }

 private:
  const State& state_;
  const bool hasDepth_;
  Bounds clear_;
};

/// What all parts of `primitive` that may cover a sample allow for component `c`, counted over all varyings.
Bounds legalInput(const std::vector<Candidate>& candidates, uint32_t primitive, size_t c) {
  Bounds legal{INFINITY, -INFINITY};
  for (const Candidate& candidate : candidates) {
    if (candidate.primitive != primitive) continue;
    legal = {std::min(legal.lo, candidate.varyings[c].lo), std::max(legal.hi, candidate.varyings[c].hi)};
  }
  return legal;
}

void expectVaryings(const Scene& scene, const Candidates& candidates, const std::vector<std::optional<uint32_t>>& winners,
                    AmberExpectations& all) {
  size_t first = 0;
  for (size_t v = 0; v < scene.draws[0].varyings.size(); ++v) {
    const uint32_t components = scene.draws[0].varyings[v].components;
    for (const bool lowest : {true, false}) {
      Runs runs(fmt::format("drawn{}", v), lowest ? "GE" : "LE", all.commands);
      for (size_t pixel = 0; pixel < winners.size(); ++pixel) {
        if (winners[pixel].value_or(0) == 0) continue;
        for (uint32_t c = 0; c < components; ++c) {
          const Bounds legal = legalInput(candidates[pixel], *winners[pixel], first + c);
          if (!std::isfinite(legal.lo) || !std::isfinite(legal.hi)) continue;
          runs.add((pixel * 4 + c) * 4, amberFloat(lowest ? legal.lo : legal.hi));
          if (lowest) ++all.values;
        }
      }
    }
    first += components;
  }
}

}  // namespace

Result<AmberExpectations> expectedPixels(const Scene& scene, const rasterizer::Rules& rules) {
  const Result<Candidates> candidates = candidatesOf(scene, rules);
  if (!candidates) return tl::unexpected(candidates.error());
  AmberExpectations all;
  const SettledWinner settled(scene);
  std::vector<std::optional<uint32_t>> winners;
  {
    Runs runs("drawn", "EQ", all.commands);
    for (size_t pixel = 0; pixel < candidates->size(); ++pixel) {
      winners.push_back(settled.of((*candidates)[pixel]));
      ++(winners.back() ? all.expected : all.free);
      if (winners.back()) runs.add(pixel * 4, std::to_string(*winners.back()));
    }
  }
  expectVaryings(scene, *candidates, winners, all);
  return all;
}

Result<AmberExpectations> expectedMasks(const Scene& scene, const rasterizer::Rules& rules) {
  const Result<Candidates> candidates = candidatesOf(scene, rules);
  if (!candidates) return tl::unexpected(candidates.error());
  const uint32_t samples = scene.target.samples;
  const size_t pixels = candidates->size() / samples;
  struct Mask {
    uint32_t certain = 0, possible = 0;
  };
  std::vector<Mask> masks(pixels * primitiveCount(scene));
  for (size_t i = 0; i < candidates->size(); ++i) {
    for (const Candidate& candidate : (*candidates)[i]) {
      Mask& mask = masks[(candidate.primitive - 1) * pixels + i / samples];
      const uint32_t bit = 1U << (i % samples);
      mask.possible |= bit;
      if (candidate.coverage == Coverage::In) mask.certain |= bit;
    }
  }
  AmberExpectations all;
  Runs runs("masks", "EQ", all.commands);
  for (size_t i = 0; i < masks.size(); ++i) {
    const bool known = masks[i].certain == masks[i].possible;
    (known ? all.expected : all.free) += samples;
    if (known) runs.add(i * 4, std::to_string(masks[i].certain));
  }
  runs.end();
  return all;
}

}  // namespace rasterdiff::harness
