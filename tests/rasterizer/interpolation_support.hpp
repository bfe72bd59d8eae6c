// One random triangle at a time for the interpolation tests: its scene, its planes, and its exact values in rationals,
// from homogeneous coordinates alone (Olano and Greer 1997), which shares nothing with the reference's planes.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "rasterizer/geometry.hpp"
#include "rasterizer/interpolation.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::rasterizer {

using Rational = boost::multiprecision::cpp_rational;

inline constexpr uint32_t kExtent = 256;

struct TriangleKind {
  bool perspective = false;
  double size = 60;      ///< pixels
  double thinness = 0;   ///< pixels the third vertex is off the others' line; 0 = anywhere
  double largest = 8;    ///< of the values
};

/// Three vertices well inside of a 256 × 256 target, depth, and one varying of one component in each interpolation.
inline Scene randomTriangleScene(std::mt19937_64& random, const TriangleKind& kind, uint32_t samples = 1) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Scene scene;
  scene.name = "triangle";
  scene.target.width = scene.target.height = kExtent;
  scene.target.samples = samples;
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.viewport = {0, 0, kExtent, kExtent, 0, 1};
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  const double cx = 128 + 60 * unit(random), cy = 128 + 60 * unit(random);
  double x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = std::clamp(cx + kind.size * unit(random), 4.0, kExtent - 4.0);
    y[i] = std::clamp(cy + kind.size * unit(random), 4.0, kExtent - 4.0);
  }
  if (kind.thinness > 0) {
    const double t = (1 + unit(random)) / 2;
    x[2] = x[0] + t * (x[1] - x[0]) + kind.thinness * unit(random);
    y[2] = y[0] + t * (y[1] - y[0]) + kind.thinness * unit(random);
  }
  Draw draw;
  for (int i = 0; i < 3; ++i) {
    const double w = kind.perspective ? std::exp2(3 * unit(random)) : 1;
    draw.positions.push_back({static_cast<float>((x[i] / 128 - 1) * w), static_cast<float>((y[i] / 128 - 1) * w),
                              static_cast<float>((0.5 + 0.4 * unit(random)) * w), static_cast<float>(w)});
  }
  for (const auto& [name, interpolation] : {std::pair{"smooth", Interpolation::smooth},
                                            std::pair{"screen", Interpolation::noperspective},
                                            std::pair{"flat", Interpolation::flat}}) {
    Varying varying{name, interpolation, 1, {}};
    for (int i = 0; i < 3; ++i) varying.values.push_back(static_cast<float>(kind.largest * unit(random)));
    draw.varyings.push_back(varying);
  }
  scene.draws.push_back(draw);
  return scene;
}

/// Calls `visit` for the one piece of the scene's triangle, where snapping leaves it an area.
inline void withPiece(const Scene& scene, const Rules& rules,
                      const std::function<void(const Primitive&, const SetupTriangle&, const PieceValues&)>& visit) {
  RuleCounts counts;
  PieceValues values(scene, needsOf(scene), rules);
  forEachPrimitive(scene, rules, counts, [&](const Primitive& primitive) {
    for (const SetupTriangle& piece : primitive.pieces) {
      values.setUp(primitive, piece);
      visit(primitive, piece, values);
    }
  });
}

struct ExactValues {
  Rational depth, smooth, screen;
};

/// At the point (x, y) in pixels: b solves Σ bᵢ (xᵢ, yᵢ, wᵢ) = (X, Y, 1) in normalized device coordinates.
inline ExactValues exactValues(const Scene& scene, double px, double py) {
  const Draw& draw = scene.draws[0];
  Rational m[3][3], value[3], screen[3], z[3];
  for (int i = 0; i < 3; ++i) {
    const ClipPosition& p = draw.positions[static_cast<size_t>(i)];
    m[i][0] = Rational(p.x);
    m[i][1] = Rational(p.y);
    m[i][2] = Rational(p.w);
    z[i] = Rational(p.z);
    value[i] = Rational(draw.varyings[0].values[static_cast<size_t>(i)]);
    screen[i] = Rational(draw.varyings[1].values[static_cast<size_t>(i)]);
  }
  const Rational half(scene.target.width / 2);
  const Rational target[3] = {Rational(px) / half - 1, Rational(py) / half - 1, 1};
  Rational smooth = 0, smoothWeight = 0, linear = 0, depth = 0, linearWeight = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& a = m[(i + 1) % 3];
    const auto& b = m[(i + 2) % 3];
    // Cramer's rule without the common determinant: it cancels in both quotients.
    const Rational weight = target[0] * (a[1] * b[2] - a[2] * b[1]) + target[1] * (a[2] * b[0] - a[0] * b[2]) +
                            target[2] * (a[0] * b[1] - a[1] * b[0]);
    smooth += weight * value[i];
    smoothWeight += weight;
    const Rational onScreen = weight * m[i][2];
    linear += onScreen * screen[i];
    depth += onScreen * z[i] / m[i][2];
    linearWeight += onScreen;
  }
  return {depth / linearWeight, smooth / smoothWeight, linear / linearWeight};
}

/// A random point inside the piece's snapped triangle, pixels.
inline std::array<double, 2> pointInside(std::mt19937_64& random, const Primitive& primitive, const SetupTriangle& piece) {
  std::uniform_real_distribution<double> unit(0, 1);
  double u = unit(random), v = unit(random);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const auto at = [&](size_t k) { return primitive.polygon[piece.corner[k]].snapped; };
  return {(at(0).x + u * (at(1).x - at(0).x) + v * (at(2).x - at(0).x)) / kSubpixelOne,
          (at(0).y + u * (at(1).y - at(0).y) + v * (at(2).y - at(0).y)) / kSubpixelOne};
}

}  // namespace rasterdiff::rasterizer
