// A strict look at the lines of an OBJ file, so that every mistake has a line and column and tinyobjloader, which
// reads broken numbers as zero and does not check ranges, only ever sees sound text.
#pragma once

#include <string>
#include <string_view>

#include "scene/result.hpp"

namespace rasterdiff {

/// The lines of `text` that describe faces (v, vn, f), each checked: number formats, finite float32, index ranges
/// (also of indices relative to the end), at least three vertices a face, at least one face.
/// Errors (BadInput) have `where` = fileName:line:column.
[[nodiscard]] Result<std::string> checkedFaceLines(std::string_view text, const std::string& fileName);

}  // namespace rasterdiff
