// The built-in workloads of the speed measurements: fixed seed, vertices on the 1/256 grid, fully on screen.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "scene/result.hpp"

namespace rasterdiff::bench {

struct Workload {
  std::string name;     ///< "W1" … "W5"; W4 is "W4a" (about 1.6 pixels a triangle) and "W4b" (about 30)
  std::string what;     ///< for people, what the triangles are: "random triangles of 10 px"
  uint32_t width = 1920, height = 1080;
  std::vector<rasterizer::SnappedTriangle> triangles;  ///< clockwise on a y-down screen
};

/// `count` triangles of `area` pixels each, no more than 8 times as long as high, in a width × height target.
/// Where they are large, their vertices are anywhere in the target, and they are shrunk to `area`. Error: BadInput where
/// none is found that fits.
[[nodiscard]] Result<Workload> randomTriangles(std::string name, size_t count, double area, uint32_t width = 1920,
                                       uint32_t height = 1080);

/// `count` triangles of `length` × `thickness` pixels (base × height), in any direction. Error: as randomTriangles.
[[nodiscard]] Result<Workload> slivers(std::string name, size_t count, double length, double thickness, uint32_t width = 1920,
                               uint32_t height = 1080);

/// The front faces of an OBJ mesh seen from the front, orthographic, scaled until a triangle covers `area` pixels on
/// average or the mesh fills the target; what is off the target then is left out. Error: those of loading a mesh.
[[nodiscard]] Result<Workload> meshTriangles(std::string name, const std::string& objFile, double area,
                                             uint32_t width = 1920, uint32_t height = 1080);

/// "W1", "W2", "W3", "W4a", "W4b", "W5".
[[nodiscard]] std::span<const std::string_view> builtInNames();

/// A built-in workload by name; `objFile` is the mesh of W4, `scale` multiplies the other counts. Error: BadInput for an
/// unknown name or a target that is too small; those of meshTriangles.
[[nodiscard]] Result<Workload> builtInWorkload(std::string_view name, const std::string& objFile, double scale = 1,
                                               uint32_t width = 1920, uint32_t height = 1080);

/// All of them, in order.
[[nodiscard]] Result<std::vector<Workload>> builtInWorkloads(const std::string& objFile, double scale = 1,
                                                             uint32_t width = 1920, uint32_t height = 1080);

}  // namespace rasterdiff::bench
