#include "harness/report/markup.hpp"

namespace rasterdiff::harness {
namespace {

/// Length of the well-formed UTF-8 sequence at `at`, 0 if there is none. Overlong forms of three and four bytes and
/// surrogates pass the lead byte; XML parsers refuse them, so they are excluded here.
size_t sequenceLength(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(at);
  const size_t length = lead < 0x80 ? 1 : lead >= 0xc2 && lead < 0xe0 ? 2 : (lead & 0xf0U) == 0xe0 ? 3
                        : lead >= 0xf0 && lead < 0xf5                ? 4
                                                                     : 0;
  if (length == 0 || at + length > text.size()) return 0;
  unsigned code = length == 1 ? lead : lead & (0x7fU >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80) return 0;
    code = code << 6 | (byte(at + i) & 0x3fU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return overlong || surrogate || code > 0x10ffff || code == 0xfffe || code == 0xffff ? 0 : length;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const size_t length = sequenceLength(text, at);
    const char c = text[at];
    if (length == 0) {
      out += '?';
    } else if (length > 1) {
      out += text.substr(at, length);
    } else {
      switch (c) {
        case '&': out += "&amp;"; break;
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '"': out += "&quot;"; break;
        case '\'': out += "&#39;"; break;
        default: out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
      }
    }
    at += length == 0 ? 1 : length;
  }
  return out;
}

}  // namespace rasterdiff::harness
