// What the value kernels draw and where to: snapped triangles with what their vertices carry, and flat planes of which
// only the needed ones exist. Drawing is in value_kernel.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "scene/result.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::rasterizer {

inline constexpr uint32_t kMaxValueComponents = 16;

enum class ValueKind : uint8_t { Flat, Noperspective, Perspective };

/// Where a triangle's depth plane is laid, pixels: unlike the triangle, not on any grid.
struct DepthCorners {
  std::array<double, 3> x{}, y{}, z{};
};

/// For storage that starts at a cache line.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kLine)); }
  void deallocate(T* p, size_t) { ::operator delete(p, kLine); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

template <class T>
using ValueRows = std::vector<T, LineAllocator<T>>;

/// Floats that the vertices of a triangle carry: 1 / w of each (> 0; for perspective components), one that nobody reads, then
/// [vertex][component]. Side by side, so that they are fetched together: four components are a cache line.
inline constexpr size_t kBeforeValues = 4;
[[nodiscard]] constexpr size_t carriedSize(size_t components) { return kBeforeValues + 3 * components; }

/// The same of all triangles, from three 1 / w a triangle and [triangle][vertex][component]; starts at a cache line.
[[nodiscard]] ValueRows<float> carriedValues(std::span<const float> reciprocalW, std::span<const float> values, size_t components);

/// Triangles in drawing order. Empty spans where the target has no plane that needs them.
struct ValueTriangles {
  std::span<const SnappedTriangle> positions;
  std::span<const float> depth;        ///< three a triangle: at its vertices
  std::span<const float> carried;      ///< carriedSize a triangle; for components
  std::span<const ValueKind> kinds;    ///< one a component; flat ones take the value of vertex 0
  std::span<const DepthCorners> corners = {};  ///< one a triangle, instead of `depth`: drawBand only
};

/// Which planes a target has. Depth is tested by LESS and written.
struct ValueNeeds {
  bool primitive = false;   ///< 1 + place of the last triangle that passed; 0: none
  bool count = false;       ///< how many triangles passed
  bool depth = false;
  uint32_t components = 0;  ///< of varyings, evaluated at pixel centres; needs `primitive`
};

/// Planes of uint32 or float32, sample rows below one another: sample s of pixel (x, y) is element
/// (y · samples + s) · stride + x. Rows start at cache lines; at least kValuePadding elements behind `width` are scratch.
class ValueTarget {
 public:
  static constexpr size_t kValuePadding = 16;

  /// Cleared planes; `width`, `height` in pixels (1 to 16384), `samples` 1, 2, 4, 8 or 16 at the standard locations.
  /// Error: BadInput (another size, too many components, varyings without primitive), NotOffered (sample count).
  [[nodiscard]] static Result<ValueTarget> create(uint32_t width, uint32_t height, uint32_t samples, ValueNeeds needs);

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  [[nodiscard]] uint32_t samples() const { return static_cast<uint32_t>(locations_.size()); }
  [[nodiscard]] const ValueNeeds& needs() const { return needs_; }
  [[nodiscard]] std::span<const SampleLocation> locations() const { return locations_; }
  [[nodiscard]] size_t stride() const { return (size_t{width_} + kValuePadding + 15) / 16 * 16; }
  [[nodiscard]] size_t index(uint32_t x, uint32_t y, uint32_t s) const { return (size_t{y} * samples() + s) * stride() + x; }

  ValueRows<uint32_t> primitive, count;
  ValueRows<float> depth;                  ///< cleared to 1
  std::vector<ValueRows<float>> varyings;  ///< one plane a component; 0 where nothing was drawn

  void clear();
  /// Number of samples whose primitive, count or depth is not bit for bit that of a target of the same shape.
  [[nodiscard]] uint64_t differing(const ValueTarget& other) const;

 private:
  ValueTarget(uint32_t width, uint32_t height, std::span<const SampleLocation> locations, ValueNeeds needs);

  uint32_t width_ = 0, height_ = 0;
  std::span<const SampleLocation> locations_;
  ValueNeeds needs_;
};

}  // namespace rasterdiff::rasterizer
