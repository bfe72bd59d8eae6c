#include "tests/fuzz/mangled_text.hpp"

#include <array>
#include <cctype>

namespace rasterdiff::test {
namespace {

constexpr std::array<std::string_view, 28> kTroublesome{
    "0",    "-0",    "-1",    "1e999", "-1e999", "1e-999", "NaN",  "Infinity", "2147483648", "4294967295", "4294967296", "18446744073709551616", "0.5", "\"0x1p-149\"",
    "null", "true",  "{}",    "[]",    "\"\"",   "\"1\"",  "[[1]]", "\\u0000",  "\xff",       "\"\xc3\"",   ",",          "1e38",                 "16384", "0x"};

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_' || c == '+'; }

}  // namespace

std::pair<size_t, size_t> MangledText::token(const std::string& text) {
  size_t begin = random_.below(text.size());
  if (!isWord(text[begin])) return {begin, 1};
  while (begin > 0 && isWord(text[begin - 1])) --begin;
  size_t end = begin;
  while (end < text.size() && isWord(text[end])) ++end;
  return {begin, end - begin};
}

void MangledText::change(std::string& text) {
  if (text.empty()) {
    text = good_.front();
    return;
  }
  const auto [at, length] = token(text);
  switch (random_.below(9)) {
    case 0: text[at] = static_cast<char>(random_.below(256)); break;
    case 1: text.erase(at, length); break;
    case 2: text.replace(at, length, kTroublesome[random_.below(kTroublesome.size())]); break;
    case 3: text.insert(at, text.substr(at, length)); break;
    case 4: text.resize(at); break;
    case 5: text.insert(place(text), text.substr(at, random_.below(200))); break;
    case 6: text.erase(at, random_.below(60)); break;
    case 7: {
      const std::string& other = good_[random_.below(good_.size())];
      text.insert(at, other.substr(place(other), random_.below(100)));
      break;
    }
    default: {
      const auto [from, size] = token(text);
      const std::string word = text.substr(from, size);
      text.replace(at, length, word);
      break;
    }
  }
}

std::string MangledText::next() {
  std::string text = good_[random_.below(good_.size())];
  for (uint32_t changes = 1 + random_.below(4); changes > 0; --changes) change(text);
  return text;
}

}  // namespace rasterdiff::test
