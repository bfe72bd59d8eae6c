#include "rasterizer/deliberate_error.hpp"

#include <array>

namespace rasterdiff::rasterizer {
namespace {

using enum DeliberateError;

constexpr std::array kErrors{
    DeliberateErrorInfo{TieOwnerBottomRight, "tie-owner-bottom-right", "R15", "edge samples go to the bottom-right polygon"},
    DeliberateErrorInfo{TiesCoveredByBoth, "ties-covered-by-both", "R15", "every edge owns its samples: shared edges are drawn twice"},
    DeliberateErrorInfo{TiesCoveredByNone, "ties-covered-by-none", "R15", "no edge owns its samples: shared edges have seams"},
    DeliberateErrorInfo{TruncatingSnap, "truncating-snap", "R14", "vertex coordinates are rounded toward zero"},
    DeliberateErrorInfo{CoarseSnap, "coarse-snap", "R14", "4 subpixel bits where the device advertises more"},
    DeliberateErrorInfo{SampleMoved, "sample-moved", "R17", "sample 0 lies 1/16 pixel too far right"},
    DeliberateErrorInfo{SwappedWinding, "swapped-winding", "R12", "front and back facing exchanged"},
    DeliberateErrorInfo{MissingPerspective, "missing-perspective", "R21", "smooth varyings interpolated linearly on the screen"},
    DeliberateErrorInfo{PerspectiveOnLinear, "perspective-on-linear", "R21", "noperspective varyings interpolated with perspective"},
    DeliberateErrorInfo{WrongProvokingVertex, "wrong-provoking-vertex", "R11", "flat varyings taken from the other end of the primitive"},
    DeliberateErrorInfo{DepthOffByOneStep, "depth-off-by-one-step", "R22", "stored depth moved out of the legal interval by one float32 step"},
    DeliberateErrorInfo{HalfPixelShift, "half-pixel-shift", "R2", "vertices moved by half a pixel in x"},
    DeliberateErrorInfo{WrongNearPlane, "wrong-near-plane", "R3", "near plane at z = -w where it is z = 0, or the other way round"},
    DeliberateErrorInfo{NoFarClip, "no-far-clip", "R3", "far plane ignored"},
    DeliberateErrorInfo{ViewportFlipped, "viewport-flipped", "R2", "sign of the viewport's height ignored"},
    DeliberateErrorInfo{ScissorOffByOne, "scissor-off-by-one", "R39", "scissor one pixel too wide"},
    DeliberateErrorInfo{DepthTestInverted, "depth-test-inverted", "R38", "LESS and GREATER exchanged"},
    DeliberateErrorInfo{DepthWriteIgnored, "depth-write-ignored", "R38", "depth is never written"},
    DeliberateErrorInfo{ClipAttributeUnadjusted, "clip-attribute-unadjusted", "R9", "varyings of clipped vertices copied from the inner end"},
    DeliberateErrorInfo{StripParityIgnored, "strip-parity-ignored", "R11", "odd triangles of a strip keep their winding reversed"},
    DeliberateErrorInfo{FirstWins, "first-wins", "R50", "of overlapping primitives the first one stays"},
    DeliberateErrorInfo{IndexOffByOne, "index-off-by-one", "R11", "the last index of an indexed draw is the one before it"},
};

}  // namespace

std::span<const DeliberateErrorInfo> deliberateErrors() { return kErrors; }

std::optional<DeliberateError> deliberateErrorByName(std::string_view name) {
  for (const DeliberateErrorInfo& entry : kErrors) {
    if (entry.name == name) return entry.error;
  }
  return std::nullopt;
}

}  // namespace rasterdiff::rasterizer
