#include "rasterizer/freedom_band.hpp"

#include <cstdlib>
#include <limits>

#include "rasterizer/facing_freedom.hpp"

namespace rasterdiff::rasterizer {
namespace {

int64_t reach(int32_t nominal, int32_t lowest, int32_t highest) {
  return std::max(std::llabs(int64_t{nominal} - lowest), std::llabs(int64_t{highest} - nominal));
}

bool isCulled(CullMode mode, FrontFace frontFace, bool clockwise) {
  const bool front = (frontFace == FrontFace::CLOCKWISE) == clockwise;
  return (static_cast<uint32_t>(mode) & static_cast<uint32_t>(front ? CullMode::FRONT : CullMode::BACK)) != 0;
}

// (b - a) × (p - a)  // Q47.16
int64_t edgeAt(int64_t ax, int64_t ay, int64_t bx, int64_t by, int64_t px, int64_t py) {
  return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

}  // namespace

FreedomBand::FreedomBand(const Primitive& primitive, CullMode cullMode, FrontFace frontFace)
    : cullMode_(cullMode), frontFace_(frontFace) {
  const std::vector<RasterVertex>& polygon = primitive.polygon;
  const size_t n = polygon.size();
  triangle_ = n == 3 && !primitive.cut;

  int32_t minX = std::numeric_limits<int32_t>::max(), minY = minX;
  int32_t maxX = std::numeric_limits<int32_t>::min(), maxY = maxX;
  for (size_t i = 0; i < n; ++i) {
    const RasterVertex& a = polygon[i];
    minX = std::min(minX, a.lowest.x);
    minY = std::min(minY, a.lowest.y);
    maxX = std::max(maxX, a.highest.x);
    maxY = std::max(maxY, a.highest.y);
  }
  const AreaBand area = areaBand(polygon);
  orientationCertain_ = area.signIsCertain();
  const bool clockwise = area.area > 0;
  if (orientationCertain_) {
    drawn_ = !isCulled(cullMode, frontFace, clockwise);
  } else {
    drawn_ = cullMode != CullMode::FRONT_AND_BACK && area.sideIsFree();
  }

  firstRow_ = minY >> kSubpixelBits;
  lastRow_ = maxY >> kSubpixelBits;
  firstColumn_ = minX >> kSubpixelBits;
  lastColumn_ = maxX >> kSubpixelBits;
  const int64_t extent = (int64_t{maxX} - minX) + (int64_t{maxY} - minY) + 2 * kSubpixelOne;

  for (size_t i = 0; i < n; ++i) {
    const size_t from = clockwise ? i : (i + 1) % n;
    const size_t to = clockwise ? (i + 1) % n : i;
    const auto corner = [&](size_t k) {
      return Corner{polygon[k].snapped, polygon[k].lowest, polygon[k].highest, polygon[k].made};
    };
    Edge edge;
    edge.a = corner(from);
    edge.b = corner(to);
    edge.inner = edgeFunction(edge.a.nominal, edge.b.nominal, TieOwner::TopLeft);
    const int64_t m = std::max({reach(edge.a.nominal.x, edge.a.lowest.x, edge.a.highest.x),
                                reach(edge.a.nominal.y, edge.a.lowest.y, edge.a.highest.y),
                                reach(edge.b.nominal.x, edge.b.lowest.x, edge.b.highest.x),
                                reach(edge.b.nominal.y, edge.b.lowest.y, edge.b.highest.y)});
    // |ΔE| ≤ 2m |p - a|₁ + m |b - a|₁ + 4m² for p within the polygon's box.
    edge.margin = 2 * m * extent + m * (std::llabs(edge.inner.dx) + std::llabs(edge.inner.dy)) + 4 * m * m;
    edges_.push_back(edge);
  }
}

FreedomBand::Row FreedomBand::row(int64_t sampleX, int64_t sampleY, RowSpan limits) const {
  RowSpan possible = limits;
  possible.begin = std::max(possible.begin, firstColumn_);
  possible.end = std::min(possible.end, lastColumn_ + 1);
  if (!drawn_ || possible.empty()) return {};
  if (!orientationCertain_) return {possible, {possible.end, possible.end}};
  RowSpan certain = possible;
  for (const Edge& edge : edges_) {
    // clipRow keeps E >= 0 in `closed` and E > 0 in `open`; the margin moves the edge outward or inward.
    const auto shifted = [&](int64_t margin, RowSpan& span, bool strict) {
      const int64_t constant = edge.inner.at(sampleX, sampleY) + margin;
      const int64_t step = -edge.inner.dy * kSubpixelOne;
      const auto keeps = [&](int64_t value) { return strict ? value > 0 : value >= 0; };
      if (step == 0) {
        if (!keeps(constant)) span.end = span.begin;
        return;
      }
      const int64_t threshold = strict ? 1 : 0;
      const auto floorDiv = [](int64_t a, int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0); };
      if (step > 0) {
        const int64_t first = -floorDiv(constant - threshold, step);
        span.begin = static_cast<int32_t>(std::clamp<int64_t>(first, span.begin, std::max(span.begin, span.end)));
      } else {
        const int64_t last = floorDiv(constant - threshold, -step);
        span.end = static_cast<int32_t>(std::clamp<int64_t>(last + 1, span.begin, std::max(span.begin, span.end)));
      }
    };
    shifted(edge.margin, possible, false);
    shifted(-edge.margin, certain, true);
  }
  if (certain.empty()) certain = {possible.end, possible.end};
  return {possible, certain};
}

FreedomBand::Extremes FreedomBand::extremes(size_t index, int64_t px, int64_t py) const {
  const Edge& edge = edges_[index];
  Extremes result{std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::min()};
  for (unsigned corner = 0; corner < 16; ++corner) {
    const int64_t value = edgeAt((corner & 1) != 0 ? edge.a.highest.x : edge.a.lowest.x,
                                 (corner & 2) != 0 ? edge.a.highest.y : edge.a.lowest.y,
                                 (corner & 4) != 0 ? edge.b.highest.x : edge.b.lowest.x,
                                 (corner & 8) != 0 ? edge.b.highest.y : edge.b.lowest.y, px, py);
    result.lowest = std::min(result.lowest, value);
    result.highest = std::max(result.highest, value);
  }
  return result;
}

BandVerdict FreedomBand::classify(int64_t px, int64_t py) const {
  if (!drawn_) return {};
  bool in = orientationCertain_, forward = true, backward = !orientationCertain_;
  Freedom freedom = Freedom::None;
  size_t undecided = 0, lastUndecided = 0;
  for (size_t i = 0; i < edges_.size(); ++i) {
    const Extremes e = extremes(i, px, py);
    if (e.lowest <= 0) {
      in = false;
      ++undecided;
      lastUndecided = i;
      const Edge& edge = edges_[i];
      const Freedom why = e.lowest == e.highest           ? Freedom::TieOwner
                          : edge.a.made || edge.b.made     ? Freedom::ClipVertexPosition
                                                           : Freedom::SnapRounding;
      freedom = std::max(freedom, why);
    }
    forward = forward && e.highest >= 0;
    backward = backward && e.lowest <= 0;
  }
  if (in) return {Coverage::In, Freedom::None, std::nullopt};
  if (!forward && !backward) return {};
  if (!orientationCertain_) freedom = Freedom::NearZeroArea;
  BandVerdict verdict{Coverage::Either, freedom, std::nullopt};
  if (freedom == Freedom::TieOwner && undecided == 1) {
    verdict.tieEdge = {edges_[lastUndecided].a.nominal, edges_[lastUndecided].b.nominal};
  }
  return verdict;
}

bool FreedomBand::placementCovers(unsigned placement, int64_t px, int64_t py) const {
  std::array<SubpixelPosition, 3> v;
  for (size_t i = 0; i < 3; ++i) {
    const Corner& corner = edges_[i].a;
    const auto place = [&placement](int32_t lowest, int32_t highest) {
      const auto step = static_cast<int32_t>(placement % 3);
      placement /= 3;
      return std::min(lowest + step, highest);
    };
    v[i].x = place(corner.lowest.x, corner.highest.x);
    v[i].y = place(corner.lowest.y, corner.highest.y);
  }
  const int64_t area = doubleArea(v[0], v[1], v[2]);
  if (area == 0 || isCulled(cullMode_, frontFace_, area > 0)) return false;
  for (size_t i = 0; i < 3; ++i) {
    const SubpixelPosition& a = v[i];
    const SubpixelPosition& b = v[(i + 1) % 3];
    const int64_t value = edgeAt(a.x, a.y, b.x, b.y, px, py);
    if (area > 0 ? value < 0 : value > 0) return false;
  }
  return true;
}

BandVerdict FreedomBand::classifyExactly(int64_t px, int64_t py) const {
  const BandVerdict verdict = classify(px, py);
  if (verdict.coverage != Coverage::Either || !triangle_) return verdict;
  // In wider boxes (a coarser grid, which a device may refine, or viewport bounds that may move) the list would not be whole.
  for (const Edge& edge : edges_) {
    if (edge.a.highest.x - edge.a.lowest.x > 2 || edge.a.highest.y - edge.a.lowest.y > 2) return verdict;
  }
  // Reversed edges start at the corners 1, 2, 0: a rotation, so the winding of a placement is the primitive's own.
  for (unsigned placement = 0; placement < 729; ++placement) {
    if (placementCovers(placement, px, py)) return verdict;
  }
  return {};
}

}  // namespace rasterdiff::rasterizer
