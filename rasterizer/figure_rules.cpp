#include "rasterizer/figure_rules.hpp"

#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

bool isWhole(float size) { return size == std::floor(size); }

}  // namespace

FigureRules::FigureRules(const Scene& scene, const Rules& rules, const Primitive& primitive, const Figure& figure) {
  const State& state = scene.state;
  const Limits& limits = rules.limits;
  if (figure.kind == Figure::Kind::Point) {
    const bool without = primitive.draw->pointSizes.empty() && state.pointSize == State{}.pointSize;
    add(Rule::PointSquare);
    // [vk:primsrast-points] without a size, a point is one pixel wide.
    if (without) add(Rule::DefaultPointSize);
    if (!isWhole(figure.size) || figure.size == limits.pointSizeMax) add(Rule::SizeGranularity);
    return;
  }
  const bool bresenham = state.lineRasterizationMode == LineRasterizationMode::BRESENHAM;
  const bool smooth = state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  add(bresenham ? Rule::LineBresenham : smooth ? Rule::SmoothLine : Rule::LineRectangle);
  if (state.lineRasterizationMode == LineRasterizationMode::DEFAULT) add(Rule::DefaultLine);
  if (bresenham && figure.size > 1) add(Rule::WideBresenham);
  if (bresenham && scene.target.samples > 1) add(Rule::BresenhamSamples);
  if (!isWhole(figure.size) || figure.size > limits.lineWidthMax) add(Rule::SizeGranularity);
}

}  // namespace rasterdiff::rasterizer
