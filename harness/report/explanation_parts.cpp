#include "harness/report/explanation_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {
namespace {

using namespace rasterizer;

double pixels(int32_t subpixels) { return static_cast<double>(subpixels) / kSubpixelOne; }
/// Edge values and areas: Q.16 of a pixel².
double squarePixels(int64_t value) { return static_cast<double>(value) / (kSubpixelOne * kSubpixelOne); }

std::string place(const SubpixelPosition& p) { return fmt::format("({}, {})", pixels(p.x), pixels(p.y)); }
std::string place(const FramebufferPosition& p) { return fmt::format("({:.9g}, {:.9g})", p.x, p.y); }

std::string_view tie(bool owns) {
  return owns ? "ON THE EDGE, which owns its samples" : "ON THE EDGE, which leaves its samples to the other side";
}

std::string_view side(const EdgeExplanation& edge) {
  if (edge.value == 0) return tie(edge.ownsTies);
  return edge.value > 0 ? "inside" : "outside";
}

void writeEdge(TextOut out, const EdgeExplanation& edge) {
  fmt::format_to(out, "    edge    {} to {}: {} = {} pixel^2, {}", place(edge.ends[0]), place(edge.ends[1]), edge.value,
                 squarePixels(edge.value), side(edge));
  if (edge.lowest != edge.highest) {
    fmt::format_to(out, "; {} to {} over all legal placements", edge.lowest, edge.highest);
  }
  fmt::format_to(out, "\n");
}

void writeClip(TextOut out, const ClipPosition& clip) {
  fmt::format_to(out, "    vertex  clip ({}, {}, {}, {})", clip.x, clip.y, clip.z, clip.w);
}

void writeHead(TextOut out, const PrimitiveExplanation& e, std::string_view kind) {
  fmt::format_to(out, "primitive {}, {}{}{}", e.primitive, kind, e.clipped ? " that clipping cut" : "",
                 e.culled ? ", CULLED" : "");
}

void writeDiamond(TextOut out, const DiamondFacts& diamond) {
  const std::string_view column = diamond.xMajor ? "column" : "row";
  fmt::format_to(out, "    diamond {}-major, {} from end to end; this pixel's {} has number {}", diamond.xMajor ? "x" : "y",
                 counted(static_cast<uint64_t>(diamond.count), column), column,
                 diamond.number);
  if (!diamond.inColumn()) {
    fmt::format_to(out, ": the segment leaves no diamond there\n");
    return;
  }
  fmt::format_to(out, "\n    column  the line crosses its middle at {} = {}/{}, and leaves the diamond of pixel ({}, {})",
                 static_cast<double>(diamond.crossing) / static_cast<double>(diamond.unit), diamond.crossing, diamond.unit,
                 diamond.pixel.x, diamond.pixel.y);
  if (diamond.width > 1) fmt::format_to(out, "; {} wide from there", counted(static_cast<uint64_t>(diamond.width), "pixel"));
  fmt::format_to(out, "\n");
}

const RuleInfo* infoOf(Rule rule) {
  for (const RuleInfo& known : countedRules()) {
    if (known.rule == rule) return &known;
  }
  return nullptr;
}

}  // namespace

void writeTriangle(TextOut out, const PrimitiveExplanation& e) {
  writeHead(out, e, "a triangle");
  fmt::format_to(out, ": {}-facing, signed area a = {} pixel^2\n", e.frontFacing ? "front" : "back",
                 0 - squarePixels(e.doubleArea) / 2);  // Vulkan's a
  for (size_t v = 0; v < 3; ++v) {
    writeClip(out, e.clip[v]);
    fmt::format_to(out, ", pixel {} = ({}, {})/256\n", place(e.snapped[v]), e.snapped[v].x, e.snapped[v].y);
  }
  for (const EdgeExplanation& edge : e.edges) writeEdge(out, edge);
}

