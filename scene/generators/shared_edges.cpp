#include "scene/generators/shared_edges.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff {
namespace {

class Source {
 public:
  explicit Source(const SharedEdges& options) : options_(options), random_(options.seed) {}

  /// A sample (three times in four) or a point of the grid, near (x, y).
  PixelPosition near(double x, double y) {
    const std::span<const SampleLocation> samples = standardSampleLocations(options_.samples);
    if (samples.empty() || random_.chance(25)) {
      const double jx = random_.between(-0.5, 0.5), jy = random_.between(-0.5, 0.5);
      return {snapToGrid(x + jx, options_.grid), snapToGrid(y + jy, options_.grid), 0, 1};
    }
    const SampleLocation s = samples[random_.below(samples.size())];
    return {snapToGrid(std::floor(x) + s.x / 16.0, options_.grid),
            snapToGrid(std::floor(y) + s.y / 16.0, options_.grid), 0, 1};
  }

  Prng& random() { return random_; }

 private:
  SharedEdges options_;
  Prng random_;
};

class Mesh {
 public:
  explicit Mesh(const Viewport& viewport) : viewport_(viewport) {}
  void add(const PixelPosition& p) { draw.positions.push_back(clipFromPixels(viewport_, p)); }
  Draw draw;

 private:
  Viewport viewport_;
};

/// The rim follows the square's border: corners need no sine, and some edges are horizontal, vertical or diagonal.
void fan(Mesh& mesh, Source& source, double extent, uint32_t rim) {
  const double half = extent / 2, radius = extent * 3 / 8;
  mesh.add(source.near(half, half));
  for (uint32_t i = 0; i <= rim; ++i) {
    if (i == rim) {
      mesh.draw.positions.push_back(mesh.draw.positions[1]);
      break;
    }
    const double t = 4.0 * i / rim, side = t - std::floor(t);  // 0..4 once around
    constexpr std::array<std::array<double, 4>, 4> kSides{
        {{-1, -1, 1, 0}, {1, -1, 0, 1}, {1, 1, -1, 0}, {-1, 1, 0, -1}}};
    const std::array<double, 4>& s = kSides[std::min(static_cast<size_t>(t), size_t{3})];
    mesh.add(source.near(half + radius * (s[0] + 2 * side * s[2]), half + radius * (s[1] + 2 * side * s[3])));
  }
}

void strip(Mesh& mesh, Source& source, double extent, uint32_t triangles) {
  const double margin = extent / 8, width = extent - 2 * margin;
  for (uint32_t i = 0; i < triangles + 2; ++i) {
    const double x = margin + width * (i / 2) / (triangles / 2 + 1);
    mesh.add(source.near(x, i % 2 == 0 ? margin : extent - margin));
  }
}

void lattice(Mesh& mesh, Source& source, double extent, uint32_t cells) {
  const double margin = extent / 16, step = (extent - 2 * margin) / cells;
  for (uint32_t y = 0; y <= cells; ++y) {
    for (uint32_t x = 0; x <= cells; ++x) mesh.add(source.near(margin + step * x, margin + step * y));
  }
  std::vector<uint32_t>& indices = mesh.draw.indices.emplace();
  for (uint32_t y = 0; y < cells; ++y) {
    for (uint32_t x = 0; x < cells; ++x) {
      const uint32_t a = y * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
      const bool falling = source.random().chance(50);
      for (uint32_t i : falling ? std::array{a, b, d, a, d, c} : std::array{a, b, c, b, d, c}) indices.push_back(i);
    }
  }
}

}  // namespace

Scene sharedEdges(const SharedEdges& options) {
  const uint32_t extent = std::bit_floor(std::clamp(options.extent, 16u, kMaxTargetExtent));
  const uint32_t pieces = std::clamp(options.pieces, 3u, 256u);
  Scene scene;
  scene.name = "shared-edges";
  scene.target.width = scene.target.height = extent;
  scene.target.samples = options.samples;
  scene.viewport.width = scene.viewport.height = static_cast<float>(extent);
  Source source(options);
  Mesh mesh(scene.viewport);
  switch (options.mesh) {
    case SharedMesh::Fan:
      scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
      fan(mesh, source, extent, pieces);
      break;
    case SharedMesh::Strip:
      scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
      strip(mesh, source, extent, pieces);
      break;
    case SharedMesh::Grid:
      lattice(mesh, source, extent, pieces);
      break;
  }
  scene.draws.push_back(std::move(mesh.draw));
  return scene;
}

}  // namespace rasterdiff
