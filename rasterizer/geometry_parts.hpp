// The geometry of a scene in parts: by several threads, each of which has a part of the primitives, all parts in a row being drawing
// order; or primitive by primitive.
#pragma once

#include <memory>
#include <span>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// forEachPrimitive on as many threads as there are visitors: visitor k sees the k-th part of all primitives, in drawing order, and
/// its decisions go to counts[k]. There are as many counts as visitors, at least one.
void forEachPrimitive(const Scene& scene, const Rules& rules, std::span<RuleCounts> counts, std::span<const PrimitiveVisitor> visitors);

/// Makes single primitives of a draw, each as forEachPrimitive does, where most of the draw is made in another way.
class PrimitiveMaker {
 public:
  /// `someClipped`: does some vertex of the draw lie outside of what clips it? All that is given must outlive this object; rules
  /// have no deliberate error.
  PrimitiveMaker(const Scene& scene, const Rules& rules, const Draw& draw, bool someClipped, RuleCounts& counts, PrimitiveVisitor visit);
  ~PrimitiveMaker();
  PrimitiveMaker(const PrimitiveMaker&) = delete;
  PrimitiveMaker& operator=(const PrimitiveMaker&) = delete;

  /// Visits the primitive unless nothing is left of it; `number`: 1-based over all draws.
  void make(uint32_t number, const AssembledTriangle& assembled);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rasterdiff::rasterizer
