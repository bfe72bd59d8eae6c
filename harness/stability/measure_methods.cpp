#include <algorithm>
#include <cmath>

#include "harness/stability/exact_value.hpp"
#include "harness/stability/measure.hpp"
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "rasterizer/methods/interpolation_methods.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness::stability {
namespace {

using rasterizer::InterpolatedTriangle;
using rasterizer::Primitive;
using rasterizer::RasterVertex;
using rasterizer::SetupTriangle;

constexpr int64_t kPointsOfAPiece = 4096;         // enough to find the worst of a smooth error
constexpr int32_t kMethodLimit = (1 << 23) - 1;   // 1/256 pixel, of the interpolation methods

struct Piece {
  uint32_t primitive = 0;
  rasterizer::SnappedTriangle snapped;
  InterpolatedTriangle methods;
  ExactTriangle exact;
  bool usable = false;  ///< by the interpolation methods
};

double cornerValue(const Scene& scene, const Primitive& primitive, const RasterVertex& vertex, bool depth) {
  if (depth) return vertex.position.z;
  double value = 0;
  for (size_t k = 0; k < 3; ++k) {
    value += vertex.smoothWeights[k] * double{scene.draws[0].varyings[0].values[primitive.assembled.vertices[k]]};
  }
  return value;
}

Piece pieceOf(const Scene& scene, const Primitive& primitive, const SetupTriangle& setup, bool depth) {
  Piece piece;
  piece.primitive = primitive.number;
  piece.usable = true;
  for (size_t i = 0; i < 3; ++i) {
    const RasterVertex& vertex = primitive.polygon[setup.corner[i]];
    const double value = cornerValue(scene, primitive, vertex, depth);
    piece.snapped.v[i] = piece.methods.position[i] = vertex.snapped;
    piece.methods.w[i] = static_cast<float>(1 / vertex.reciprocalW);
    piece.methods.value[i] = static_cast<float>(value);
    piece.exact.x[i] = static_cast<long double>(vertex.position.x);
    piece.exact.y[i] = static_cast<long double>(vertex.position.y);
    piece.exact.reciprocalW[i] = static_cast<long double>(vertex.reciprocalW);
    piece.exact.value[i] = static_cast<long double>(value);
    piece.usable = piece.usable && std::abs(vertex.snapped.x) <= kMethodLimit && std::abs(vertex.snapped.y) <= kMethodLimit;
  }
  return piece;
}

std::vector<Piece> piecesOf(const Scene& scene, const rasterizer::Rules& rules) {
  std::vector<Piece> pieces;
  rasterizer::RuleCounts ignored;
  const bool depth = scene.target.depthFormat.has_value();
  rasterizer::forEachPrimitive(scene, rules, ignored, [&](const Primitive& primitive) {
    for (const SetupTriangle& setup : primitive.pieces) {
      if (!setup.culled) pieces.push_back(pieceOf(scene, primitive, setup, depth));
    }
  });
  return pieces;
}

/// Visits covered pixel centres of a piece, evenly thinned out.
template <class Visit>
void eachPoint(const Piece& piece, const Target& target, const Visit& visit) {
  const auto range = [&](auto coordinate, uint32_t extent) {
    const auto [low, high] = std::minmax({coordinate(piece.snapped.v[0]), coordinate(piece.snapped.v[1]), coordinate(piece.snapped.v[2])});
    return std::pair{std::max(0, low >> kSubpixelBits), std::min(static_cast<int32_t>(extent) - 1, high >> kSubpixelBits)};
  };
  const auto [left, right] = range([](const SubpixelPosition& p) { return p.x; }, target.width);
  const auto [top, bottom] = range([](const SubpixelPosition& p) { return p.y; }, target.height);
  const int64_t pixels = std::max<int64_t>(0, int64_t{right} - left + 1) * std::max<int64_t>(0, int64_t{bottom} - top + 1);
  const auto step = static_cast<int32_t>(std::max<int64_t>(1, pixels / kPointsOfAPiece));
  for (int32_t y = top; y <= bottom; ++y) {
    for (int32_t x = left + y % step; x <= right; x += step) {
      const SubpixelPosition centre{x * kSubpixelOne + kSubpixelOne / 2, y * kSubpixelOne + kSubpixelOne / 2};
      if (rasterizer::covers(piece.snapped, centre)) visit(x, y, centre);
    }
  }
}

void addValue(Point& point, long double exact, float value) {
  ++point.cases;
  if (!std::isfinite(value)) {
    ++point.notFinite;
    return;
  }
  point.maxUlp = std::max(point.maxUlp, rasterizer::ulpsFrom(exact, value));
}

Point coverageOf(const rasterizer::CoverageMethod& method, const Scene& scene,
                 const std::vector<rasterizer::SnappedTriangle>& triangles, const rasterizer::CoverageMask& exact) {
  Point point;
  point.cases = exact.count();
  auto mask = rasterizer::CoverageMask::create(scene.target.width, scene.target.height, 1);
  if (!mask) return point;
  method.draw(triangles, *mask);
  point.wrong = mask->differing(exact);
  return point;
}

/// What the reference renders, against extended precision on its own corners.
Point referenceValues(const Scene& scene, const std::vector<Piece>& pieces, const rasterizer::Rules& rules) {
  Point point;
  const Result<Frame> frame = rasterizer::render(scene, rules);
  if (!frame) return point;
  const bool depth = frame->depth.has_value();
  for (const Piece& piece : pieces) {
    eachPoint(piece, scene.target, [&](int32_t x, int32_t y, SubpixelPosition) {
      const auto column = static_cast<uint32_t>(x), row = static_cast<uint32_t>(y);
      if (frame->primitive.at(column, row, 0) != piece.primitive) return;
      const float value = depth ? frame->depth->at(column, row, 0) : frame->varyings[0].values.at(column, row, 0);
      addValue(point, piece.exact.at(x + 0.5L, y + 0.5L, !depth), value);
    });
  }
  return point;
}

Point methodValues(const Scene& scene, const std::vector<Piece>& pieces, const rasterizer::InterpolationMethod& method) {
  Point point;
  for (const Piece& piece : pieces) {
    if (!piece.usable) continue;
    eachPoint(piece, scene.target, [&](int32_t, int32_t, SubpixelPosition centre) {
      addValue(point, rasterizer::interpolateExactly(piece.methods, centre, method.perspective), method.at(piece.methods, centre));
    });
  }
  return point;
}

}  // namespace

