// Three-valued coverage of one primitive: which samples every legal placement of its vertices covers, which none does,
// and which are free, with the freedom's name.
#pragma once

#include <optional>
#include <vector>

#include "rasterizer/geometry.hpp"
#include "rasterizer/row_span.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

struct BandVerdict {
  Coverage coverage = Coverage::Out;
  Freedom freedom = Freedom::None;  ///< why Either
  /// Ends of the one edge on which the sample lies exactly, in the polygon's positive orientation, where nothing else is
  /// free: the polygon on the other side has it reversed, and exactly one of the two owns the sample.
  std::optional<std::array<SubpixelPosition, 2>> tieEdge;
};

class FreedomBand {
 public:
  FreedomBand(const Primitive& primitive, CullMode cullMode, FrontFace frontFace);

  /// Pixel rows and columns outside which every sample is Out.
  [[nodiscard]] int32_t firstRow() const { return firstRow_; }
  [[nodiscard]] int32_t lastRow() const { return lastRow_; }

  /// Pixels of a row that may be covered (the rest is Out), and of those the ones that must be (In); the pixels between
  /// need classify(). Both are conservative.
  struct Row {
    RowSpan possible, certain;
  };
  [[nodiscard]] Row row(int64_t sampleX, int64_t sampleY, RowSpan limits) const;

  /// One sample, by the extreme values of each edge function over the boxes of its two ends (an edge function is affine
  /// in each coordinate, so its extremes are at corners). Exact for In; Out may be missed by this test alone.
  [[nodiscard]] BandVerdict classify(int64_t px, int64_t py) const;

  /// Like classify, and for triangles that were not cut, with boxes of at most 3 × 3 grid points, also exact for Out: tries
  /// all their placements.
  [[nodiscard]] BandVerdict classifyExactly(int64_t px, int64_t py) const;

  /// Extreme values over the boxes of the edge function of outer edge i (1/65536 pixel²).
  struct Extremes {
    int64_t lowest = 0, highest = 0;
  };
  [[nodiscard]] Extremes extremes(size_t edge, int64_t px, int64_t py) const;
  [[nodiscard]] size_t edgeCount() const { return edges_.size(); }

 private:
  struct Corner {
    SubpixelPosition nominal, lowest, highest;
    bool made = false;
  };
  struct Edge {
    Corner a, b;
    EdgeFunction inner, outer;  ///< nominal; the band is inner.at > margin ... outer.at >= -margin
    int64_t margin = 0;
  };
  [[nodiscard]] bool placementCovers(unsigned placement, int64_t px, int64_t py) const;

  std::vector<Edge> edges_;
  bool drawn_ = true;               ///< false: culled whatever the placement
  bool orientationCertain_ = true;
  bool triangle_ = true;
  CullMode cullMode_;
  FrontFace frontFace_;
  int32_t firstRow_ = 0, lastRow_ = -1;
  int32_t firstColumn_ = 0, lastColumn_ = -1;
};

}  // namespace rasterdiff::rasterizer
