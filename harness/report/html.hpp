// The report for people: one HTML file with everything in it, pictures included; it loads nothing from anywhere.
#pragma once

#include <string>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

[[nodiscard]] std::string htmlReport(const Report& report);

/// One scene as a foldable block; scenes that failed are open. (html_scene.cpp)
[[nodiscard]] std::string htmlScene(const Report& report, const SceneEntry& entry);

/// `<img>` with the PNG file embedded.
[[nodiscard]] std::string htmlPicture(std::string_view png, uint32_t width, uint32_t height, std::string_view what);

}  // namespace rasterdiff::harness
