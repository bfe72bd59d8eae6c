#include "rasterizer/choice_table.hpp"

#include <algorithm>
#include <array>

#include "rasterizer/lines/smooth_line.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Names = std::string_view;

template <auto Field>
uint32_t read(const Choices& choices) {
  return static_cast<uint32_t>(choices.*Field);
}

template <auto Field>
void write(Choices& choices, uint32_t answer) {
  using Answer = std::remove_reference_t<decltype(choices.*Field)>;
  choices.*Field = static_cast<Answer>(answer);
}

constexpr uint32_t kLeastBits = 4;  // [vk:limits-subPixelPrecisionBits]
uint32_t readBits(const Choices& choices) { return choices.subPixelBits == 0 ? 0 : choices.subPixelBits - kLeastBits + 1; }
void writeBits(Choices& choices, uint32_t answer) { choices.subPixelBits = answer == 0 ? 0 : answer + kLeastBits - 1; }

constexpr std::array<Names, 6> kBits{"advertised", "4", "5", "6", "7", "8"};
constexpr std::array<Names, 5> kViewport{"Exact", "Float32", "Float32Fma", "Float32Division", "Float32DivisionFma"};
constexpr std::array<Names, 8> kRounding{"NearestEven", "NearestUp",   "Floor",            "TowardZero",
                                         "NearestDown", "NearestAway", "NearestTowardZero", "Ceiling"};
constexpr std::array<Names, 4> kOrigin{"Corner", "CentreAtOneSample", "Centre", "CentreInViewport"};
constexpr std::array<Names, 4> kOwner{"TopLeft", "TopRight", "BottomLeft", "BottomRight"};
constexpr std::array<Names, 4> kSlanted{"LikeVertical", "AgainstVertical", "LikeHorizontal", "AgainstHorizontal"};
constexpr std::array<Names, 2> kWinding{"Same", "OppositeIfCounterClockwise"};
constexpr std::array<Names, 3> kClip{"Exact", "Float32Linear", "Float32Weighted"};
constexpr std::array<Names, 3> kFill{"Polygon", "Fan", "Spans"};
constexpr std::array<Names, 2> kDistances{"Cut", "Fragments"};
constexpr std::array<Names, 3> kCull{"Snapped", "AlsoFloat", "UncutFloat32"};
constexpr std::array<Names, 3> kOutline{"Original", "Flagged", "Uncut"};
constexpr std::array<Names, 2> kPointClip{"Volume", "SidesIgnored"};
constexpr std::array<Names, 2> kRegion{"Scissor", "RoundedViewport"};
constexpr std::array<Names, 5> kPoint{"Exact", "SnappedCentre", "SnappedCorners", "ClipCorners", "SnappedCentreEven"};
constexpr std::array<Names, 3> kLine{"Exact", "Float32Corners", "ClipCorners"};
constexpr std::array<Names, 2> kDiamond{"Vulkan", "Direct3D11"};
constexpr std::array<Names, 4> kBiasUnit{"OneStep", "TwoSteps", "OneStepOfRange", "OneStepAndPercent"};
constexpr std::array<Names, 2> kBiasExponent{"LargestDepth", "FirstDifferences"};
constexpr std::array<Names, 2> kBiasSlope{"Larger", "Length"};
constexpr std::array<Names, 3> kCentroid{"CentreOrFirst", "First", "Mean"};
constexpr std::array<Names, 3> kPlanes{"Unsnapped", "Snapped", "SnappedUncut"};
constexpr std::array<Names, 4> kResolve{"Any", "RoundedOnce", "InOrder", "Pairwise"};

template <auto Field>
constexpr ChoiceInfo row(Choice choice, Names name, Names question, std::span<const Names> answers) {
  return {choice, name, question, answers, read<Field>, write<Field>};
}

