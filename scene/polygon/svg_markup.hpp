// Just enough markup to walk over the start tags of an SVG text: names and attributes with their places. Trees,
// entities and name spaces are left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff {

struct SvgAttribute {
  std::string_view name, value;
  size_t at = 0;  ///< offset of the value in the text
};

struct SvgTag {
  std::string_view name;  ///< without a name-space prefix
  std::vector<SvgAttribute> attributes;
  size_t at = 0;  ///< offset of '<'

  [[nodiscard]] const SvgAttribute* find(std::string_view attribute) const;
};

/// Start tags and empty-element tags in order; comments, CDATA, declarations, processing instructions and end tags are
/// passed over. Error: BadInput with `where` "fileName:line:column".
[[nodiscard]] Result<std::vector<SvgTag>> svgTags(std::string_view text, const std::string& fileName);

}  // namespace rasterdiff
