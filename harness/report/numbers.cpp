#include "harness/report/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rasterdiff::harness {

std::string grouped(uint64_t number) {
  std::string text = std::to_string(number);
  for (size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

std::string counted(uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(number), noun, number == 1 ? "" : "s");
}

std::string ulps(double ulp) {
  if (!std::isfinite(ulp)) return "∞";
  if (ulp >= 1e7) return fmt::format("{:.1e}", ulp);
  if (ulp == std::floor(ulp)) return grouped(static_cast<uint64_t>(ulp));
  return fmt::format("{:.2f}", ulp);
}

std::string secondsText(double seconds) {
  if (seconds < 0.001) return fmt::format("{:.0f} µs", seconds * 1e6);
  if (seconds < 0.1) return fmt::format("{:.1f} ms", seconds * 1e3);
  if (seconds < 10) return fmt::format("{:.2f} s", seconds);
  if (seconds < 100) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<uint64_t>(std::llround(seconds));
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

std::string primitiveText(uint32_t primitive) {
  return primitive == 0 ? "none" : fmt::format("primitive {}", primitive);
}

std::string floatText(float value) { return fmt::format("{}", value); }

std::string shellQuoted(std::string_view word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:@%,=";
  const bool plain = !word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos;
  if (plain) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string oneLine(std::string_view text) {
  std::string line(text);
  std::replace_if(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return line;
}

}  // namespace rasterdiff::harness
