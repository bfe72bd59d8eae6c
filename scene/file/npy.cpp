// The header is a Python literal of three known entries; everything else than these is refused with what was found.
#include "scene/file/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "scene/file/read_file.hpp"

namespace rasterdiff {
namespace {

static_assert(std::endian::native == std::endian::little, "the words of a file are swapped where it says '>'");

constexpr const char* kHint = "write it with numpy.save(FILE, array.astype('<f4')), one row a vertex";

struct Header {
  std::string descr;
  std::optional<bool> fortranOrder;
  std::optional<std::vector<uint64_t>> shape;
};

/// The part of Python's grammar that NumPy writes: {'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : text_(text) {}

  [[nodiscard]] std::optional<Header> parse() {
    Header header;
    if (!take('{')) return std::nullopt;
    while (!take('}')) {
      std::string key;
      if (!text(key) || !take(':') || !value(key, header)) return std::nullopt;
      if (!take(',') && peek() != '}') return std::nullopt;
    }
    skipSpace();
    if (!text_.empty() || header.descr.empty() || !header.fortranOrder || !header.shape) return std::nullopt;
    return header;
  }

 private:
  bool value(const std::string& key, Header& header) {
    if (key == "descr" && header.descr.empty()) return text(header.descr);
    if (key == "fortran_order" && !header.fortranOrder) {
      const bool isTrue = word("True");
      header.fortranOrder = isTrue;
      return isTrue || word("False");
    }
    return key == "shape" && !header.shape && tuple(header.shape.emplace());
  }

  bool text(std::string& out) {
    skipSpace();
    if (text_.empty() || (text_[0] != '\'' && text_[0] != '"')) return false;
    const size_t end = text_.find(text_[0], 1);
    if (end == std::string_view::npos) return false;
    out = text_.substr(1, end - 1);
    text_.remove_prefix(end + 1);
    return true;
  }

  bool tuple(std::vector<uint64_t>& out) {
    if (!take('(')) return false;
    while (!take(')')) {
      skipSpace();
      const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), out.emplace_back());
      if (error != std::errc{}) return false;
      text_.remove_prefix(static_cast<size_t>(end - text_.data()));
      if (!take(',') && peek() != ')') return false;
    }
    return true;
  }

  bool word(std::string_view word) {
    skipSpace();
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  char peek() {
    skipSpace();
    return text_.empty() ? '\0' : text_[0];
  }
  bool take(char c) {
    if (peek() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  void skipSpace() { text_.remove_prefix(std::min(text_.find_first_not_of(" \n"), text_.size())); }

  std::string_view text_;
};

}  // namespace

Result<NpyMatrix> NpyMatrix::parse(std::string bytes, const std::string& fileName) {
  const auto refuse = [&](std::string what) { return fail(ErrorCode::BadInput, fileName, std::move(what), kHint); };
  const std::string_view view(bytes);
  const auto byte = [&](size_t at) { return static_cast<uint8_t>(view[at]); };
  if (!view.starts_with("\x93NUMPY")) return refuse("is no .npy file: it does not start with \\x93NUMPY");
  if (view.size() < 10) return refuse("ends within its header");
  const unsigned major = byte(6), minor = byte(7);
  if (major < 1 || major > 3 || minor != 0) return refuse(fmt::format("is of .npy version {}.{}, not 1.0 to 3.0", major, minor));
  const size_t preamble = major == 1 ? 10 : 12;
  if (view.size() < preamble) return refuse("ends within its header");
  size_t length = byte(8) | size_t{byte(9)} << 8;
  if (major > 1) length |= size_t{byte(10)} << 16 | size_t{byte(11)} << 24;
  if (length > view.size() - preamble) return refuse("ends within its header");
  const std::optional<Header> header = HeaderParser(view.substr(preamble, length)).parse();
  if (!header) return refuse("has a header that NumPy does not write");

  const std::string& descr = header->descr;
  if (descr != "<f4" && descr != ">f4" && descr != "<f8" && descr != ">f8") {
    return refuse(fmt::format("holds '{}', not float32 or float64", descr.substr(0, 40)));
  }
  const std::vector<uint64_t>& shape = *header->shape;
  if (shape.size() != 2) return refuse(fmt::format("has {} dimensions, not rows and columns", shape.size()));
  const uint64_t size = descr[2] == '4' ? 4 : 8, held = view.size() - preamble - length;
  const bool fits = shape[0] == 0 || shape[1] == 0 || shape[0] <= held / size / shape[1];
  const uint64_t wanted = fits ? shape[0] * shape[1] * size : 0;
  if (!fits || wanted != held) {
    return refuse(fmt::format("{}: it holds {} bytes of numbers where {} × {} of {} bytes are announced",
                              fits ? "is too long" : "is truncated", held, shape[0], shape[1], size));
  }
  NpyMatrix matrix;
  matrix.data_ = preamble + length;
  matrix.bytes_ = std::move(bytes);
  matrix.rows_ = shape[0], matrix.columns_ = shape[1];
  matrix.wide_ = size == 8, matrix.swapped_ = descr[0] == '>', matrix.columnMajor_ = *header->fortranOrder;
  return matrix;
}

template <class Word>
Word NpyMatrix::word(size_t row, size_t column) const {
  const size_t index = columnMajor_ ? column * rows_ + row : row * columns_ + column;
  char bytes[sizeof(Word)];
  std::memcpy(bytes, bytes_.data() + data_ + index * sizeof(Word), sizeof(Word));
  if (swapped_) std::reverse(bytes, bytes + sizeof(Word));
  Word word;
  std::memcpy(&word, bytes, sizeof(Word));
  return word;
}

double NpyMatrix::at(size_t row, size_t column) const {
  return wide_ ? std::bit_cast<double>(word<uint64_t>(row, column)) : double{float32(row, column)};
}

float NpyMatrix::float32(size_t row, size_t column) const {
  return wide_ ? static_cast<float>(at(row, column)) : std::bit_cast<float>(word<uint32_t>(row, column));
}

Result<NpyMatrix> loadNpy(const std::string& path) {
  Result<std::string> bytes = readFile(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return NpyMatrix::parse(std::move(*bytes), path);
}

}  // namespace rasterdiff