void writeUnprojectable(TextOut out, const PrimitiveExplanation& e) {
  writeHead(out, e, "a triangle");
  fmt::format_to(out, ": {}\n", e.clipped ? "clipping cuts it where w is 0" : "the w of a corner is 0");
  for (uint32_t v = 0; v < e.vertices; ++v) {
    writeClip(out, e.clip[v]);
    fmt::format_to(out, "\n");
  }
}

void writeFigure(TextOut out, const PrimitiveExplanation& e) {
  const bool point = e.kind == PrimitiveExplanation::Kind::Point;
  const bool ofTriangle = e.vertices == 3;
  writeHead(out, e, point ? (ofTriangle ? "a corner of a triangle" : "a point") : (ofTriangle ? "an edge of a triangle" : "a line"));
  fmt::format_to(out, ": {} {}", point ? "size" : "width", e.size);
  if (e.size != e.requested) fmt::format_to(out, " (asked for {})", e.requested);
  fmt::format_to(out, "\n");
  for (uint32_t v = 0; v < e.vertices; ++v) {
    writeClip(out, e.clip[v]);
    fmt::format_to(out, "\n");
  }
  if (point) {
    fmt::format_to(out, "    centre  {}, not rounded\n", place(e.ends[0]));
  } else {
    fmt::format_to(out, "    ends    {} to {}\n", place(e.ends[0]), place(e.ends[1]));
  }
  if (!e.facts.corners.empty()) {
    fmt::format_to(out, "    corners");
    for (const FramebufferPosition& corner : e.facts.corners) fmt::format_to(out, " {}", place(corner));
    fmt::format_to(out, "\n");
  }
  for (const SideFacts& known : e.facts.sides) {
    fmt::format_to(out, "    {:<7} ", known.name);
    if (known.exactlyOn) {
      fmt::format_to(out, "{}\n", tie(known.ownsTies));
    } else {
      fmt::format_to(out, "{:.6g} pixels {}\n", std::abs(known.inside), known.inside > 0 ? "inside" : "OUTSIDE");
    }
  }
  if (e.facts.diamond) writeDiamond(out, *e.facts.diamond);
  if (e.facts.stipple) {
    fmt::format_to(out, "    stipple counter {}, bit {} of the pattern: {}\n", e.facts.stipple->counter, e.facts.stipple->bit,
                   e.facts.stipple->draws ? "drawn" : "DROPPED");
  } else if (e.dropped) {
    fmt::format_to(out, "    stipple the pattern drops it\n");
  }
}

std::string fateText(const PrimitiveExplanation& e, bool depth) {
  const FragmentFate& fate = e.fate;
  const std::string depths = depth ? fmt::format(", depth {}", fate.depth) : "";
  switch (fate.end) {
    case FragmentFate::End::NotCovered: return {};
    case FragmentFate::End::OutsideScissor: return "inside, but outside of the scissor";
    case FragmentFate::End::Masked: return "covered, but the sample mask drops it" + depths;
    case FragmentFate::End::ShaderMasked: return fmt::format("covered, but the mask {:#x} that the shader writes drops it", fate.shaderMask) + depths;
    case FragmentFate::End::AlphaDropped: return fmt::format("covered, but an alpha of {} drops it", fate.alpha) + depths;
    case FragmentFate::End::DepthFailed:
      return fmt::format("covered, but depth {} fails against the stored {}", fate.depth, fate.stored);
    case FragmentFate::End::Written:
      return fate.replaced == 0 ? "drawn" + depths : fmt::format("drawn over primitive {}{}", fate.replaced, depths);
  }
  return {};
}

std::string ruleText(Rule rule) {
  const RuleInfo* info = infoOf(rule);
  return info == nullptr ? "" : fmt::format("{} {} [{}]", info->id, info->name, info->anchor);
}

std::string_view ruleId(Rule rule) {
  const RuleInfo* info = infoOf(rule);
  return info == nullptr ? std::string_view{} : info->id;
}

}  // namespace rasterdiff::harness
