// Meshes that cover the target without gap or overlap: every sample is drawn exactly once. [vk:primsrast-polygons-basic]
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "harness/hunt/places.hpp"
#include "harness/invariants/agreement.hpp"
#include "scene/camera/screen.hpp"

namespace rasterdiff::harness::invariants {
namespace {

constexpr double kMargin = 8;  // pixels by which the view volume is larger than the target

Agreement drawnOnce(std::span<const Frame> frames) {
  const Frame& frame = frames.front();
  return checkSamples(frame, [&](size_t i, uint32_t, uint32_t) {
    return frame.count.data[i] == 1 ? std::string() : fmt::format("drawn {} times", frame.count.data[i]);
  });
}

Scene emptyScene(Prng& random, const Limits& limits) {
  Scene scene;
  scene.target.width = 8 + random.below(41);
  scene.target.height = 8 + random.below(41);
  scene.target.samples = (limits.framebufferSampleCounts & 4) != 0 && random.chance(60) ? 4 : 1;
  scene.viewport = {-kMargin, -kMargin, static_cast<float>(scene.target.width + 2 * kMargin), static_cast<float>(scene.target.height + 2 * kMargin), 0, 1};
  return scene;
}

/// Points of a lattice over a rectangle, those inside moved at random, many of them onto samples.
class Lattice {
 public:
  /// `reach`: pixels beyond the target on all sides.
  Lattice(const Scene& scene, Prng& random, double reach) : scene_(scene), random_(random), columns_(3 + random.below(6)), rows_(3 + random.below(6)) {
    const double steps = hunt::Places::randomSteps(random);
    const double width = scene.target.width + 2 * reach, height = scene.target.height + 2 * reach;
    const double cellX = width / columns_, cellY = height / rows_;
    const bool perspective = random.chance(30);
    for (uint32_t row = 0; row <= rows_; ++row) {
      for (uint32_t column = 0; column <= columns_; ++column) {
        const bool inX = column > 0 && column < columns_, inY = row > 0 && row < rows_;
        const double x = -reach + cellX * column + (inX ? random.between(-0.3, 0.3) * cellX : 0);
        const double y = -reach + cellY * row + (inY ? random.between(-0.3, 0.3) * cellY : 0);
        const double w = perspective ? std::ldexp(1, random.between(-2, 2)) : 1;
        points_.push_back(clipFromPixels(scene.viewport, {inX ? snapped(x, steps) : x, inY ? snapped(y, steps) : y, 0.5, w}));
      }
    }
  }
  [[nodiscard]] uint32_t columns() const { return columns_; }
  [[nodiscard]] uint32_t rows() const { return rows_; }
  [[nodiscard]] const ClipPosition& at(uint32_t column, uint32_t row) const { return points_[row * (columns_ + 1) + column]; }

 private:
  double snapped(double v, double steps) {
    if (random_.chance(30)) return std::floor(v) + 0.5;  // a centre
    return steps == 0 ? v : std::round(v * steps) / steps;
  }

