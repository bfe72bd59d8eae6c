#include "harness/report/explanation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "harness/report/numbers.hpp"
#include "harness/report/text_picture.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;
using namespace rasterizer;

constexpr size_t kShownPrimitives = 12;

double pixels(int32_t subpixels) { return static_cast<double>(subpixels) / kSubpixelOne; }
/// Edge values and areas: Q.16 of a pixel².
double squarePixels(int64_t value) { return static_cast<double>(value) / (kSubpixelOne * kSubpixelOne); }

std::string place(const SubpixelPosition& p) { return fmt::format("({}, {})", pixels(p.x), pixels(p.y)); }

const RuleInfo* infoOf(Rule rule) {
  for (const RuleInfo& known : countedRules()) {
    if (known.rule == rule) return &known;
  }
  return nullptr;
}

std::string_view side(const EdgeExplanation& edge) {
  if (edge.value > 0) return "inside";
  if (edge.value < 0) return "outside";
  return edge.ownsTies ? "ON THE EDGE, which owns its samples" : "ON THE EDGE, which leaves its samples to the other side";
}

void writeEdge(Out out, const EdgeExplanation& edge) {
  fmt::format_to(out, "    edge    {} to {}: {} = {} pixel^2, {}", place(edge.ends[0]), place(edge.ends[1]), edge.value,
                 squarePixels(edge.value), side(edge));
  if (edge.lowest != edge.highest) {
    fmt::format_to(out, "; {} to {} over all legal placements", edge.lowest, edge.highest);
  }
  fmt::format_to(out, "\n");
}

std::string_view word(Coverage coverage) {
  switch (coverage) {
    case Coverage::Out: return "not covered";
    case Coverage::In: return "covered";
    case Coverage::Either: return "open";
  }
  return "open";
}

void writePrimitive(Out out, const PrimitiveExplanation& primitive, bool open, bool depth) {
  fmt::format_to(out, "primitive {}{}: {}-facing{}, signed area a = {} pixel^2\n", primitive.primitive,
                 primitive.clipped ? " (a piece that clipping made)" : "", primitive.frontFacing ? "front" : "back",
                 primitive.culled ? ", CULLED" : "", 0 - squarePixels(primitive.doubleArea) / 2);  // Vulkan's a
  for (size_t v = 0; v < 3; ++v) {
    const ClipPosition& clip = primitive.clip[v];
    const SubpixelPosition& snapped = primitive.snapped[v];
    fmt::format_to(out, "    vertex  clip ({}, {}, {}, {}), pixel {} = ({}, {})/256\n", clip.x, clip.y, clip.z, clip.w,
                   place(snapped), snapped.x, snapped.y);
  }
  for (const EdgeExplanation& edge : primitive.edges) writeEdge(out, edge);
  fmt::format_to(out, "    result  {}", primitive.covered ? "covered" : "not covered");
  if (const RuleInfo* rule = infoOf(primitive.decidedBy)) {
    fmt::format_to(out, ", decided by {} {} [{}]", rule->id, rule->name, rule->anchor);
  }
  if (depth && primitive.covered) fmt::format_to(out, ", depth {}", primitive.depth);
  fmt::format_to(out, "\n");
  if (open) {
    fmt::format_to(out, "    legal   {}", word(primitive.coverage));
    if (primitive.freedom != Freedom::None) {
      const FreedomInfo& freedom = info(primitive.freedom);
      fmt::format_to(out, ": {} [{}], {}", freedom.id, freedom.anchor, freedom.what);
    }
    fmt::format_to(out, "\n");
  }
}

std::string answer(const Frame& frame, const SampleQuery& query) {
  const uint32_t primitive = frame.primitive.at(query.x, query.y, query.sample);
  const uint32_t count = frame.count.at(query.x, query.y, query.sample);
  std::string text =
      primitive == 0 ? "nothing" : fmt::format("{}, drawn {}", primitiveText(primitive), counted(count, "time"));
  if (frame.depth) text += fmt::format(", depth {}", frame.depth->at(query.x, query.y, query.sample));
  if (primitive == 0) return text;
  for (const VaryingPlane& varying : frame.varyings) {
    text += fmt::format(", {} (", varying.name);
    for (uint32_t c = 0; c < varying.values.components; ++c) {
      text += fmt::format("{}{}", c > 0 ? ", " : "", varying.values.at(query.x, query.y, query.sample, c));
    }
    text += ")";
  }
  return text;
}

void writeVerdict(Out out, const SceneResult& verdict) {
  fmt::format_to(out, "verdict     {}", toString(verdict.verdict));
  if (!verdict.differences.empty()) {
    const SampleDifference& difference = verdict.differences.front();
    fmt::format_to(out, ": {} [{}]", difference.reason, difference.anchor);
  } else if (!verdict.reason.empty()) {
    fmt::format_to(out, ": {}", verdict.reason);
  }
  fmt::format_to(out, "\n");
  for (const ValueStats& value : verdict.values) {
    if (!value.worst || value.maxUlp == 0) continue;
    fmt::format_to(out, "            {}[{}]: {} for {}, {} ULP away; legal is {} to {}\n", value.name,
                   value.worst->component, value.worst->actual, value.worst->expected, ulps(value.maxUlp),
                   value.worst->lo, value.worst->hi);
  }
}

}  // namespace

std::string explanationText(const Explanation& e) {
  std::string text;
  const auto out = std::back_inserter(text);
  const SampleExplanation& sample = e.sample;
  fmt::format_to(out, "scene       {}, {} x {} pixels, {}\n", e.address, e.scene.target.width, e.scene.target.height,
                 counted(e.scene.target.samples, "sample"));
  fmt::format_to(out, "sample      {} of pixel ({}, {}), at {} = ({}, {})/256{}\n", e.query.sample, e.query.x, e.query.y,
                 place(sample.position), sample.position.x, sample.position.y,
                 sample.insideScissor ? "" : ", OUTSIDE THE SCISSOR [vk:fragops-scissor]");
  fmt::format_to(out, "rules       {}{}, {} subpixel bits\n\n", e.rules.name, e.rules.open ? " (every choice open)" : "",
                 e.rules.limits.subPixelPrecisionBits);
  if (sample.primitives.empty()) fmt::format_to(out, "no primitive comes near this pixel\n");
  for (size_t i = 0; i < sample.primitives.size() && i < kShownPrimitives; ++i) {
    writePrimitive(out, sample.primitives[i], e.rules.open, e.scene.target.depthFormat.has_value());
  }
  if (sample.primitives.size() > kShownPrimitives) {
    fmt::format_to(out, "and {}\n", counted(sample.primitives.size() - kShownPrimitives, "further primitive"));
  }
  fmt::format_to(out, "\nreference   {}\n", answer(e.reference, e.query));
  if (e.driver) {
    fmt::format_to(out, "driver      {}\n            by {}\n", answer(e.driver->frame, e.query), e.driver->subject);
    writeVerdict(out, e.driver->verdict);
  }
  text += '\n';
  text += textPicture(e.reference, e.driver ? &e.driver->frame : nullptr, {e.query.x, e.query.y, e.query.sample});
  return text;
}

}  // namespace rasterdiff::harness
