// Mutants: each is the reference with exactly one mistake, used as the driver under test to measure the measure.
// A mistake sits in the stage it names and costs nothing when absent (stages look once a primitive, never a sample).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rasterdiff::rasterizer {

enum class DeliberateError : uint8_t {
  None,
  TieOwnerBottomRight,      ///< edge samples go to the bottom-right polygon
  TiesCoveredByBoth,        ///< every edge inclusive: shared edges drawn twice
  TiesCoveredByNone,        ///< every edge exclusive: seams
  TruncatingSnap,           ///< vertex coordinates rounded toward zero
  CoarseSnap,               ///< 4 subpixel bits where more are advertised
  SampleMoved,              ///< sample 0 lies 1/16 pixel to the right
  SwappedWinding,           ///< facing inverted
  MissingPerspective,       ///< smooth varyings interpolated linearly on the screen
  PerspectiveOnLinear,      ///< noperspective varyings interpolated with perspective
  WrongProvokingVertex,     ///< flat varyings from the other end of the primitive
  DepthOffByOneStep,        ///< depth one float32 step too far
  HalfPixelShift,           ///< vertices moved by half a pixel in x
  WrongNearPlane,           ///< near plane at z = -w where it is z = 0
  NoFarClip,                ///< far plane ignored
  ViewportFlipped,          ///< negative viewport height ignored
  ScissorOffByOne,          ///< scissor one pixel too wide
  DepthTestInverted,        ///< LESS and GREATER exchanged
  DepthWriteIgnored,        ///< depth write mask ignored
  ClipAttributeUnadjusted,  ///< varyings of clipped vertices copied from the nearer end
  StripParityIgnored,       ///< odd triangles of a strip keep their winding reversed
  FirstWins,                ///< overlapping primitives: the first stays
  IndexOffByOne,            ///< the last index of an indexed draw repeated
};

struct DeliberateErrorInfo {
  DeliberateError error;
  std::string_view name;  ///< as on the command line: `mutant:truncating-snap`
  std::string_view rule;  ///< id of RULES (R14 ...) that it breaks
  std::string_view what;
};

[[nodiscard]] std::span<const DeliberateErrorInfo> deliberateErrors();
[[nodiscard]] std::optional<DeliberateError> deliberateErrorByName(std::string_view name);

}  // namespace rasterdiff::rasterizer
