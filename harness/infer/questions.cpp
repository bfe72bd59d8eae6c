#include "harness/infer/questions.hpp"

#include <algorithm>

#include "harness/infer/experiments.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::Rules;
using Contenders = std::span<const Rules>;

uint32_t inTurn(const std::vector<uint32_t>& counts, uint32_t round) { return counts[round % counts.size()]; }

Question gridQuestion(const std::vector<uint32_t>& counts) {
  const Proposal propose = [counts](Prng& random, uint32_t round, Contenders contenders) -> std::optional<Scene> {
    const uint32_t samples = inTurn(counts, round / 4);
    switch (round % 4) {
      case 0: return snapScene(random, samples, false, contenders.front());
      case 1: return snapScene(random, samples, true, contenders.front());
      default: return viewportScene(random, samples, contenders);
    }
  };
  const auto rounds = static_cast<uint32_t>(80 * counts.size());
  return {"subpixel grid and viewport",
          {{Choice::SubPixelBits, Choice::SnapRounding, Choice::SnapOrigin, Choice::ViewportArithmetic}, rounds, propose}};
}

Question clipQuestion(const std::vector<uint32_t>& counts) {
  return {"clipping",
          {{Choice::ClipArithmetic, Choice::CutFill, Choice::CullPosition}, 120, [counts](Prng& random, uint32_t round, Contenders contenders) {
             const uint32_t samples = inTurn(counts, round / 2);
             return round % 2 == 0 ? clipScene(random, samples, contenders) : sliverScene(random, samples, contenders);
           }}};
}

Question distanceQuestion(const std::vector<uint32_t>& counts) {
  return {"clip distances",
          {{Choice::ClipDistances}, 24, [counts](Prng& random, uint32_t round, Contenders contenders) {
             return distanceScene(random, inTurn(counts, round), contenders);
           }}};
}

Question outlineQuestion(const std::vector<uint32_t>& counts) {
  return {"outlines",
          {{Choice::CutOutline}, 30, [counts](Prng& random, uint32_t round, Contenders contenders) {
             return outlineScene(random, inTurn(counts, round), round >= 10, contenders);
           }}};
}

Question regionQuestion(const std::vector<uint32_t>& counts) {
  return {"drawing region",
          {{Choice::DrawingRegion}, 30, [counts](Prng& random, uint32_t round, Contenders contenders) {
             return regionScene(random, inTurn(counts, round), contenders);
           }}};
}

Question pointQuestion(const std::vector<uint32_t>& counts) {
  return {"points",
          {{Choice::PointArithmetic, Choice::PointClip}, 96, [counts](Prng& random, uint32_t round, Contenders contenders) -> std::optional<Scene> {
             const uint32_t samples = inTurn(counts, round / 2);
             const Rules& rules = contenders.front();
             return round % 2 == 0 ? pointScene(random, samples, rules) : outerPointScene(random, samples, rules);
           }}};
}

Question lineQuestion(const std::vector<uint32_t>& counts, const Limits& limits) {
  return {"lines",
          {{Choice::LineArithmetic, Choice::DiamondExit}, 48, [counts, limits](Prng& random, uint32_t round, Contenders) {
             const uint32_t samples = inTurn(counts, round / 3);
             return round % 3 == 2 ? diamondScene(random, samples, limits) : lineScene(random, samples, round % 3 == 1, limits);
           }}};
}

Question biasQuestion() {
  return {"depth bias",
          {{Choice::DepthBiasUnit, Choice::DepthBiasExponent, Choice::DepthBiasSlope}, 60, [](Prng& random, uint32_t round, Contenders) -> std::optional<Scene> {
             return biasScene(random, round % 3 == 2 ? DepthFormat::D32_SFLOAT : DepthFormat::D16_UNORM);
           }}};
}

Question centroidQuestion(uint32_t samples) {
  constexpr double kPlaceTolerance = 1.0 / 64;  // pixels: less than half the distance of two samples of sixteen
  Group group{{Choice::Centroid}, 8, [samples](Prng& random, uint32_t, Contenders) -> std::optional<Scene> {
                return placeScene(random, samples, Interpolation::centroid, false);
              }};
  group.tolerance = kPlaceTolerance;
  return {"centroid", group};
}

Question planeQuestion() {
  return {"positions under values",
          {{Choice::PlanePositions}, 16, [](Prng& random, uint32_t round, Contenders) -> std::optional<Scene> {
             return round % 2 == 0 ? steepScene(random) : steepCutScene(random);
           }}};
}

Question resolveQuestion(uint32_t samples) {
  return {"resolve",
          {{Choice::ResolveArithmetic}, 8, [samples](Prng& random, uint32_t, Contenders) -> std::optional<Scene> {
             return resolveScene(random, samples);
           }}};
}

}  // namespace

Question tieQuestion(const Limits& limits, std::vector<SampleSweep> sweeps) {
  const std::vector<uint32_t> counts = sampleCounts(limits);
  Group group{{Choice::TieOwner, Choice::SlantedTies, Choice::TieWinding}, static_cast<uint32_t>(8 * counts.size()),
              [counts](Prng& random, uint32_t round, Contenders contenders) -> std::optional<Scene> {
                return tieScene(random, inTurn(counts, round), contenders.front());
              }};
  group.complete = [found = std::move(sweeps)](rasterizer::Choices& choices) { placeSamples(found, choices); };
  return {"ties and sample locations", group};
}

std::vector<Question> furtherQuestions(const Limits& limits) {
  const std::vector<uint32_t> counts = sampleCounts(limits);
  std::vector<Question> questions{gridQuestion(counts), regionQuestion(counts), clipQuestion(counts), distanceQuestion(counts), pointQuestion(counts),
                                  lineQuestion(counts, limits), outlineQuestion(counts), planeQuestion(), biasQuestion()};
  if (counts.back() > 1) {
    questions.push_back(centroidQuestion(counts.back()));
    questions.push_back(resolveQuestion(counts.back()));
  }
  return questions;
}

}  // namespace rasterdiff::harness
