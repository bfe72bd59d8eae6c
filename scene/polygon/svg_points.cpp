#include "scene/polygon/svg_points.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace rasterdiff {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

constexpr int32_t kMost = kMaxPolygonCoordinate / kSubpixelOne;  // pixels

struct PointsReader {
  std::string_view text;
  size_t at = 0;

  [[nodiscard]] char peek(size_t ahead = 0) const { return at + ahead < text.size() ? text[at + ahead] : '\0'; }
  [[nodiscard]] bool done() const { return at >= text.size(); }
  size_t digits() {
    const size_t start = at;
    while (isDigit(peek())) ++at;
    return at - start;
  }
  void spaces() {
    while (isSpace(peek())) ++at;
  }
};

tl::unexpected<PointsMistake> mistake(size_t at, std::string what, std::string hint) {
  return tl::unexpected<PointsMistake>({at, std::move(what), std::move(hint)});
}

/// sign? (digits? '.' digits | digits '.'?) ([eE] sign? digits)?, and nothing that a C library would add to it.
tl::expected<double, PointsMistake> number(PointsReader& reader) {
  const size_t start = reader.at;
  if (reader.peek() == '+' || reader.peek() == '-') ++reader.at;
  size_t digits = reader.digits();
  if (reader.peek() == '.') {
    ++reader.at;
    digits += reader.digits();
  }
  if (digits == 0) return mistake(start, "a number is expected", "write points as \"x,y x,y x,y\"");
  if (reader.peek() == 'e' || reader.peek() == 'E') {
    const size_t sign = reader.peek(1) == '+' || reader.peek(1) == '-' ? 1 : 0;
    if (isDigit(reader.peek(1 + sign))) {
      reader.at += 1 + sign;
      reader.digits();
    }
  }
  const size_t first = reader.text[start] == '+' ? start + 1 : start;
  double value = 0;
  const char* end = reader.text.data() + reader.at;
  const auto [stopped, code] = std::from_chars(reader.text.data() + first, end, value);
  if (code != std::errc{} || stopped != end) {
    return mistake(start, "the number cannot be represented", "keep coordinates within the range of a double");
  }
  if (std::fabs(value) > kMost) {
    return mistake(start, "a coordinate is out of range", fmt::format("keep within ±{} pixels", kMost));
  }
  return value;
}

}  // namespace

tl::expected<std::vector<SvgPoint>, PointsMistake> parseSvgPoints(std::string_view text) {
  std::vector<SvgPoint> points;
  PointsReader reader{text};
  reader.spaces();
  bool haveX = false;
  double x = 0;
  while (!reader.done()) {
    const tl::expected<double, PointsMistake> value = number(reader);
    if (!value) return tl::unexpected(value.error());
    if (haveX) points.push_back({x, *value});
    x = *value;
    haveX = !haveX;
    reader.spaces();
    if (reader.peek() == ',') {
      ++reader.at;
      reader.spaces();
      if (reader.done()) return mistake(reader.at, "the list ends with a comma", "remove it or add a number");
    }
  }
  if (haveX) return mistake(text.size(), "an odd number of coordinates", "every point has an x and a y");
  return points;
}

tl::expected<Polygon, PointsMistake> parsePolygonPoints(std::string_view text) {
  const auto points = parseSvgPoints(text);
  if (!points) return tl::unexpected(points.error());
  if (points->size() < 3 || points->size() > kMaxPolygonVertices) {
    return mistake(0, fmt::format("a polygon of {} points", points->size()),
                   fmt::format("give 3 to {} points", kMaxPolygonVertices));
  }
  Polygon polygon;
  polygon.vertices.reserve(points->size());
  for (const SvgPoint& point : *points) {  // Q20.8, |v| ≤ kMaxPolygonCoordinate
    polygon.vertices.push_back({static_cast<int32_t>(std::nearbyint(point.x * kSubpixelOne)),
                                static_cast<int32_t>(std::nearbyint(point.y * kSubpixelOne))});
  }
  return polygon;
}

}  // namespace rasterdiff
