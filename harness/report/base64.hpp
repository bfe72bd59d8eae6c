// Bytes as text: for pictures in records and data URIs. RFC 4648.
#pragma once

#include <string>
#include <string_view>

namespace rasterdiff::harness {

[[nodiscard]] std::string toBase64(std::string_view bytes);
/// The inverse; stops at the first character that is not of the alphabet.
[[nodiscard]] std::string fromBase64(std::string_view text);

}  // namespace rasterdiff::harness
