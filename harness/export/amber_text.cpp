#include "harness/export/amber_text.hpp"

#include <array>
#include <charconv>

namespace rasterdiff::harness {

std::string amberFloat(float value) {
  std::array<char, 64> buffer{};  // -3.4e38 has 39 digits and a sign, 1.4e-45 has 45 places
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  std::string text(buffer.data(), end);
  if (text.find('.') == std::string::npos) text += ".0";
  return text;
}

}  // namespace rasterdiff::harness
