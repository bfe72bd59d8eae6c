#include "scene/polygon/svg_markup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/file/json_document.hpp"

namespace rasterdiff {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

struct Cursor {
  std::string_view text;
  const std::string& fileName;
  size_t at = 0;

  [[nodiscard]] bool startsWith(std::string_view what) const { return text.substr(at).starts_with(what); }
  [[nodiscard]] tl::unexpected<Error> error(size_t offset, std::string what) const {
    return fail(ErrorCode::BadInput, textPosition(text, offset, fileName), std::move(what), "check the markup");
  }
  void skipSpaces() { at = std::min(text.find_first_not_of(kSpaces, at), text.size()); }
  /// Moves behind `end`; false if it does not occur.
  bool skipPast(std::string_view end) {
    const size_t found = text.find(end, at);
    if (found == std::string_view::npos) return false;
    at = found + end.size();
    return true;
  }
  std::string_view name() {
    const size_t end = std::min(text.find_first_of(" \t\r\n=/><\"'", at), text.size());
    const std::string_view result = text.substr(at, end - at);
    at = end;
    return result;
  }
};

Result<SvgAttribute> attribute(Cursor& cursor) {
  const size_t start = cursor.at;
  SvgAttribute result;
  result.name = cursor.name();
  if (result.name.empty()) return cursor.error(start, "an attribute name is expected");
  cursor.skipSpaces();
  if (!cursor.startsWith("=")) return cursor.error(cursor.at, "'=' is expected after an attribute name");
  ++cursor.at;
  cursor.skipSpaces();
  if (!cursor.startsWith("\"") && !cursor.startsWith("'")) return cursor.error(cursor.at, "a quote is expected");
  const char quote = cursor.text[cursor.at++];
  result.at = cursor.at;
  const size_t end = cursor.text.find(quote, cursor.at);
  if (end == std::string_view::npos) return cursor.error(cursor.at - 1, "the quote is not closed");
  result.value = cursor.text.substr(cursor.at, end - cursor.at);
  cursor.at = end + 1;
  return result;
}

Result<SvgTag> startTag(Cursor& cursor) {
  SvgTag tag;
  tag.at = cursor.at++;
  tag.name = cursor.name();
  if (tag.name.empty()) return cursor.error(tag.at, "'<' without an element name");
  if (const size_t colon = tag.name.rfind(':'); colon != std::string_view::npos) tag.name.remove_prefix(colon + 1);
  while (true) {
    cursor.skipSpaces();
    if (cursor.startsWith(">") || cursor.startsWith("/>")) break;
    if (cursor.at >= cursor.text.size()) return cursor.error(tag.at, "the tag is not closed");
    Result<SvgAttribute> read = attribute(cursor);
    if (!read) return tl::unexpected(read.error());
    if (tag.find(read->name) != nullptr) return cursor.error(read->at, "an attribute is given twice");
    tag.attributes.push_back(*read);
  }
  (void)cursor.skipPast(">");
  return tag;
}

}  // namespace

const SvgAttribute* SvgTag::find(std::string_view attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [attribute](const SvgAttribute& a) { return a.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

Result<std::vector<SvgTag>> svgTags(std::string_view text, const std::string& fileName) {
  struct Skipped {
    std::string_view begin, end;
  };
  static constexpr Skipped kSkipped[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<!", ">"}, {"<?", "?>"}, {"</", ">"}};
  std::vector<SvgTag> tags;
  Cursor cursor{text, fileName};
  while ((cursor.at = text.find('<', cursor.at)) != std::string_view::npos) {
    const auto* skipped = std::find_if(std::begin(kSkipped), std::end(kSkipped),
                                       [&](const Skipped& s) { return cursor.startsWith(s.begin); });
    if (skipped != std::end(kSkipped)) {
      const size_t start = cursor.at;
      cursor.at += skipped->begin.size();
      if (!cursor.skipPast(skipped->end)) return cursor.error(start, fmt::format("'{}' is not closed", skipped->begin));
      continue;
    }
    Result<SvgTag> tag = startTag(cursor);
    if (!tag) return tl::unexpected(tag.error());
    tags.push_back(std::move(*tag));
  }
  return tags;
}

}  // namespace rasterdiff
