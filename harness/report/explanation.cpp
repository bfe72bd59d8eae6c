#include "harness/report/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/report/explanation_parts.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/text_picture.hpp"

namespace rasterdiff::harness {
namespace {

using Out = TextOut;
using namespace rasterizer;

constexpr size_t kShownPrimitives = 12, kShownRejections = 6, kShownSuspects = 8;

std::string place(const SubpixelPosition& p) {
  return fmt::format("({}, {})", static_cast<double>(p.x) / kSubpixelOne, static_cast<double>(p.y) / kSubpixelOne);
}

std::string_view word(Coverage coverage) {
  switch (coverage) {
    case Coverage::Out: return "not covered";
    case Coverage::In: return "covered";
    case Coverage::Either: return "open";
  }
  return "open";
}

void writePrimitive(Out out, const PrimitiveExplanation& e, bool open, bool depth) {
  if (e.unprojectable) {
    writeUnprojectable(out, e);
  } else if (e.kind == PrimitiveExplanation::Kind::Triangle) {
    writeTriangle(out, e);
  } else {
    writeFigure(out, e);
  }
  const std::string fate = fateText(e, depth);
  fmt::format_to(out, "    result  {}, decided by {}\n", e.unprojectable ? "no place on the screen" : fate.empty() ? "not covered" : fate, ruleText(e.decidedBy));
  if (!open) return;
  fmt::format_to(out, "    legal   {}", word(e.coverage));
  if (e.freedom != Freedom::None) {
    const FreedomInfo& freedom = info(e.freedom);
    fmt::format_to(out, ": {} [{}], {}", freedom.id, freedom.anchor, freedom.what);
  }
  fmt::format_to(out, "\n");
}

void writeRejections(Out out, const SampleExplanation& sample) {
  for (size_t i = 0; i < sample.rejections.size() && i < kShownRejections; ++i) {
    const Rejection& rejection = sample.rejections[i];
    fmt::format_to(out, "rejected    {}, {} the first, by {}: {}\n", counted(rejection.count, "primitive"),
                   primitiveText(rejection.first), rejection.by, ruleText(rejection.rule));
  }
}

void writeRules(Out out, const SampleExplanation& sample) {
  std::string ids;
  for (const Rule rule : sample.rules) {
    const std::string id(ruleId(rule));
    if ((ids + " ").find(id + " ") == std::string::npos) ids += (ids.empty() ? "" : " ") + id;
  }
  fmt::format_to(out, "at work     {}\n", ids);
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

// Which known mistakes would give the driver's answer.
void writeSuspicion(Out out, const Suspicion& suspicion) {
  if (suspicion.suspects.empty()) {
    fmt::format_to(out, "suspects    none of {} known mistakes gives this answer\n", suspicion.tried);
    return;
  }
  for (size_t i = 0; i < suspicion.suspects.size() && i < kShownSuspects; ++i) {
    const Suspect& suspect = suspicion.suspects[i];
    fmt::format_to(out, "suspect     {}: {} (mutant:{})\n", suspect.rule, suspect.what, suspect.mutant);
  }
  const uint64_t left = suspicion.suspects.front().left;
  fmt::format_to(out, "            explains this sample and {} of the scene's {} differing samples and values\n",
                 left == 0 ? "all" : grouped(suspicion.differing - left), grouped(suspicion.differing));
}

std::string scissorNote(const rasterizer::SampleExplanation& sample) {
  if (sample.insideScissor) return "";
  const bool covered = std::ranges::any_of(sample.primitives, &rasterizer::PrimitiveExplanation::covered);
  return fmt::format(", OUTSIDE THE SCISSOR [vk:fragops-scissor]{}", covered ? ", WHICH THESE RULES LET IT THROUGH" : "");
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
                 scissorNote(sample));
  fmt::format_to(out, "rules       {}{}, {} subpixel bits\n\n", e.rules.name, e.rules.open ? " (every choice open)" : "",
                 e.rules.limits.subPixelPrecisionBits);
  if (sample.primitives.empty()) fmt::format_to(out, "no primitive comes near this pixel\n");
  for (size_t i = 0; i < sample.primitives.size() && i < kShownPrimitives; ++i) {
    writePrimitive(out, sample.primitives[i], e.rules.open, e.scene.target.depthFormat.has_value());
  }
  if (sample.primitives.size() > kShownPrimitives) {
    fmt::format_to(out, "and {}\n", counted(sample.primitives.size() - kShownPrimitives, "further primitive"));
  }
  writeRejections(out, sample);
  writeRules(out, sample);
  fmt::format_to(out, "\nreference   {}\n", answer(e.reference, e.query));
  if (e.driver) {
    fmt::format_to(out, "driver      {}\n            by {}\n", answer(e.driver->frame, e.query), e.driver->subject);
    writeVerdict(out, e.driver->verdict);
    if (e.driver->suspicion) writeSuspicion(out, *e.driver->suspicion);
  }
  text += '\n';
  text += textPicture(e.reference, e.driver ? &e.driver->frame : nullptr, {e.query.x, e.query.y, e.query.sample});
  return text;
}

}  // namespace rasterdiff::harness
