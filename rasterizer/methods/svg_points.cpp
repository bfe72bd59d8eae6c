#include "rasterizer/methods/svg_points.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace rasterdiff::rasterizer {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

struct Reader {
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
  [[nodiscard]] tl::unexpected<Error> error(size_t position, std::string what, std::string hint) const {
    return fail(ErrorCode::BadInput, fmt::format("points:{}", position + 1), std::move(what), std::move(hint));
  }
};

/// sign? (digits? '.' digits | digits '.'?) ([eE] sign? digits)?, and nothing that a C library would add to it.
Result<double> number(Reader& reader) {
  const size_t start = reader.at;
  if (reader.peek() == '+' || reader.peek() == '-') ++reader.at;
  size_t digits = reader.digits();
  if (reader.peek() == '.') {
    ++reader.at;
    digits += reader.digits();
  }
  if (digits == 0) return reader.error(start, "a number is expected", "write points as \"x,y x,y x,y\"");
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
    return reader.error(start, "the number cannot be represented", "keep coordinates within the range of a double");
  }
  return value;
}

}  // namespace

Result<std::vector<SvgPoint>> parseSvgPoints(std::string_view text) {
  std::vector<SvgPoint> points;
  Reader reader{text};
  reader.spaces();
  bool haveX = false;
  double x = 0;
  while (!reader.done()) {
    const Result<double> value = number(reader);
    if (!value) return tl::unexpected(value.error());
    if (haveX) points.push_back({x, *value});
    x = *value;
    haveX = !haveX;
    reader.spaces();
    if (reader.peek() == ',') {
      ++reader.at;
      reader.spaces();
      if (reader.done()) return reader.error(reader.at, "the list ends with a comma", "remove it or add a number");
    }
  }
  if (haveX) return reader.error(text.size(), "an odd number of coordinates", "every point has an x and a y");
  return points;
}

}  // namespace rasterdiff::rasterizer
