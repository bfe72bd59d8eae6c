#include "rasterizer/cut_polygon.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

std::vector<SubpixelPosition> cornersOf(std::span<const RasterVertex> polygon) {
  std::vector<SubpixelPosition> corners;
  for (const RasterVertex& vertex : polygon) corners.push_back(vertex.snapped);
  return corners;
}

bool same(SubpixelPosition a, SubpixelPosition b) { return a.x == b.x && a.y == b.y; }

// Does every corner turn the way of the whole, without going back?
bool isConvex(std::span<const RasterVertex> polygon) {
  std::vector<SubpixelPosition> corners = cornersOf(polygon);
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  while (corners.size() > 1 && same(corners.front(), corners.back())) corners.pop_back();
  if (corners.size() < 3) return true;  // nothing to cover
  bool left = false, right = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    const SubpixelPosition a = corners[i], b = corners[(i + 1) % corners.size()], c = corners[(i + 2) % corners.size()];
    const int64_t turn = doubleArea(a, b, c);
    const int64_t onward = (int64_t{b.x} - a.x) * (int64_t{c.x} - b.x) + (int64_t{b.y} - a.y) * (int64_t{c.y} - b.y);
    left = left || turn < 0 || (turn == 0 && onward < 0);
    right = right || turn > 0 || (turn == 0 && onward < 0);
  }
  return !(left && right);
}

}  // namespace

int64_t doubleArea(std::span<const RasterVertex> polygon) {
  int64_t area = 0;  // a fan of at most 17 triangles of ±2^58 each
  for (size_t i = 2; i < polygon.size(); ++i) area += doubleArea(polygon[0].snapped, polygon[i - 1].snapped, polygon[i].snapped);
  return area;
}

bool isFolded(std::span<const RasterVertex> polygon, CutFill fill) {
  return fill != CutFill::Fan && polygon.size() > 3 && !isConvex(polygon);
}

SpanFill::SpanFill(std::span<const SubpixelPosition> corners, bool reversed, TieRule rule) : ownsTop_(ownsTies(rule, 1, 0)) {
  for (size_t i = 0; i < corners.size(); ++i) {
    const SubpixelPosition &a = corners[i], &b = corners[(i + 1) % corners.size()];
    edges_.push_back(reversed ? edgeFunction(b, a, rule) : edgeFunction(a, b, rule));
  }
}

bool SpanFill::covers(int64_t px, int64_t py, bool& tie) const {
  const EdgeFunction *left = nullptr, *right = nullptr;
  tie = false;
  for (const EdgeFunction& edge : edges_) {
    const int64_t top = std::min(edge.ay, edge.ay + edge.dy), bottom = std::max(edge.ay, edge.ay + edge.dy);
    const bool inRows = ownsTop_ ? py >= top && py < bottom : py > top && py <= bottom;
    if (edge.dy != 0 && inRows) (edge.dy < 0 ? left : right) = &edge;
  }
  if (left == nullptr || right == nullptr) return false;
  tie = left->at(px, py) == 0 || right->at(px, py) == 0;
  return left->covers(px, py) && right->covers(px, py);
}

CutPolygon::CutPolygon(const Primitive& primitive, const Rules& rules)
    : primitive_(primitive), reversed_(primitive.reversed) {
  if (rules.choices.cutFill == CutFill::Spans) {
    spans_.emplace(cornersOf(primitive.polygon), reversed_, tieRule(rules.choices));
  }
}

std::optional<size_t> CutPolygon::pieceAt(int64_t px, int64_t py) const {
  int winding = 0;
  std::optional<size_t> piece;
  for (size_t i = 0; i < primitive_.pieces.size(); ++i) {
    const SetupTriangle& candidate = primitive_.pieces[i];
    if (!candidate.covers(px, py)) continue;
    winding += candidate.flipped ? -1 : 1;
    // The values are those of a piece that is wound as the whole is.
    if (!piece || primitive_.pieces[*piece].flipped != reversed_) piece = i;
  }
  if (!spans_) return winding == 0 ? std::nullopt : piece;
  bool tie = false;
  if (!spans_->covers(px, py, tie)) return std::nullopt;
  return piece.value_or(0);
}

}  // namespace rasterdiff::rasterizer
