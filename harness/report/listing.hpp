// What `devices` and `list` know, as text for people and as JSON; rules have rule_survey.hpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/catalogue/catalogue.hpp"
#include "vkref/device.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string devicesText(std::span<const vkref::DriverCandidate> candidates);
[[nodiscard]] std::string devicesJson(std::span<const vkref::DriverCandidate> candidates);

[[nodiscard]] std::string scenesText(std::span<const CatalogueEntry* const> entries);
[[nodiscard]] std::string scenesJson(std::span<const CatalogueEntry* const> entries);

[[nodiscard]] std::string mutantsText();
[[nodiscard]] std::string mutantsJson();
[[nodiscard]] std::string freedomsText();
[[nodiscard]] std::string freedomsJson();

}  // namespace rasterdiff::harness
