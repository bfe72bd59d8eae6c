// Good files made bad: bytes, numbers, lines and pieces of a text exchanged, doubled, left out, or put where others were.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/generators/prng.hpp"

namespace rasterdiff::test {

class MangledText {
 public:
  MangledText(std::vector<std::string> good, uint64_t seed) : good_(std::move(good)), random_(seed) {}

  /// One of the good texts after one to four changes.
  [[nodiscard]] std::string next();

 private:
  void change(std::string& text);
  [[nodiscard]] size_t place(const std::string& text) { return random_.below(text.size() + 1); }
  /// A number, word or sign of the text: where it begins and how long it is.
  [[nodiscard]] std::pair<size_t, size_t> token(const std::string& text);

  const std::vector<std::string> good_;
  Prng random_;
};

}  // namespace rasterdiff::test
