// One legal renderer's answers where the specification leaves something open that no profile closes: in which arithmetic
// values are evaluated, where in a fragment, how far a depth bias goes. What false alarms are looked for with.
#pragma once

#include <cstdint>

namespace rasterdiff::rasterizer {

struct Variation {
  /// How a value that is linear on the screen is evaluated, in float32.
  enum class Arithmetic : uint8_t {
    PlaneAtOrigin,  ///< a plane equation anchored at the framebuffer's origin
    PlaneAtVertex,  ///< a plane equation anchored at the first corner
    Barycentric,    ///< corners weighted by quotients of areas
  };
  Arithmetic arithmetic = Arithmetic::PlaneAtOrigin;
  bool snappedCorners = false;  ///< the planes go through the snapped corners
  bool uncutCorners = false;    ///< of cut polygons: through those of the uncut triangle, where all are in front of the eye
  bool reciprocal = false;      ///< perspective: times a float32 reciprocal, where others divide

  float attributeX = 0, attributeY = 0;  ///< undecorated inputs of several samples: pixels from the centre, -½ .. ½
  bool attributesAtSamples = false;      ///< ... at each sample instead
  enum class Centroid : uint8_t { CentreOrFirst, Last, Mean };
  Centroid centroid = Centroid::CentreOrFirst;
  enum class Offset : uint8_t { Unrounded, Down, Up };
  Offset offset = Offset::Unrounded;

  double biasSlope = 0;      ///< m from the larger component of the gradient (0) to its length (1)
  double biasUnit = 1;       ///< r of fixed-point formats: 1 to 2 steps
  bool biasesLines = false;  ///< lines and points are biased as well
  bool ditheredAlpha = false;        ///< which samples an alpha keeps depends on the pixel
  bool linesUncut = false;           ///< lines that leave the view volume are drawn whole
  bool bresenhamByDefault = false;   ///< without strictLines
  bool roundsViewport = false;       ///< viewport bounds to viewportSubPixelBits
  uint32_t gridBits = 0;             ///< of a grid that is finer than advertised; 0: the advertised one
};

}  // namespace rasterdiff::rasterizer
