// The triangles of a scene as the kernels take them: snapped, oriented, sorted into bands of rows. Whole triangles come straight from
// vectors of vertices (vertex_vectors.hpp); what is cut, or otherwise more than three corners, from geometry.hpp.
#pragma once

#include <array>
#include <vector>

#include "rasterizer/geometry.hpp"
#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/vertex_vectors.hpp"

namespace rasterdiff::rasterizer {

/// Rows of a frame that are drawn together: a power of two.
struct BandRows {
  uint32_t shift = 4;
  [[nodiscard]] uint32_t rows() const { return uint32_t{1} << shift; }
  [[nodiscard]] uint32_t bandsOf(uint32_t height) const { return (height + rows() - 1) >> shift; }
};

/// Which piece of its primitive a piece is.
struct PieceOrigin {
  uint8_t place = 0;
  bool cut = false, many = false;  ///< of a primitive that was cut; to more than three corners
};

/// One thread's part, in drawing order: triangles wound so that their double area is positive.
struct KernelPieces {
  std::vector<SnappedTriangle> positions;
  std::vector<uint32_t> primitives;               ///< 1-based over all draws
  std::vector<std::array<uint32_t, 3>> corners;   ///< of depth planes, for KernelGeometry::corner; scenes with depth only
  std::vector<PieceOrigin> origins;               ///< scenes with inputs only
  std::vector<DepthVertex> made;                  ///< of primitives that geometry.hpp made
  std::vector<std::vector<uint32_t>> bands;       ///< which pieces reach into each band
  bool folded = false;                            ///< pieces of one cut polygon overlap where values are open
};

class KernelGeometry {
 public:
  /// Makes all pieces on as many threads as there are counts, to which it adds what is decided before rasterization. The rules and
  /// the scene are those that KernelFrame serves, and must outlive this object.
  KernelGeometry(const Scene& scene, const Rules& rules, BandRows rows, std::span<RuleCounts> counts);

  /// A part for each thread; all in a row are drawing order.
  [[nodiscard]] const std::vector<KernelPieces>& parts() const { return parts_; }
  [[nodiscard]] bool folded() const;
  [[nodiscard]] const DepthVertex& corner(const KernelPieces& part, uint32_t number) const {
    return number >= kMade ? part.made[number - kMade] : vertices_.depths[number];
  }
  [[nodiscard]] bool isClipped(size_t draw) const { return draws_[draw].clipped; }
  struct Assembled {
    size_t draw = 0;
    AssembledTriangle triangle;
  };
  /// `number`: 1-based over all draws.
  [[nodiscard]] Assembled assembled(uint32_t number) const;

 private:
  class Maker;
  static constexpr uint32_t kMade = uint32_t{1} << 31;  // first number of a part's own vertices
  struct DrawPlace {
    uint32_t firstVertex = 0, firstPrimitive = 0, primitives = 0;  // vertices and primitives of earlier draws; of this one
    bool inVectors = false, clipped = false;
    std::vector<AssembledTriangle> assembled{};  // unless primitives are three vertices after the other
  };

  /// May whole triangles of the draw skip geometry.hpp?
  [[nodiscard]] bool servesInVectors(const Draw& draw, bool clipped) const;
  void stage(std::span<RuleCounts> counts);
  /// Primitive `i` of a draw.
  [[nodiscard]] AssembledTriangle assembled(const Draw& draw, const DrawPlace& place, size_t i) const;

  const Scene& scene_;
  const Rules& rules_;
  const BandRows rows_;
  StagedVertices vertices_;  // of all draws
  std::vector<DrawPlace> draws_;
  std::vector<KernelPieces> parts_;
};

}  // namespace rasterdiff::rasterizer
