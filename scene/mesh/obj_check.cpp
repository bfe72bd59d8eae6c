#include "scene/mesh/obj_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <climits>
#include <cmath>
#include <vector>

namespace rasterdiff {
namespace {

struct Token {
  std::string_view text;
  size_t column = 1;
};

constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

void split(std::string_view line, std::vector<Token>& tokens) {
  tokens.clear();
  const auto end = line.end();
  for (auto at = std::find_if_not(line.begin(), end, isBlank); at != end; at = std::find_if_not(at, end, isBlank)) {
    const auto from = at;
    at = std::find_if(at, end, isBlank);
    tokens.push_back({std::string_view(from, at), static_cast<size_t>(from - line.begin()) + 1});
  }
}

/// Statements of the format (Wavefront's Advanced Visualizer manual, appendix B1, and two common extensions).
bool isStatement(std::string_view word) {
  constexpr std::array<std::string_view, 44> kWords{
      "v",      "vt",       "vn",       "vp",     "vw",         "f",         "l",     "p",     "o",    "g",    "s",
      "mg",     "usemtl",   "mtllib",   "usemap", "maplib",     "bevel",     "lod",   "t",     "deg",  "bmat", "step",
      "cstype", "c_interp", "d_interp", "trim",   "shadow_obj", "trace_obj", "curv",  "surf",  "parm", "hole", "scrv",
      "curv2",  "sp",       "end",      "con",    "call",       "csh",       "ctech", "stech", "res",  "bzp",  "bsp"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

bool isFiniteFloat(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto plainCharacter = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == 'E' || c == '+' || c == '-'; };
  const bool plain = !text.empty() && std::ranges::all_of(text, plainCharacter);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return plain && code == std::errc() && end == text.data() + text.size() && std::isfinite(static_cast<float>(value));
}

class Checker {
 public:
  explicit Checker(const std::string& fileName) : fileName_(fileName) {}

  Result<void> line(std::string_view text) {
    ++line_;
    split(text, tokens_);
    const std::vector<Token>& tokens = tokens_;
    if (tokens.empty() || tokens[0].text.starts_with('#')) return {};
    const std::string_view word = tokens[0].text;
    if (!isStatement(word)) {
      return bad(tokens[0].column, fmt::format("'{}' is no OBJ statement", printable(word)), "is this an OBJ file?");
    }
    if (word != "v" && word != "vn" && word != "f") return {};
    if (auto ok = word == "f" ? face(tokens) : numbers(tokens, word == "v"); !ok) return ok;
    for (const Token& token : tokens) kept_.append(token.text).append(" ");
    kept_.back() = '\n';
    return {};
  }

  Result<std::string> finish() {
    if (!deferred_.what.empty() && deferredVertex_ > vertices_) return tl::unexpected(deferred_);
    if (!deferredNormalError_.what.empty() && deferredNormal_ > normals_) return tl::unexpected(deferredNormalError_);
    if (faces_ == 0) return fail(ErrorCode::BadInput, fileName_, "the file has no faces", "only faces are drawn");
    return std::move(kept_);
  }

 private:
  static std::string printable(std::string_view word) {
    std::string out(word.substr(0, 40));
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return out;
  }

  Error error(size_t column, std::string what, std::string hint = {}) const {
    return {ErrorCode::BadInput, fmt::format("{}:{}:{}", fileName_, line_, column), std::move(what), std::move(hint)};
  }
  tl::unexpected<Error> bad(size_t column, std::string what, std::string hint = {}) const {
    return tl::unexpected(error(column, std::move(what), std::move(hint)));
  }

  /// v x y z [w] [r g b] and vn x y z.
  Result<void> numbers(const std::vector<Token>& tokens, bool position) {
    const size_t count = tokens.size() - 1, most = position ? 7 : 3;
    if (count < 3 || count > most) {
      return bad(tokens[0].column, fmt::format("'{}' with {} numbers", tokens[0].text, count), "three coordinates");
    }
    for (size_t i = 1; i < tokens.size(); ++i) {
      if (!isFiniteFloat(tokens[i].text)) {
        return bad(tokens[i].column, fmt::format("'{}' is no finite number", printable(tokens[i].text)));
      }
    }
    ++(position ? vertices_ : normals_);
    return {};
  }

  Result<void> face(const std::vector<Token>& tokens) {
    if (tokens.size() < 4) {
      return bad(tokens[0].column, fmt::format("a face with {} vertices", tokens.size() - 1), "three or more");
    }
    for (size_t i = 1; i < tokens.size(); ++i) {
      if (auto ok = corner(tokens[i]); !ok) return ok;
    }
    ++faces_;
    return {};
  }

  /// v, v/vt, v//vn or v/vt/vn.
  Result<void> corner(const Token& token) {
    std::array<std::string_view, 3> parts;
    std::string_view rest = token.text;
    size_t count = 0;
    for (;;) {
      if (count == 3) return bad(token.column, fmt::format("'{}' is no face vertex", printable(token.text)));
      const size_t slash = rest.find('/');
      parts[count++] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      rest.remove_prefix(slash + 1);
    }
    const bool textureLeftOut = count == 3 && parts[1].empty();
    for (size_t i = 0; i < count; ++i) {
      if (i == 1 && textureLeftOut) continue;
      if (auto ok = index(token, parts[i], i); !ok) return ok;
    }
    return {};
  }

  Result<void> index(const Token& token, std::string_view text, size_t part) {
    int value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || value == INT_MIN) {
      return bad(token.column, fmt::format("'{}' is no face vertex", printable(token.text)),
                 "like 3, 3/1, 3//2 or 3/1/2; lines cannot be continued with '\\'");
    }
    if (value == 0) return bad(token.column, "index 0", "OBJ counts from 1");
    if (part == 1) return {};  // texture coordinates are not used
    const int64_t defined = part == 0 ? vertices_ : normals_;
    const char* what = part == 0 ? "vertices" : "normals";
    if (value < 0) {
      if (-int64_t{value} <= defined) return {};
      return bad(token.column, fmt::format("index {} but only {} {} so far", value, defined, what));
    }
    // A face may stand before its vertices: the furthest reference is checked at the end.
    int64_t& furthest = part == 0 ? deferredVertex_ : deferredNormal_;
    if (value > defined && value > furthest) {
      furthest = value;
      (part == 0 ? deferred_ : deferredNormalError_) =
          error(token.column, fmt::format("index {} is beyond the last of the file's {}", value, what));
    }
    return {};
  }

  const std::string& fileName_;
  std::string kept_;
  std::vector<Token> tokens_;  // of the line
  size_t line_ = 0;
  int64_t vertices_ = 0, normals_ = 0, faces_ = 0;
  int64_t deferredVertex_ = 0, deferredNormal_ = 0;
  Error deferred_, deferredNormalError_;
};

}  // namespace

Result<std::string> checkedFaceLines(std::string_view text, const std::string& fileName) {
  if (text.find('\0') != std::string_view::npos) {
    return fail(ErrorCode::BadInput, fileName, "the file has NUL bytes: it is not plain text (UTF-16?)",
                "convert it to UTF-8");
  }
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Checker checker(fileName);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    if (auto ok = checker.line(text.substr(begin, end - begin)); !ok) return tl::unexpected(ok.error());
    begin = end + 1;
  }
  return checker.finish();
}

}  // namespace rasterdiff
