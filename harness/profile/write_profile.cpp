// The JSON of profiles and of inferences.
#include <fmt/format.h>

#include "harness/infer/card.hpp"
#include "harness/profile/profile_file.hpp"
#include "harness/report/json_parts.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::ChoiceInfo;
using rasterizer::SampleTables;

Json tableJson(std::span<const SampleTables::Offset> offsets) {
  Json table = Json::array();
  for (const SampleTables::Offset& offset : offsets) table.push_back({offset.x / 16.0, offset.y / 16.0});
  return table;
}

Json choicesJson(const rasterizer::Choices& choices, uint32_t openChoices) {
  Json json = Json::object();
  for (const ChoiceInfo& row : rasterizer::choiceTable()) {
    const bool open = (openChoices & rasterizer::bitOf(row.choice)) != 0;
    json[std::string(row.name)] = open ? Json(nullptr) : Json(row.answers[row.get(choices)]);
  }
  if (choices.sampleLocations) {
    for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
      json["sampleLocations"][std::to_string(samples)] = tableJson(choices.sampleLocations->of(samples));
    }
  }
  return json;
}

std::string_view nameOf(Finding::Status status) {
  switch (status) {
    case Finding::Status::Found: return "found";
    case Finding::Status::NoneFits: return "none-fits";
    case Finding::Status::NotOffered: return "not-offered";
  }
  return "";
}

Json findingJson(const Finding& finding) {
  const ChoiceInfo& row = rasterizer::info(finding.choice);
  Json json{{"choice", row.name}, {"question", row.question}, {"status", nameOf(finding.status)}};
  json["answer"] = finding.status == Finding::Status::Found ? Json(row.answers[finding.answer]) : Json(nullptr);
  json["decidingEvents"] = finding.decidingEvents();
  json["sureness"] = finding.status == Finding::Status::Found ? Json(sureness(finding.decidingEvents())) : Json(nullptr);
  json["scenes"] = finding.scenes;
  json["samples"] = finding.samples;
  Json excluded = Json::object(), alike = Json::array();
  for (const Rival& rival : finding.rivals) {
    const std::string name(row.answers[rival.answer]);
    if (rival.contradictions == 0) {
      alike.push_back(name);
    } else {
      excluded[name] = rival.contradictions;
    }
  }
  json["excluded"] = excluded;
  json["alike"] = alike;
  return json;
}

}  // namespace

std::string writeProfile(const Profile& profile) {
  return textOf({{"format", "rasterdiff-profile-1"},
                 {"name", profile.name},
                 {"driver", profile.driver},
                 {"info", profile.info},
                 {"choices", choicesJson(profile.choices, profile.openChoices)},
                 {"values", profile.choices.valuesOpen ? "open" : "closed"}}) +
         "\n";
}

std::string inferenceJson(const Inference& inference) {
  Json json{{"format", "rasterdiff-inference-1"},
            {"driver", inference.driver},
            {"info", inference.info},
            {"subPixelPrecisionBits", inference.advertisedBits},
            {"experiments", inference.scenes},
            {"seconds", jsonNumber(inference.seconds)},
            {"choices", choicesJson(inference.choices, inference.openChoices)},
            {"values", inference.choices.valuesOpen ? "open" : "closed"},
            {"findings", Json::array()},
            {"sampleLocations", Json::array()},
            {"errors", Json::array()}};
  for (const Finding& finding : inference.findings) json["findings"].push_back(findingJson(finding));
  for (const SampleFinding& finding : inference.samples) {
    json["sampleLocations"].push_back({{"samples", finding.samples},
                                       {"standard", finding.standard},
                                       {"decidingEvents", finding.decidingEvents},
                                       {"sixteenths", tableJson(finding.offsets)}});
  }
  for (const ErrorMeasure& error : inference.errors) {
    json["errors"].push_back({{"name", error.name},
                              {"values", error.values},
                              {"exact", error.exact},
                              {"maxUlp", jsonNumber(error.maxUlp)},
                              {"meanUlp", jsonNumber(error.meanUlp)}});
  }
  return textOf(json) + "\n";
}

}  // namespace rasterdiff::harness
