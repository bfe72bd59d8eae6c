#include "rasterizer/points/square_point.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/lines/float_corners.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Samples low <= p < high in 1/256 pixel.
struct Interval {
  int64_t low = 0, high = 0;
  [[nodiscard]] bool contains(int64_t p) const { return p >= low && p < high; }
};

class SquarePoint final : public Shape {
 public:
  struct Axis {
    Interval nominal;
    double low = 0, high = 0;    // the sides of the nominal square, 1/256 pixel
    Interval certain, possible;  // the closed square for every legal centre, and for any (possible: low <= p <= high - 1)
  };
  SquarePoint(const Axis& x, const Axis& y, bool sizeIsFree) : x_(x), y_(y), sizeIsFree_(sizeIsFree) {}

  [[nodiscard]] Rows rows() const override {
    const RowSpan span = pixels(y_);
    return {span.begin, span.end - 1};
  }
  [[nodiscard]] RowSpan columns(int32_t) const override { return pixels(x_); }
  [[nodiscard]] bool covers(int64_t px, int64_t py, bool& tie) const override {
    const auto onBorder = [](const Interval& i, int64_t p) { return p == i.low || p == i.high; };
    const auto touches = [](const Interval& i, int64_t p) { return p >= i.low && p <= i.high; };
    tie = touches(x_.nominal, px) && touches(y_.nominal, py) && (onBorder(x_.nominal, px) || onBorder(y_.nominal, py));
    return x_.nominal.contains(px) && y_.nominal.contains(py);
  }
  [[nodiscard]] ShapeFacts facts(int64_t px, int64_t py) const override {
    const auto side = [](std::string_view name, double inside, bool owns) {
      return SideFacts{name, inside / kSubpixelOne, inside == 0, owns};
    };
    const double x = static_cast<double>(px), y = static_cast<double>(py);
    ShapeFacts facts;
    facts.sides = {side("left", x - x_.low, true), side("right", x_.high - x, false), side("top", y - y_.low, true),
                   side("bottom", y_.high - y, false)};
    facts.corners = {{x_.low / kSubpixelOne, y_.low / kSubpixelOne, 0}, {x_.high / kSubpixelOne, y_.high / kSubpixelOne, 0}};
    return facts;
  }
  [[nodiscard]] BandVerdict classify(int64_t px, int64_t py) const override {
    if (x_.certain.contains(px) && y_.certain.contains(py)) return {Coverage::In, Freedom::None, std::nullopt};
    if (!x_.possible.contains(px) || !y_.possible.contains(py)) return {};
    bool tie = false;
    static_cast<void>(covers(px, py, tie));
    return {Coverage::Either, tie ? Freedom::TieOwner : sizeIsFree_ ? Freedom::PointSizeStep : Freedom::SnapRounding, std::nullopt};
  }

 private:
  // The nominal square may be larger than any legal one: a profile may have a bug.
  static RowSpan pixels(const Axis& axis) {
    const int64_t low = std::min(axis.possible.low, axis.nominal.low), high = std::max(axis.possible.high, axis.nominal.high);
    return {static_cast<int32_t>(low >> kSubpixelBits), static_cast<int32_t>((high - 1) >> kSubpixelBits) + 1};
  }

  Axis x_, y_;
  bool sizeIsFree_;
};

// As snapFrom, halves to even.
int64_t snapEven(float origin, float pixels) {
  constexpr double kLimit = 1 << 28;
  const float steps = static_cast<float>(kSubpixelOne) * (pixels - origin);
  return static_cast<int64_t>(std::nearbyint(std::clamp(double{steps}, -kLimit, kLimit))) + static_cast<int64_t>(origin * kSubpixelOne);
}

// The centre snapped, the side in whole subpixels (halves up, or to even) and at least a pixel, its half rounded down.
Interval aroundSnapped(float centre, float size, bool even, const VertexStage& stage) {
  const double subpixels = double{size} * kSubpixelOne;
  const auto whole = static_cast<int64_t>(even ? std::nearbyint(subpixels) : std::floor(subpixels + 0.5));
  const auto side = std::max<int64_t>(kSubpixelOne, whole);
  const float origin = stage.samples == 1 ? 0.5F : 0.0F;
  const int64_t low = (even ? snapEven(origin, centre) : snapFrom(origin, centre)) - side / 2;
  return {low, low + side};
}