  const Scene& scene_;
  Prng& random_;
  uint32_t columns_, rows_;
  std::vector<ClipPosition> points_;
};

/// Both triangles of every cell, diagonals and directions at random.
std::vector<ClipPosition> triangles(const Lattice& lattice, Prng& random) {
  std::vector<ClipPosition> list;
  for (uint32_t row = 0; row < lattice.rows(); ++row) {
    for (uint32_t column = 0; column < lattice.columns(); ++column) {
      std::array<ClipPosition, 4> c{lattice.at(column, row), lattice.at(column + 1, row), lattice.at(column + 1, row + 1), lattice.at(column, row + 1)};
      const uint32_t turn = random.below(4);
      const auto corner = [&](uint32_t i) { return c[(i + turn) % 4]; };
      for (const std::array<uint32_t, 3>& t : {std::array<uint32_t, 3>{0, 1, 2}, std::array<uint32_t, 3>{0, 2, 3}}) {
        const bool reversed = random.chance(50);
        list.insert(list.end(), {corner(t[0]), corner(reversed ? t[2] : t[1]), corner(reversed ? t[1] : t[2])});
      }
    }
  }
  return list;
}

Case once(Scene scene) { return {{std::move(scene)}, drawnOnce}; }

Case list(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  scene.draws.emplace_back().positions = triangles(Lattice(scene, random, kMargin), random);
  return once(std::move(scene));
}

Case strip(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
  const Lattice lattice(scene, random, kMargin);
  for (uint32_t row = 0; row < lattice.rows(); ++row) {
    Draw& draw = scene.draws.emplace_back();
    for (uint32_t column = 0; column <= lattice.columns(); ++column) {
      draw.positions.push_back(lattice.at(column, row));
      draw.positions.push_back(lattice.at(column, row + 1));
    }
  }
  return once(std::move(scene));
}

/// Around a vertex inside the target, its rim along the border of the view volume.
Case fan(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  const Lattice lattice(scene, random, kMargin);
  Draw& draw = scene.draws.emplace_back();
  const double x = random.below(scene.target.width) + 0.5, y = random.below(scene.target.height) + 0.5;
  draw.positions.push_back(clipFromPixels(scene.viewport, {x, y, 0.5, 1}));
  for (uint32_t c = 0; c < lattice.columns(); ++c) draw.positions.push_back(lattice.at(c, 0));
  for (uint32_t r = 0; r < lattice.rows(); ++r) draw.positions.push_back(lattice.at(lattice.columns(), r));
  for (uint32_t c = lattice.columns(); c > 0; --c) draw.positions.push_back(lattice.at(c, lattice.rows()));
  for (uint32_t r = lattice.rows(); r > 0; --r) draw.positions.push_back(lattice.at(0, r));
  const ClipPosition first = draw.positions[1];
  draw.positions.push_back(first);
  return once(std::move(scene));
}

Case acrossDraws(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  const std::vector<ClipPosition> all = triangles(Lattice(scene, random, kMargin), random);
  for (size_t i = 0; i < all.size(); i += 3) scene.draws.emplace_back().positions = {all[i], all[i + 1], all[i + 2]};
  return once(std::move(scene));
}

/// The mesh leaves the view volume, whose sides are the target's.
Case throughClipPlanes(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  scene.viewport = {0, 0, static_cast<float>(scene.target.width), static_cast<float>(scene.target.height), 0, 1};
  scene.draws.emplace_back().positions = triangles(Lattice(scene, random, random.between(1.0, 200.0)), random);
  return once(std::move(scene));
}

/// A mesh with clip distances d, then again with -d. A vertex has the same distance in all of its triangles, so that they
/// are cut at the same points; none is 0, since what has no other distance would be in both.
Case complementary(Prng& random, const Limits& limits) {
  Scene scene = emptyScene(random, limits);
  Draw& draw = scene.draws.emplace_back();
  draw.positions = triangles(Lattice(scene, random, kMargin), random);
  draw.clipDistanceCount = 1;
  const bool coarse = random.chance(50);
  std::map<std::pair<float, float>, float> distances;
  for (const ClipPosition& p : draw.positions) {
    const auto [at, fresh] = distances.try_emplace({p.x / p.w, p.y / p.w}, 0.0F);
    if (fresh) at->second = static_cast<float>(coarse ? 2 * random.between(-2, 1) + 1 : random.between(-1.0, 1.0));
    draw.clipDistances.push_back(at->second);
  }
  Draw negated = draw;
  for (float& d : negated.clipDistances) d = -d;
  scene.draws.push_back(std::move(negated));
  return once(std::move(scene));
}

constexpr std::string_view kBasic = "vk:primsrast-polygons-basic";
constexpr std::array kInvariants{
    Invariant{"shared-edges-list", "R15", kBasic, "the triangles of a mesh own every sample exactly once", list},
    Invariant{"shared-edges-strip", "R15", kBasic, "strips side by side own every sample exactly once", strip},
    Invariant{"shared-edges-fan", "R15", kBasic, "a closed fan around a vertex on a centre owns every sample exactly once", fan},
    Invariant{"shared-edges-across-draws", "R15", kBasic, "a mesh of one draw a triangle owns every sample exactly once", acrossDraws},
    Invariant{"shared-edges-clipped", "R15", kBasic, "a mesh that leaves the view volume owns every sample inside exactly once", throughClipPlanes},
    Invariant{"complementary-clip-distances", "R6", "vk:vertexpostproc-clipping", "clip distances d and -d share out every sample", complementary},
};

}  // namespace

std::span<const Invariant> ownershipInvariants() { return kInvariants; }

}  // namespace rasterdiff::harness::invariants
