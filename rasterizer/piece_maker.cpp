#include "rasterizer/piece_maker.hpp"

#include <utility>

#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/mistakes/mistaken_pieces.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool culledBy(CullMode mode, bool frontFacing) {
  const auto bits = static_cast<uint32_t>(mode);
  const auto face = static_cast<uint32_t>(frontFacing ? CullMode::FRONT : CullMode::BACK);
  return (bits & face) != 0;
}

TieRule tieRuleOf(const Rules& rules) {
  return rules.error == DeliberateError::TieOwnerBottomRight ? TieOwner::BottomRight : tieRule(rules.choices);
}

}  // namespace

// [vk:primsrast-polygons-basic] facing is the sign of a = -doubleArea / 2; a zero area is back-facing.
bool PieceMaker::isFront(double doubleArea) const {
  const bool counterClockwise = doubleArea < 0;  // Vulkan's a > 0
  const bool clockwise = doubleArea > 0;
  return state_.frontFace == FrontFace::COUNTER_CLOCKWISE ? counterClockwise : clockwise;
}

bool PieceMaker::isCulled(double doubleArea) const { return isFaceCulled(isFront(doubleArea)); }

bool PieceMaker::isFaceCulled(bool frontFacing) const { return culledBy(state_.cullMode, frontFacing); }

void PieceMaker::makePieces(Primitive& primitive, std::optional<float> uncutArea) const {
  primitive.pieces.clear();
  primitive.folded = primitive.cut && isFolded(primitive.polygon, rules_.choices.cutFill);
  // One facing for all that is left of the triangle, if a device sees it as one polygon. [choice:cut-fill]
  std::optional<double> whole;
  if (uncutArea) {
    whole = *uncutArea;
  } else if (primitive.folded) {
    whole = static_cast<double>(doubleArea(primitive.polygon));
  }
  primitive.reversed = whole.value_or(0) < 0;
  const bool mistaken = rules_.error != DeliberateError::None;
  const size_t corners = primitive.polygon.size();
  const size_t last = rules_.error == DeliberateError::CutFanShort && corners > 3 ? corners - 1 : corners;
  for (size_t i = 2; i < last; ++i) {
    SetupTriangle triangle;
    triangle.corner = {0, static_cast<uint8_t>(i - 1), static_cast<uint8_t>(i)};
    const auto at = [&](size_t k) { return primitive.polygon[triangle.corner[k]].snapped; };
    triangle.area = doubleArea(at(0), at(1), at(2));
    triangle.frontFacing = isFront(whole.value_or(static_cast<double>(triangle.area)));  // only its sign counts
    if (uncutArea) triangle.frontFacing = triangle.frontFacing || *uncutArea == 0;
    if (mistaken && triangle.area != 0) triangle.frontFacing = mistakenFacing(triangle.frontFacing, primitive, rules_.error);
    triangle.culled = culledBy(state_.cullMode, triangle.frontFacing);
    if (state_.cullMode == CullMode::FRONT || state_.cullMode == CullMode::BACK) ++counts_[Rule::Facing];
    if (triangle.culled) ++counts_[Rule::Culling];
    if (triangle.area == 0) continue;
    // Scan conversion finds no row to fill in what is wound against the area that was computed.
    if (uncutArea && !primitive.folded && (triangle.area < 0) != (*uncutArea < 0)) continue;
    if (triangle.area < 0) {
      std::swap(triangle.corner[1], triangle.corner[2]);
      triangle.flipped = true;
    }
    const TieRule rule = tieRuleOf(rules_);
    for (size_t k = 0; k < 3; ++k) {
      triangle.edges[k] = edgeFunction(at(k), at((k + 1) % 3), rule);
      if (triangle.flipped && rules_.choices.tieWinding == TieWinding::OppositeIfCounterClockwise) {
        triangle.edges[k].ownsTies = !triangle.edges[k].ownsTies;  // [choice:tie-winding]
      }
    }
    if (mistaken) mistakeEdges(triangle.edges, rules_.error);
    primitive.pieces.push_back(triangle);
  }
}

}  // namespace rasterdiff::rasterizer
