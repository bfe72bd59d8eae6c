#include "rasterizer/lines/float_corners.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

// Half a unit is added in float32, away from zero, before the fraction is dropped.
int32_t roundAway(float value) {
  const float limit = static_cast<float>(1 << 28);
  const float clamped = std::clamp(value, -limit, limit);
  return static_cast<int32_t>(clamped >= 0 ? clamped + 0.5F : clamped - 0.5F);
}

int32_t snapAway(float pixels) { return roundAway(static_cast<float>(kSubpixelOne) * pixels); }

bool isPositive(float value) { return value >= 0; }

/// Distance from the centre of the pixel, in pixels: -½ ≤ d < ½ (½ after rounding).
float fromCentre(float coordinate) { return coordinate - std::floor(coordinate) - 0.5F; }

/// One end of a Bresenham line. Along and across are the major and the minor axis, mirrored for y-major lines, so that
/// one set of rules does for both.
struct End {
  float major = 0, minor = 0;   ///< coordinates, not mirrored
  float along = 0, across = 0;  ///< from the centre of its pixel, mirrored
};

struct Walk {
  bool xMajor = true;
  float along = 0, across = 0;  ///< start less end, mirrored
  float slope = 0;              ///< minor over major

  [[nodiscard]] float mirrored(float value) const { return xMajor ? value : -value; }

  /// Does the line, extended, cross the middle of the end's pixel inside of it?
  [[nodiscard]] bool crossesPixel(const End& end, bool edgeCounts) const {
    const float crossing = end.minor - std::floor(end.minor) + mirrored(end.along) * slope;
    return crossing < 1 && (edgeCounts ? crossing >= 0 : crossing > 0);
  }
  [[nodiscard]] bool drawsStart(const End& end) const {
    if (std::fabs(end.along) + std::fabs(end.across) < 0.5F) return true;
    if (isPositive(end.along) == isPositive(-along)) return false;
    if (isPositive(-end.across) != isPositive(across)) return true;
    return crossesPixel(end, false);
  }
  [[nodiscard]] bool drawsEnd(const End& end) const {
    if (std::fabs(end.along) + std::fabs(end.across) < 0.5F) return false;
    if (isPositive(end.along) != isPositive(-along)) return false;
    if (isPositive(-end.across) == isPositive(across)) return true;
    return crossesPixel(end, !xMajor);
  }
  // What the outline would do without help: its ends lie on one side of the centres or on the other.
  [[nodiscard]] bool outlineHasStart(const End& end) const { return isPositive(-end.along) != isPositive(along); }
  [[nodiscard]] bool outlineHasEnd(const End& end) const {
    return isPositive(end.along) == isPositive(-along) || end.along == 0;
  }
  /// Moves an end to the border of its pixel, along the line.
  void move(End& end) const {
    const auto shift = static_cast<float>(-static_cast<double>(end.along) + (along >= 0 ? 0.5 : -0.5));
    const float major = mirrored(shift);
    end.major += major;
    end.minor += major * slope;
  }
};

float screenLength(FloatPosition a, FloatPosition b, bool rectangular) {
  const float dx = std::fabs(b.x - a.x), dy = std::fabs(b.y - a.y);
  return rectangular ? std::sqrt(dx * dx + dy * dy) : std::max(dx, dy);
}

float between(float from, float to, float t) { return from + t * (to - from); }

}  // namespace

int32_t snapFrom(float origin, float pixels) { return snapAway(pixels - origin) + roundAway(origin * kSubpixelOne); }

