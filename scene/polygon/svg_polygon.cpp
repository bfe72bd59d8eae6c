#include "scene/polygon/svg_polygon.hpp"

#include <fmt/format.h>

#include <charconv>

#include "scene/file/json_document.hpp"
#include "scene/file/read_file.hpp"
#include "scene/polygon/svg_markup.hpp"
#include "scene/polygon/svg_points.hpp"

namespace rasterdiff {
namespace {

struct Source {
  std::string_view svg;
  const std::string& fileName;

  [[nodiscard]] tl::unexpected<Error> error(size_t at, std::string what, std::string hint) const {
    return fail(ErrorCode::BadInput, textPosition(svg, at, fileName), std::move(what), std::move(hint));
  }
};

/// A length in pixels ("64", "64px"), or a negative number for anything else.
double pixels(const SvgAttribute* length) {
  if (length == nullptr) return -1;
  const char* end = length->value.data() + length->value.size();
  double value = -1;
  const auto [stopped, code] = std::from_chars(length->value.data(), end, value);
  const std::string_view unit(stopped, static_cast<size_t>(end - stopped));
  return code == std::errc{} && (unit.empty() || unit == "px") ? value : -1;
}

bool leavesThePicture(const SvgTag& tag, const SvgAttribute& viewBox) {
  const auto box = parseSvgPoints(viewBox.value);
  return box && box->size() == 2 && (*box)[0] == SvgPoint{} &&
         (*box)[1] == SvgPoint{pixels(tag.find("width")), pixels(tag.find("height"))};
}

Result<void> checkPlacement(const Source& source, const SvgTag& tag) {
  if (const SvgAttribute* found = tag.find("transform"); found != nullptr) {
    return source.error(found->at, "'transform' is not understood", "write the polygon in pixels");
  }
  if (const SvgAttribute* found = tag.find("viewBox"); found != nullptr && !leavesThePicture(tag, *found)) {
    return source.error(found->at, "a viewBox that scales or moves the picture",
                        "write the polygon in pixels; a viewBox may be \"0 0 width height\" with the element's own");
  }
  return {};
}

Result<SvgPolygon> polygonOf(const Source& source, const SvgTag& tag) {
  const SvgAttribute* points = tag.find("points");
  if (points == nullptr) return source.error(tag.at, "a polygon without points", "add points=\"x,y x,y x,y\"");
  SvgPolygon result;
  if (const SvgAttribute* rule = tag.find("fill-rule"); rule != nullptr) {
    if (rule->value != "evenodd" && rule->value != "nonzero") {
      return source.error(rule->at, "an unknown fill-rule", "write evenodd or nonzero");
    }
    result.fillRule = rule->value == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
  }
  auto polygon = parsePolygonPoints(points->value);
  if (!polygon) return source.error(points->at + polygon.error().at, polygon.error().what, polygon.error().hint);
  result.polygon = std::move(*polygon);
  return result;
}

}  // namespace

Result<std::vector<SvgPolygon>> parseSvgPolygons(std::string_view svg, const std::string& fileName) {
  const Result<std::vector<SvgTag>> tags = svgTags(svg, fileName);
  if (!tags) return tl::unexpected(tags.error());
  const Source source{svg, fileName};
  std::vector<SvgPolygon> polygons;
  for (const SvgTag& tag : *tags) {
    if (auto placed = checkPlacement(source, tag); !placed) return tl::unexpected(placed.error());
    if (tag.name != "polygon") continue;
    Result<SvgPolygon> polygon = polygonOf(source, tag);
    if (!polygon) return tl::unexpected(polygon.error());
    polygons.push_back(std::move(*polygon));
  }
  return polygons;
}

Result<std::vector<SvgPolygon>> loadSvgPolygons(const std::string& path) {
  const Result<std::string> text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  return parseSvgPolygons(*text, path);
}

}  // namespace rasterdiff