std::vector<Series> measureMethods(const Family& family) {
  const rasterizer::Rules rules = *rasterizer::Rules::profile("reference", Limits{});
  std::vector<Series> coverage, values{{family.name, "reference", true}};
  for (const rasterizer::CoverageMethod& method : rasterizer::coverageMethods()) coverage.push_back({family.name, method.name});
  for (const rasterizer::InterpolationMethod& method : rasterizer::interpolationMethods()) {
    values.push_back({family.name, std::string(method.name), true});
  }
  const auto add = [](Series& series, double dial, Point point) {
    point.dial = dial;
    series.points.push_back(point);
  };
  for (const double dial : family.values) {
    const Scene scene = family.make(dial);
    const std::vector<Piece> pieces = piecesOf(scene, rules);
    std::vector<rasterizer::SnappedTriangle> triangles;
    for (const Piece& piece : pieces) triangles.push_back(piece.snapped);
    auto exact = rasterizer::CoverageMask::create(scene.target.width, scene.target.height, 1);
    if (!exact) continue;
    rasterizer::drawCoverageOracle(triangles, *exact);
    for (size_t m = 0; m < coverage.size(); ++m) {
      add(coverage[m], dial, coverageOf(rasterizer::coverageMethods()[m], scene, triangles, *exact));
    }
    add(values[0], dial, referenceValues(scene, pieces, rules));
    for (size_t m = 1; m < values.size(); ++m) {
      add(values[m], dial, methodValues(scene, pieces, rasterizer::interpolationMethods()[m - 1]));
    }
  }
  coverage.insert(coverage.end(), values.begin(), values.end());
  return coverage;
}

}  // namespace rasterdiff::harness::stability
