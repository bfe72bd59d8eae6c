// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace rasterdiff::harness {

/// & < > " ' as entities; control characters, which XML cannot hold, as spaces; bytes that are not UTF-8 as '?'.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace rasterdiff::harness
