#include "rasterizer/explain.hpp"

#include <algorithm>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/freedom_band.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/target_area.hpp"

namespace rasterdiff::rasterizer {
namespace {

// A pixel of margin, so that near misses are shown too.
bool reaches(const Primitive& primitive, const SetupTriangle& piece, SubpixelPosition p) {
  SubpixelPosition low = primitive.polygon[piece.corner[0]].lowest, high = primitive.polygon[piece.corner[0]].highest;
  for (const uint8_t corner : piece.corner) {
    const RasterVertex& v = primitive.polygon[corner];
    low = {std::min(low.x, v.lowest.x), std::min(low.y, v.lowest.y)};
    high = {std::max(high.x, v.highest.x), std::max(high.y, v.highest.y)};
  }
  return p.x >= low.x - kSubpixelOne && p.x <= high.x + kSubpixelOne && p.y >= low.y - kSubpixelOne &&
         p.y <= high.y + kSubpixelOne;
}

EdgeExplanation explainEdge(const RasterVertex& a, const RasterVertex& b, const EdgeFunction& edge, SubpixelPosition p) {
  EdgeExplanation result;
  result.ends = {a.snapped, b.snapped};
  result.value = edge.at(p.x, p.y);
  result.ownsTies = edge.ownsTies;
  result.lowest = result.highest = result.value;
  for (unsigned corner = 0; corner < 16; ++corner) {
    const SubpixelPosition from{(corner & 1) != 0 ? a.highest.x : a.lowest.x, (corner & 2) != 0 ? a.highest.y : a.lowest.y};
    const SubpixelPosition to{(corner & 4) != 0 ? b.highest.x : b.lowest.x, (corner & 8) != 0 ? b.highest.y : b.lowest.y};
    const int64_t value = edgeFunction(from, to, TieOwner::TopLeft).at(p.x, p.y);
    result.lowest = std::min(result.lowest, value);
    result.highest = std::max(result.highest, value);
  }
  return result;
}

Rule decidingRule(const PrimitiveExplanation& e, bool insideScissor) {
  if (e.culled) return Rule::Culling;
  const bool tie = std::any_of(e.edges.begin(), e.edges.end(), [](const EdgeExplanation& x) { return x.value == 0; });
  const bool outside = std::any_of(e.edges.begin(), e.edges.end(), [](const EdgeExplanation& x) { return x.value < 0; });
  if (!insideScissor && !outside) return Rule::Scissor;
  if (tie && !outside) return Rule::TieBreak;
  if (e.clipped && outside) return Rule::ViewVolume;
  return Rule::SampleCoverage;
}

PrimitiveExplanation explainPiece(const Scene& scene, const Rules& rules, const Primitive& primitive,
                                  const SetupTriangle& piece, SubpixelPosition p, bool insideScissor) {
  PrimitiveExplanation result;
  result.primitive = primitive.number;
  result.clip = primitive.clip;
  result.clipped = primitive.cut;
  result.doubleArea = piece.area;
  result.frontFacing = piece.frontFacing;
  result.culled = piece.culled;
  bool inside = true;
  for (size_t i = 0; i < 3; ++i) {
    const RasterVertex& a = primitive.polygon[piece.corner[i]];
    const RasterVertex& b = primitive.polygon[piece.corner[(i + 1) % 3]];
    result.snapped[i] = a.snapped;
    result.edges[i] = explainEdge(a, b, piece.edges[i], p);
    inside = inside && piece.edges[i].covers(p.x, p.y);
  }
  result.covered = inside && !piece.culled && insideScissor;
  result.coverage = result.covered ? Coverage::In : Coverage::Out;
  if (rules.open && insideScissor) {
    const BandVerdict verdict =
        FreedomBand(primitive, scene.state.cullMode, scene.state.frontFace).classifyExactly(p.x, p.y);
    result.coverage = verdict.coverage;
    result.freedom = verdict.freedom;
  }
  result.decidedBy = decidingRule(result, insideScissor);
  const SceneNeeds needs = needsOf(scene);
  if (needs.depth) {
    PieceValues values(scene, needs, rules);
    values.setUp(primitive, piece);
    result.depth = values.depth(p.x / double{kSubpixelOne}, p.y / double{kSubpixelOne}).value;
  }
  return result;
}

}  // namespace

Result<SampleExplanation> explain(const Scene& scene, const Rules& profile, SampleQuery query) {
  const Rules rules = rulesFor(scene, profile);
  const Result<Frame> frame = render(scene, rules);
  if (!frame) return tl::unexpected<Error>(frame.error());
  if (query.x >= scene.target.width || query.y >= scene.target.height || query.sample >= scene.target.samples) {
    return fail(ErrorCode::BadInput, "sample",
                "sample " + std::to_string(query.sample) + " of pixel (" + std::to_string(query.x) + ", " +
                    std::to_string(query.y) + ") is outside the target of " + std::to_string(scene.target.width) + " × " +
                    std::to_string(scene.target.height) + " pixels with " + std::to_string(scene.target.samples) + " sample(s)",
                "X and Y count pixels from the top-left corner, samples count from 0");
  }
  const std::vector<SubpixelPosition> pattern = *samplePattern(scene.target.samples, rules);
  SampleExplanation result;
  result.position = {static_cast<int32_t>(query.x) * kSubpixelOne + pattern[query.sample].x,
                     static_cast<int32_t>(query.y) * kSubpixelOne + pattern[query.sample].y};
  result.insideScissor =
      targetArea(scene, 0, rules.error).contains(static_cast<int32_t>(query.x), static_cast<int32_t>(query.y));
  result.owner = frame->primitive.at(query.x, query.y, query.sample);
  RuleCounts ignored;
  forEachPrimitive(scene, rules, ignored, [&](const Primitive& primitive) {
    for (const SetupTriangle& piece : primitive.pieces) {
      if (!reaches(primitive, piece, result.position)) continue;
      result.primitives.push_back(explainPiece(scene, rules, primitive, piece, result.position, result.insideScissor));
    }
  });
  return result;
}

}  // namespace rasterdiff::rasterizer
