#include "harness/infer/card.hpp"

#include <fmt/format.h>

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::ChoiceInfo;
using Out = std::back_insert_iterator<std::string>;

constexpr int kNameWidth = 27, kAnswerWidth = 22;

std::string answerOf(const Inference& inference, const Finding& finding) {
  const ChoiceInfo& row = rasterizer::info(finding.choice);
  if (finding.status == Finding::Status::NotOffered) return "open: not offered";
  if (finding.status == Finding::Status::NoneFits) return "open: none fits";
  std::string answer(row.answers[finding.answer]);
  if (finding.choice == Choice::SubPixelBits) {
    answer += inference.choices.subPixelBits == inference.advertisedBits
                  ? ", as advertised"
                  : fmt::format(" ({} advertised)", inference.advertisedBits);
  }
  return answer;
}

std::string evidenceOf(const Finding& finding) {
  const ChoiceInfo& row = rasterizer::info(finding.choice);
  if (finding.status == Finding::Status::NotOffered) return "the device offers nothing that shows it";
  if (finding.status == Finding::Status::NoneFits) {
    return fmt::format("every candidate contradicted within {} scenes; {} was the last", finding.scenes, row.answers[finding.answer]);
  }
  const uint64_t events = finding.decidingEvents();
  std::string text = events == 0 ? fmt::format("{} scenes", finding.scenes)
                                 : fmt::format("{}, {} events", sureness(events), events);
  std::string excluded, alike;
  for (const Rival& rival : finding.rivals) {
    const std::string_view name = row.answers[rival.answer];
    if (rival.contradictions == 0) {
      alike += fmt::format("{}{}", alike.empty() ? "" : ", ", name);
    } else {
      excluded += fmt::format("{}{} {}", excluded.empty() ? "" : ", ", name, rival.contradictions);
    }
  }
  if (!excluded.empty()) text += "; not " + excluded;
  if (!alike.empty()) text += "; no experiment tells it from " + alike;
  return text;
}

void line(Out out, std::string_view name, std::string_view answer, std::string_view evidence) {
  fmt::format_to(out, "{:<{}} {:<{}} {}\n", name, kNameWidth, answer, kAnswerWidth, evidence);
}

void sampleLines(Out out, const Inference& inference) {
  for (const SampleFinding& finding : inference.samples) {
    std::string places;
    for (const auto& offset : finding.offsets) places += fmt::format("({},{})", offset.x / 16.0, offset.y / 16.0);
    line(out, fmt::format("sample locations, {}x", finding.samples), finding.standard ? "standard" : "others",
         fmt::format("{}, {} events; 1/16 pixel: {}", sureness(finding.decidingEvents), finding.decidingEvents, places));
  }
}

void valueLines(Out out, const Inference& inference) {
  const uint64_t outside = inference.valuesOutside;
  line(out, "places of inputs", outside > 0 ? "open" : inference.valuesDecided ? "as found" : "not offered",
       outside > 0 ? fmt::format("{} values evaluated elsewhere than centre, centroid or sample: left to the specification", outside)
                   : "every input where its decoration says");
  for (const ErrorMeasure& error : inference.errors) {
    const double exact = error.values == 0 ? 0 : 100.0 * static_cast<double>(error.exact) / static_cast<double>(error.values);
    line(out, "error of " + error.name, fmt::format("mean {:.3g} ulp", error.meanUlp),
         fmt::format("largest {:.4g} ulp, {:.1f} % exact, {} values", error.maxUlp, exact, error.values));
  }
}

}  // namespace

std::string_view sureness(uint64_t decidingEvents) {
  return decidingEvents >= 100 ? "certain" : decidingEvents >= 10 ? "sure" : "likely";
}

std::string inferenceCard(const Inference& inference) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}\n{} experiments, {:.1f} s\n\n", inference.driver, inference.info, inference.scenes, inference.seconds);
  std::string open;
  for (const Finding& finding : inference.findings) {
    line(out, rasterizer::info(finding.choice).question, answerOf(inference, finding), evidenceOf(finding));
    if ((inference.openChoices & rasterizer::bitOf(finding.choice)) != 0) {
      open += fmt::format("{}{}", open.empty() ? "" : ", ", rasterizer::info(finding.choice).question);
    }
  }
  sampleLines(out, inference);
  valueLines(out, inference);
  if (inference.valuesOutside > 0) open += fmt::format("{}places of inputs", open.empty() ? "" : ", ");
  fmt::format_to(out, "\nundetermined: {}\n", open.empty() ? "nothing" : open + " (judged by the specification)");
  return text;
}

}  // namespace rasterdiff::harness
