// The JSON objects that several writers share. The only header that needs nlohmann; include it in few files.
#pragma once

#include <nlohmann/json.hpp>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json jsonOf(const PlacementAnswer& answer);
[[nodiscard]] Json jsonOf(const SceneResult& result);
[[nodiscard]] Json jsonOf(const SceneEntry& entry);  ///< the result and what is known of its scene; no pictures
[[nodiscard]] Json jsonOf(const Limits& limits);
[[nodiscard]] Json jsonOf(const Error& error);
[[nodiscard]] Json jsonOf(const Seconds& seconds);

/// Numbers that JSON has no words for become the strings "NaN", "Infinity", "-Infinity".
[[nodiscard]] Json jsonNumber(double number);

/// The text of a document; bytes that are not UTF-8 are replaced, never thrown at.
[[nodiscard]] std::string textOf(const Json& json, int indent = 2);

}  // namespace rasterdiff::harness
