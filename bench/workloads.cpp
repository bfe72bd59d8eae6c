// Generates the workloads; measuring them is left to whoever asks.
#include "bench/workloads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "scene/mesh/obj.hpp"

namespace rasterdiff::bench {
namespace {

using rasterizer::SnappedTriangle;

struct Point {
  double x = 0, y = 0;
};

/// Portable: std::uniform_real_distribution may differ between libraries.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

double cross(const Point* p) {
  return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
}

double longestSquared(const Point* p) {
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const Point a = p[i], b = p[(i + 1) % 3];
    longest = std::max(longest, (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  }
  return longest;
}

SnappedTriangle snapped(const Point* p) {
  SnappedTriangle t;
  for (size_t i = 0; i < 3; ++i)
    t.v[i] = {static_cast<int32_t>(std::lround(p[i].x * kSubpixelOne)), static_cast<int32_t>(std::lround(p[i].y * kSubpixelOne))};
  return t;
}

/// Moves the points by a random offset that keeps them inside; false if they do not fit.
bool place(Point* p, Random& random, double width, double height) {
  const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
  if (x1 - x0 > width || y1 - y0 > height) return false;
  const double dx = random(0, width - (x1 - x0)) - x0, dy = random(0, height - (y1 - y0)) - y0;
  for (int i = 0; i < 3; ++i) p[i].x += dx, p[i].y += dy;
  return true;
}

/// Clockwise on a y-down screen.
SnappedTriangle frontFacing(Point* p) {
  if (cross(p) < 0) std::swap(p[1], p[2]);
  return snapped(p);
}

constexpr size_t kMostTries = 200'000;  // in a row, for one triangle

tl::unexpected<Error> doesNotFit(const std::string& what, uint32_t width, uint32_t height) {
  return fail(ErrorCode::BadInput, "workload", fmt::format("{} do not fit into {} x {} pixels", what, width, height),
              "a larger target or smaller triangles");
}

}  // namespace

Result<Workload> randomTriangles(std::string name, size_t count, double area, uint32_t width, uint32_t height) {
  Workload load{std::move(name), fmt::format("random triangles of {} px", area), width, height, {}};
  Random random(0x5EED);
  const bool large = area * 16 > double{1} * width * height;
  load.triangles.reserve(count);
  for (size_t tries = 0; load.triangles.size() < count; ++tries) {
    if (tries == kMostTries) return doesNotFit(load.what, width, height);
    Point p[3];
    for (Point& v : p) v = large ? Point{random(0, width), random(0, height)} : Point{random(0, 1), random(0, 1)};
    const double was = std::abs(cross(p)) / 2;
    if (longestSquared(p) > 16 * was) continue;  // longest edge > 8 × height on it
    if (large && was < area) continue;
    const double scale = std::sqrt(area / was);
    const Point first = p[0];
    for (Point& v : p) v = {first.x + (v.x - first.x) * scale, first.y + (v.y - first.y) * scale};
    if (!large && !place(p, random, width, height)) continue;
    load.triangles.push_back(frontFacing(p));
    tries = 0;
  }
  return load;
}

Result<Workload> slivers(std::string name, size_t count, double length, double thickness, uint32_t width, uint32_t height) {
  Workload load{std::move(name), fmt::format("slivers of {} x {} px", length, thickness), width, height, {}};
  Random random(0x5EED);
  load.triangles.reserve(count);
  for (size_t tries = 0; load.triangles.size() < count; ++tries) {
    if (tries == kMostTries) return doesNotFit(load.what, width, height);
    const double angle = random(0, 2 * std::numbers::pi), apex = random(0, length);
    const double c = std::cos(angle), s = std::sin(angle);
    Point p[3] = {{0, 0}, {length * c, length * s}, {apex * c - thickness * s, apex * s + thickness * c}};
    if (!place(p, random, width, height)) continue;
    load.triangles.push_back(frontFacing(p));
    tries = 0;
  }
  return load;
}

Result<Workload> meshTriangles(std::string name, const std::string& objFile, double area, uint32_t width, uint32_t height) {
  const auto mesh = loadObj(objFile);
  if (!mesh) return tl::unexpected(mesh.error());
  Workload load{std::move(name), fmt::format("front faces of a mesh at {} px a triangle", area), width, height, {}};
  double sum = 0, front = 0;
  Point low{1e300, 1e300}, high{-1e300, -1e300};
  const auto corners = [&](size_t i, Point* p) {
    for (size_t k = 0; k < 3; ++k) {
      const auto& v = mesh->positions[mesh->indices[i + k]];
      p[k] = {v[0], -double{v[1]}};  // y down mirrors the mesh
    }
    std::swap(p[1], p[2]);
  };
  Point p[3];
  for (size_t i = 0; i + 3 <= mesh->indices.size(); i += 3) {
    corners(i, p);
    if (cross(p) <= 0) continue;
    sum += cross(p) / 2, front += 1;
    for (const Point& v : p) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
  }
  if (front == 0) return fail(ErrorCode::BadInput, objFile, "the mesh has no face towards the viewer");
  const double scale = std::sqrt(area * front / sum);
  const Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  for (size_t i = 0; i + 3 <= mesh->indices.size(); i += 3) {
    corners(i, p);
    bool inside = true;
    for (Point& v : p) {
      v = {(v.x - middle.x) * scale + width / 2.0, (v.y - middle.y) * scale + height / 2.0};
      inside = inside && v.x >= 0 && v.y >= 0 && v.x <= width && v.y <= height;
    }
    if (inside && cross(p) > 0) load.triangles.push_back(snapped(p));
  }
  return load;
}

std::span<const std::string_view> builtInNames() {
  static constexpr std::string_view kNames[] = {"W1", "W2", "W3", "W4a", "W4b", "W5"};
  return kNames;
}

Result<Workload> builtInWorkload(std::string_view name, const std::string& objFile, double scale, uint32_t width,
                                 uint32_t height) {
  const auto scaled = [&](double count) { return static_cast<size_t>(std::max(1.0, count * scale)); };
  const bool large = name == "W3" || name == "W5";  // what is drawn at random has to fit often enough
  const double pixels = double{1} * width * height, side = std::min(width, height);
  if (pixels < (large ? 1.9e6 : 6e4) || side < (large ? 1000 : 200)) {
    return fail(ErrorCode::BadInput, "workload", fmt::format("{} does not fit into {} x {} pixels", name, width, height),
                "1920x1080 or more for W3 and W5, 256x256 or more for the others");
  }
  if (name == "W1") return randomTriangles("W1", scaled(1e6), 10, width, height);
  if (name == "W2") return randomTriangles("W2", scaled(1e5), 1000, width, height);
  if (name == "W3") return randomTriangles("W3", scaled(1e3), 500000, width, height);
  if (name == "W4a") return meshTriangles("W4a", objFile, 1.6, width, height);
  if (name == "W4b") return meshTriangles("W4b", objFile, 30, width, height);
  if (name == "W5") return slivers("W5", scaled(1e5), 1000, 0.3, width, height);
  return fail(ErrorCode::BadInput, "workload", fmt::format("there is no workload '{}'", name),
              fmt::format("one of {}", fmt::join(builtInNames(), ", ")));
}

Result<std::vector<Workload>> builtInWorkloads(const std::string& objFile, double scale, uint32_t width, uint32_t height) {
  std::vector<Workload> all;
  for (const std::string_view name : builtInNames()) {
    auto load = builtInWorkload(name, objFile, scale, width, height);
    if (!load) return tl::unexpected(load.error());
    all.push_back(std::move(*load));
  }
  return all;
}

}  // namespace rasterdiff::bench
