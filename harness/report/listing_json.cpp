// The listings as JSON.
#include "harness/report/json_parts.hpp"
#include "harness/report/listing.hpp"
#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/freedoms.hpp"

namespace rasterdiff::harness {
namespace {

std::string document(const Json& json) { return textOf(json) + "\n"; }

}  // namespace

std::string devicesJson(std::span<const vkref::DriverCandidate> candidates) {
  Json json = Json::array();
  for (const vkref::DriverCandidate& candidate : candidates) {
    Json entry{{"name", candidate.name}, {"manifest", candidate.manifest}, {"usable", candidate.usable}};
    if (!candidate.usable) {
      entry["refusal"] = candidate.refusal;
    } else {
      entry["driverName"] = candidate.driver.name;
      entry["driverInfo"] = candidate.driver.info;
      entry["deviceName"] = candidate.driver.deviceName;
      entry["apiVersion"] = candidate.driver.apiVersion;
      entry["limits"] = jsonOf(candidate.limits);
      entry["facts"] = Json::object();
      for (const auto& [name, value] : candidate.facts) entry["facts"][name] = value;
    }
    json.push_back(std::move(entry));
  }
  return document(json);
}

std::string scenesJson(std::span<const CatalogueEntry* const> entries) {
  Json json = Json::array();
  for (const CatalogueEntry* entry : entries) {
    json.push_back({{"name", entry->name}, {"what", entry->what}, {"rules", entry->rules}, {"link", entry->link}});
  }
  return document(json);
}

std::string mutantsJson() {
  Json json = Json::array();
  for (const rasterizer::DeliberateErrorInfo& error : rasterizer::deliberateErrors()) {
    json.push_back({{"driver", "mutant:" + std::string(error.name)}, {"rule", error.rule}, {"what", error.what}});
  }
  return document(json);
}

std::string freedomsJson() {
  Json json = Json::array();
  for (const rasterizer::FreedomInfo& freedom : rasterizer::freedoms()) {
    if (freedom.freedom == rasterizer::Freedom::None) continue;
    json.push_back({{"id", freedom.id}, {"anchor", freedom.anchor}, {"what", freedom.what}});
  }
  return document(json);
}

}  // namespace rasterdiff::harness
