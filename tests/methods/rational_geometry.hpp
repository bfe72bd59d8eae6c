// Geometry in exact rationals, written without a look at the methods: what the methods' tests believe.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/diamond_exit.hpp"
#include "rasterizer/methods/polygon.hpp"

namespace rasterdiff::testing {

using Rational = boost::multiprecision::cpp_rational;

/// Winding number of the sample moved right by ε and down by ε² with ε = 2^-40, by a ray that runs down.
int rationalWinding(const Polygon& polygon, SubpixelPosition sample);

/// Twice the area of triangle ∩ pixel in 1/65536 pixel²: Sutherland-Hodgman clipping, then the shoelace formula.
Rational rationalDoubleArea(const rasterizer::SnappedTriangle& triangle, rasterizer::PixelIndex pixel);

/// Does the segment produce the pixel under the rule's own words: does it, with its ends moved by -(ε, ε²) for a
/// symbolic ε (Vulkan), meet the pixel's diamond, and is its end outside?
bool producesPixel(SubpixelPosition a, SubpixelPosition b, rasterizer::PixelIndex pixel, rasterizer::DiamondRule rule);

}  // namespace rasterdiff::testing