constexpr std::array<ChoiceInfo, kChoices> kTable{
    ChoiceInfo{Choice::SubPixelBits, "subPixelBits", "subpixel bits in use", kBits, readBits, writeBits},
    row<&Choices::viewportArithmetic>(Choice::ViewportArithmetic, "viewportArithmetic", "division and viewport", kViewport),
    row<&Choices::snapRounding>(Choice::SnapRounding, "snapRounding", "rounding to the grid", kRounding),
    row<&Choices::snapOrigin>(Choice::SnapOrigin, "snapOrigin", "origin of the rounding", kOrigin),
    row<&Choices::tieOwner>(Choice::TieOwner, "tieOwner", "owner of level edges", kOwner),
    row<&Choices::slantedTies>(Choice::SlantedTies, "slantedTies", "owner of slanted edges", kSlanted),
    row<&Choices::tieWinding>(Choice::TieWinding, "tieWinding", "ties by winding", kWinding),
    row<&Choices::clipArithmetic>(Choice::ClipArithmetic, "clipArithmetic", "vertices made by clipping", kClip),
    row<&Choices::cutFill>(Choice::CutFill, "cutFill", "filling of cut polygons", kFill),
    row<&Choices::clipDistances>(Choice::ClipDistances, "clipDistances", "clip distances", kDistances),
    row<&Choices::cullPosition>(Choice::CullPosition, "cullPosition", "position of culling", kCull),
    row<&Choices::cutOutline>(Choice::CutOutline, "cutOutline", "outlines of cut polygons", kOutline),
    row<&Choices::pointArithmetic>(Choice::PointArithmetic, "pointArithmetic", "square of a point", kPoint),
    row<&Choices::pointClip>(Choice::PointClip, "pointClip", "points beyond the sides", kPointClip),
    row<&Choices::drawingRegion>(Choice::DrawingRegion, "drawingRegion", "drawing region", kRegion),
    row<&Choices::lineArithmetic>(Choice::LineArithmetic, "lineArithmetic", "outline of a line", kLine),
    row<&Choices::diamondExit>(Choice::DiamondExit, "diamondExit", "border of the diamond", kDiamond),
    row<&Choices::depthBiasUnit>(Choice::DepthBiasUnit, "depthBiasUnit", "unit of depth bias", kBiasUnit),
    row<&Choices::depthBiasExponent>(Choice::DepthBiasExponent, "depthBiasExponent", "unit of a float depth bias", kBiasExponent),
    row<&Choices::depthBiasSlope>(Choice::DepthBiasSlope, "depthBiasSlope", "slope of depth bias", kBiasSlope),
    row<&Choices::centroid>(Choice::Centroid, "centroid", "place of centroid inputs", kCentroid),
    row<&Choices::planePositions>(Choice::PlanePositions, "planePositions", "positions under values", kPlanes),
    row<&Choices::resolveArithmetic>(Choice::ResolveArithmetic, "resolveArithmetic", "rounding of a resolve", kResolve),
};

bool isOutside(const ClipPosition& p) {
  return p.x > p.w || -p.x > p.w || p.y > p.w || -p.y > p.w || p.z > p.w || p.z < 0;
}

bool mayLeaveRegion(const Scene& scene) {
  const Viewport& v = scene.viewport;
  const bool whole = v.x == 0 && v.y == 0 && v.width == static_cast<float>(scene.target.width) &&
                     v.height == static_cast<float>(scene.target.height);
  return scene.scissor.has_value() || !whole || !scene.furtherViewports.empty();
}

bool hasClipDistances(const Scene& scene) {
  return std::ranges::any_of(scene.draws, [](const Draw& draw) { return draw.clipDistanceCount > 0; });
}

bool dependsOn(const Scene& scene, Choice choice) {
  const State& state = scene.state;
  switch (choice) {
    case Choice::ClipArithmetic: return mayClip(scene);
    case Choice::CutFill: return state.polygonMode == PolygonMode::FILL && mayClip(scene);
    case Choice::ClipDistances: return hasClipDistances(scene);
    case Choice::CullPosition: return state.cullMode != CullMode::NONE || mayClip(scene);
    case Choice::CutOutline: return state.polygonMode != PolygonMode::FILL && mayClip(scene);
    case Choice::PointClip: return drawsPoints(state) && mayClip(scene);
    case Choice::DrawingRegion: return mayLeaveRegion(scene);
    case Choice::PointArithmetic: return drawsPoints(state);
    case Choice::LineArithmetic:
    case Choice::DiamondExit: return drawsLines(state);
    case Choice::DepthBiasUnit:
    case Choice::DepthBiasExponent:
    case Choice::DepthBiasSlope: return state.depthBiasEnable;
    case Choice::Centroid:          // opens values, not coverage
    case Choice::PlanePositions:    // widens their intervals where they are computed
    case Choice::ResolveArithmetic: // has an answer that is open
      return false;
    default: return true;
  }
}

}  // namespace

bool mayClip(const Scene& scene) {
  for (const Draw& draw : scene.draws) {
    if (draw.clipDistanceCount > 0) return true;
    for (const ClipPosition& p : draw.positions) {
      if (isOutside(p)) return true;
    }
  }
  return false;
}

std::span<const ChoiceInfo> choiceTable() { return kTable; }

const ChoiceInfo& info(Choice choice) { return kTable[static_cast<size_t>(choice)]; }

std::optional<Choice> choiceByName(std::string_view name) {
  for (const ChoiceInfo& row : kTable) {
    if (row.name == name) return row.choice;
  }
  return std::nullopt;
}

Rules rulesFor(const Scene& scene, const Rules& rules) {
  Rules applied = rules;
  for (const ChoiceInfo& row : kTable) {
    if (isOpen(rules, row.choice) && dependsOn(scene, row.choice)) applied.open = true;
  }
  if (drawsSmoothLines(scene.state)) applied.open = true;  // [vk:primsrast-lines-smooth] no profile says more
  if (isOpen(rules, Choice::Centroid)) applied.choices.valuesOpen = true;
  return applied;
}

}  // namespace rasterdiff::rasterizer