// A square of corners made in clip space, as a polygon's vertices are. // 0.5 / (½ · viewport) = one pixel, halved
Interval clipCorners(float coordinate, float w, const ViewportAxis& axis, float size, bool ownsLow, const VertexStage& stage) {
  const float half = size * w * (0.5F / static_cast<float>(std::fabs(axis.scale)));
  const auto snapped = [&](float corner) { return snapUnder(stage.rules, stage.samples, std::max(-w, std::min(corner, w)), w, axis); };
  const auto [low, high] = std::minmax({snapped(coordinate - half), snapped(coordinate + half)});
  const int64_t shift = ownsLow ? 0 : 1;
  return {low + shift, high + shift};
}

}  // namespace

float PointSize::drawn(PointArithmetic arithmetic) const {
  switch (arithmetic) {
    case PointArithmetic::SnappedCentre:
    case PointArithmetic::SnappedCentreEven:
    case PointArithmetic::ClipCorners: return requested;
    case PointArithmetic::Exact:
    case PointArithmetic::SnappedCorners: return nominal;
  }
  return nominal;
}

PointSize pointSize(float size, const Limits& limits) {
  PointSize result;
  result.requested = std::clamp(size, limits.pointSizeMin, limits.pointSizeMax);
  result.nominal = result.requested;
  if (limits.pointSizeGranularity > 0) {
    const float steps = std::nearbyint((result.requested - limits.pointSizeMin) / limits.pointSizeGranularity);
    result.nominal = std::min(limits.pointSizeMax, limits.pointSizeMin + steps * limits.pointSizeGranularity);
  }
  const float away = std::fabs(result.nominal - result.requested);
  result.smallest = result.requested - away;
  result.largest = result.requested + away;
  return result;
}

std::unique_ptr<Shape> makePointShape(const ClipPosition& position, const RasterVertex& vertex, FloatPosition centre,
                                      const PointSize& size, const VertexStage& stage) {
  // Half sides in 1/256 pixel, on the grid that ceilingExactly takes.
  const auto halfSide = [](float side) { return std::nearbyint(double{side} * 128 * 1024) / 1024; };
  const PointArithmetic arithmetic = stage.rules.choices.pointArithmetic;
  const float drawn = size.drawn(arithmetic);
  const double half = halfSide(drawn);
  const auto axis = [&](float coordinate, const ViewportAxis& viewportAxis, double place, float inFloat, int32_t snapped,
                        int32_t lowest, int32_t highest, bool ownsLow) {
    SquarePoint::Axis result;
    result.low = place * kSubpixelOne - half;
    result.high = place * kSubpixelOne + half;
    if (arithmetic == PointArithmetic::SnappedCentre || arithmetic == PointArithmetic::SnappedCentreEven) {
      result.nominal = aroundSnapped(inFloat, drawn, arithmetic == PointArithmetic::SnappedCentreEven, stage);
      result.low = static_cast<double>(result.nominal.low);
      result.high = static_cast<double>(result.nominal.high);
    } else if (arithmetic == PointArithmetic::SnappedCorners) {
      const auto side = static_cast<int64_t>(std::nearbyint(half));  // to either side of the snapped vertex
      const int64_t shift = ownsLow ? 0 : 1;
      result.low = static_cast<double>(snapped - side);
      result.high = static_cast<double>(snapped + side);
      result.nominal = {snapped - side + shift, snapped + side + shift};
    } else if (arithmetic == PointArithmetic::ClipCorners) {
      result.nominal = clipCorners(coordinate, position.w, viewportAxis, drawn, ownsLow, stage);
      result.low = static_cast<double>(result.nominal.low);
      result.high = static_cast<double>(result.nominal.high);
    } else if (stage.rules.error == DeliberateError::PointRounded) {
      result.nominal = {snapped - static_cast<int64_t>(half), snapped + static_cast<int64_t>(std::ceil(half))};
    } else {
      result.nominal = {ceilingExactly(coordinate, position.w, viewportAxis, -half),
                        ceilingExactly(coordinate, position.w, viewportAxis, half)};
    }
    const auto outward = static_cast<int64_t>(std::ceil(halfSide(size.largest)));
    const auto inward = static_cast<int64_t>(std::floor(halfSide(size.smallest)));
    result.possible = {lowest - outward, highest + outward + 1};
    result.certain = {highest - inward + 1, lowest + inward};
    return result;
  };
  const TieRule ties = tieRule(stage.rules.choices);
  return std::make_unique<SquarePoint>(
      axis(position.x, stage.viewport.x, vertex.position.x, centre.x, vertex.snapped.x, vertex.lowest.x, vertex.highest.x,
           ownsTies(ties, 0, -1)),
      axis(position.y, stage.viewport.y, vertex.position.y, centre.y, vertex.snapped.y, vertex.lowest.y, vertex.highest.y,
           ownsTies(ties, 1, 0)),
      size.isFree());
}

}  // namespace rasterdiff::rasterizer
