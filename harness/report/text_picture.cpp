#include "harness/report/text_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

namespace rasterdiff::harness {
namespace {

constexpr uint32_t kAcross = 7, kDown = 4;  ///< pixels shown on each side of the asked one

/// A letter for each primitive, in drawing order; '+' for those beyond the alphabet.
class Letters {
 public:
  void add(uint32_t primitive) {
    if (primitive != 0) letter_.try_emplace(primitive, '+');
  }

  void assign() {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    size_t next = 0;
    for (auto& [primitive, letter] : letter_) {
      if (next < kLetters.size()) letter = kLetters[next++];
    }
  }

  [[nodiscard]] char of(uint32_t primitive) const { return primitive == 0 ? '.' : letter_.at(primitive); }

  [[nodiscard]] std::vector<std::string> legend() const {
    std::vector<std::string> words{". none"};
    size_t others = 0;
    for (const auto& [primitive, letter] : letter_) {
      if (letter == '+') {
        ++others;
      } else {
        words.push_back(fmt::format("{} primitive {}", letter, primitive));
      }
    }
    if (others > 0) words.push_back(fmt::format("+ {} others", others));
    return words;
  }

 private:
  std::map<uint32_t, char> letter_;
};

std::string withoutTrailingSpaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// Words with commas between them, folded at 100 columns and indented by 8.
std::string folded(const std::vector<std::string>& words) {
  constexpr size_t kWidth = 100;
  std::string text, line(8, ' ');
  for (size_t i = 0; i < words.size(); ++i) {
    if (line.size() > 8 && line.size() + words[i].size() > kWidth) {
      text += withoutTrailingSpaces(line) + "\n";
      line.assign(8, ' ');
    }
    line += words[i] + (i + 1 < words.size() ? ", " : "");
  }
  return text + line + "\n";
}

}  // namespace

std::string textPicture(const Frame& reference, const Frame* actual, Place place) {
  const uint32_t x0 = place.x - std::min(place.x, kAcross), x1 = std::min(place.x + kAcross, reference.width - 1);
  const uint32_t y0 = place.y - std::min(place.y, kDown), y1 = std::min(place.y + kDown, reference.height - 1);
  const size_t width = 3 * size_t{x1 - x0 + 1};
  Letters letters;
  for (uint32_t y = y0; y <= y1; ++y) {
    for (uint32_t x = x0; x <= x1; ++x) {
      letters.add(reference.primitive.at(x, y, place.sample));
      if (actual) letters.add(actual->primitive.at(x, y, place.sample));
    }
  }
  letters.assign();
  bool open = false, differs = false;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{:>8}{:<{}}{}\n", "", "reference", actual ? width + 4 : 0, actual ? "driver" : "");
  for (uint32_t y = y0; y <= y1; ++y) {
    std::string left, right;
    for (uint32_t x = x0; x <= x1; ++x) {
      const bool asked = x == place.x && y == place.y;
      const uint32_t expected = reference.primitive.at(x, y, place.sample);
      const bool either = reference.coverage && reference.coverage->at(x, y, place.sample) == Coverage::Either;
      open = open || either;
      left += fmt::format("{}{}{}", asked ? '[' : ' ', either ? '?' : letters.of(expected), asked ? ']' : ' ');
      if (!actual) continue;
      const uint32_t got = actual->primitive.at(x, y, place.sample);
      differs = differs || got != expected;
      right += fmt::format("{}{}{}", asked ? '[' : ' ', letters.of(got), asked ? ']' : got != expected ? '*' : ' ');
    }
    text += withoutTrailingSpaces(fmt::format("{:>6}  {}    {}", y, left, right)) + "\n";
  }
  std::vector<std::string> legend = letters.legend();
  legend.front() = fmt::format("columns {} to {}: {}", x0, x1, legend.front());
  if (open) legend.emplace_back("? either is legal");
  if (differs) legend.emplace_back("* not the reference's own answer");
  return text + folded(legend);
}

}  // namespace rasterdiff::harness