std::optional<LineOutline> rectangularOutline(FloatPosition a, FloatPosition b, float width, float origin) {
  const float dx = a.x - b.x, dy = a.y - b.y;
  const float length2 = dx * dx + dy * dy;
  if (!(length2 > 0)) return std::nullopt;
  const float scale = width * 0.5F / std::sqrt(length2);
  const int32_t nx = snapAway(-dy * scale), ny = snapAway(dx * scale);
  const SubpixelPosition p{snapFrom(origin, a.x), snapFrom(origin, a.y)},
      q{snapFrom(origin, b.x), snapFrom(origin, b.y)};
  return LineOutline{{{p.x + nx, p.y + ny}, {q.x + nx, q.y + ny}, {q.x - nx, q.y - ny}, {p.x - nx, p.y - ny}}};
}

std::optional<LineOutline> bresenhamOutline(FloatPosition a, FloatPosition b, float width, float origin) {
  const float dx = a.x - b.x, dy = a.y - b.y;
  if (!(dx * dx + dy * dy > 0)) return std::nullopt;
  Walk walk;
  walk.xMajor = std::fabs(dx) >= std::fabs(dy);
  walk.along = walk.mirrored(walk.xMajor ? dx : dy);
  walk.across = walk.mirrored(walk.xMajor ? dy : dx);
  walk.slope = walk.xMajor ? dy / dx : dx / dy;
  const auto endOf = [&](FloatPosition p) {
    End end;
    end.major = walk.xMajor ? p.x : p.y;
    end.minor = walk.xMajor ? p.y : p.x;
    end.along = walk.mirrored(fromCentre(end.major));
    end.across = walk.mirrored(fromCentre(end.minor));
    return end;
  };
  End start = endOf(a), finish = endOf(b);
  const float minorDelta = walk.xMajor ? dy : dx;
  if (fromCentre(finish.minor) == -0.5F && minorDelta < 0) finish.across = walk.mirrored(0.5F);
  const bool moveStart = walk.outlineHasStart(start) != walk.drawsStart(start);
  const bool moveFinish = walk.outlineHasEnd(finish) != walk.drawsEnd(finish);
  if (moveStart) walk.move(start);
  if (moveFinish) walk.move(finish);

  const int32_t half = roundAway(std::max(1.0F, width)) * (kSubpixelOne / 2);
  // Along the mirrored major axis the higher end comes first.
  const End& first = walk.along < 0 ? finish : start;
  const End& second = walk.along < 0 ? start : finish;
  const auto corner = [&](const End& end, int32_t side) {
    const int32_t major = snapFrom(origin, end.major), minor = snapFrom(origin, end.minor) + side;
    return walk.xMajor ? SubpixelPosition{major, minor} : SubpixelPosition{minor, major};
  };
  return LineOutline{{corner(first, half), corner(second, half), corner(second, -half), corner(first, -half)}};
}

uint32_t dashSteps(FloatPosition a, FloatPosition b, bool rectangular) {
  const float length = std::ceil(screenLength(a, b, rectangular));
  return length < 0x1p31F ? static_cast<uint32_t>(length) : 0;  // 0 for infinities and NaN
}

std::vector<FloatSegment> dashes(FloatPosition a, FloatPosition b, const LineStipple& stipple, bool rectangular) {
  std::vector<FloatSegment> parts;
  const float length = screenLength(a, b, rectangular);
  const auto emit = [&](float from, float to) {
    FloatSegment part{a, b};
    if (from > 0) part.a = {between(a.x, b.x, from), between(a.y, b.y, from)};
    if (to < 1) part.b = {between(a.x, b.x, to), between(a.y, b.y, to)};
    parts.push_back(part);
  };
  bool drawing = false;
  float begin = 0;
  const uint32_t steps = dashSteps(a, b, rectangular);
  for (uint32_t i = 0; i < steps; ++i) {
    const bool draws = stipple.draws(stipple.start.s + i);
    if (draws == drawing) continue;
    if (drawing) {
      emit(begin / length, static_cast<float>(i) / length);
    } else {
      begin = static_cast<float>(i);
    }
    drawing = draws;
  }
  if (drawing && begin < length) emit(begin / length, 1);
  return parts;
}

}  // namespace rasterdiff::rasterizer
