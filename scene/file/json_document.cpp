#include "scene/file/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/file/read_file.hpp"

namespace rasterdiff {

/// Receives nlohmann's SAX events and walks the text in step with them: the events come in the order of the tokens, so
/// that each one's place follows from where the last one ended.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonBuilder(std::string_view text, const std::string& fileName) : text_(text), fileName_(fileName) {
    if (text_.starts_with("\xef\xbb\xbf")) cursor_ = 3;
  }

  bool null() override { return scalar(JsonKind::Null, 0); }
  bool boolean(bool value) override { return scalar(JsonKind::Boolean, value ? 1 : 0); }
  bool number_integer(number_integer_t value) override {  // negative ones; -0 keeps its sign
    return scalar(JsonKind::Integer, value == 0 ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(JsonKind::Integer, static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return scalar(JsonKind::Number, value); }
  bool binary(binary_t&) override { return refuse(cursor_, "binary values are no JSON"); }

  bool string(string_t& value) override {
    if (!scalar(JsonKind::String, 0)) return false;
    keepText(value);
    return true;
  }
  bool start_object(std::size_t) override { return open(JsonKind::Object); }
  bool start_array(std::size_t) override { return open(JsonKind::Array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    const uint32_t object = open_.back();
    if (!scalar(JsonKind::String, 0)) return false;
    const size_t at = document_.nodes_.back().offset;
    keepText(value);
    for (uint32_t i = object + 1, n = 1; n < document_.nodes_[object].text; ++n) {
      if (document_.texts_[document_.nodes_[i].text] == value) {
        return refuse(at, fmt::format("a second field '{}'", value), "remove one of them");
      }
      i = document_.nodes_[i + 1].next;
    }
    if (document_.nodes_[object].text > JsonDocument::kMaxMembers) {
      return refuse(at, fmt::format("an object with more than {} fields", JsonDocument::kMaxMembers));
    }
    keyPending_ = true;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& exception) override {
    size_t at = nextToken();
    std::string_view what = exception.what();
    if (what.find("invalid string") != std::string_view::npos && position > at) at = position - 1;
    if (const size_t begin = what.find("syntax error"); begin != std::string_view::npos) {
      what.remove_prefix(begin);
    } else if (const size_t end = what.find("] "); end != std::string_view::npos) {
      what.remove_prefix(end + 2);
    }
    const bool blank = text_.find_first_not_of(" \t\r\n") == std::string_view::npos;
    return refuse(std::min(at, text_.size()), blank ? "the file is empty" : std::string(what),
                  blank ? "a scene file is a JSON object with target and draws" : "");
  }

  JsonDocument document_;
  Error error_;

 private:
  /// Past blanks and one separator.
  [[nodiscard]] size_t nextToken() const {
    const auto skipBlanks = [&](size_t at) { return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size()); };
    size_t at = skipBlanks(cursor_);
    if (at < text_.size() && (text_[at] == ',' || text_[at] == ':')) at = skipBlanks(at + 1);
    return at;
  }

  /// Of a token that the lexer has accepted.
  [[nodiscard]] size_t tokenEnd(size_t begin) const {
    switch (text_[begin]) {
      case '{':
      case '}':
      case '[':
      case ']':
        return begin + 1;
      case 't':
      case 'n':
        return begin + 4;
      case 'f':
        return begin + 5;
      case '"':
        break;
      default:
        return numberEnd(begin);
    }
    size_t at = begin + 1;
    while (text_[at] != '"') at += text_[at] == '\\' ? 2u : 1u;
    return at + 1;
  }

  [[nodiscard]] size_t numberEnd(size_t at) const {
    const auto skip = [&](std::string_view set, size_t most) {
      for (; most > 0 && at < text_.size() && set.find(text_[at]) != std::string_view::npos; --most) ++at;
    };
    constexpr std::string_view kDigits = "0123456789";
    constexpr size_t kAny = std::string_view::npos;
    skip("-", 1);
    skip(kDigits, at < text_.size() && text_[at] == '0' ? 1 : kAny);
    for (const auto& [mark, sign] : {std::pair{".", ""}, std::pair{"eE", "+-"}}) {
      const size_t before = at;
      skip(mark, 1);
      if (at == before) continue;
      skip(sign, 1);
      skip(kDigits, kAny);
    }
    return at;
  }

  bool refuse(size_t offset, std::string what, std::string hint = {}) {
    error_ = {ErrorCode::BadInput, textPosition(text_, offset, fileName_), std::move(what), std::move(hint)};
    return false;
  }

  bool add(JsonKind kind, double number) {
    const size_t begin = nextToken();
    if (document_.nodes_.size() >= JsonDocument::kMaxValues) {
      return refuse(begin, fmt::format("more than {} values", JsonDocument::kMaxValues),
                    "put large geometry into an OBJ mesh");
    }
    cursor_ = tokenEnd(begin);
    // A key and its value are one member: only the key is counted.
    if (!open_.empty() && !keyPending_) ++document_.nodes_[open_.back()].text;
    keyPending_ = false;
    document_.nodes_.push_back({static_cast<uint32_t>(begin), 0, 0, kind, number});
    return true;
  }

  bool scalar(JsonKind kind, double number) {
    if (!add(kind, number)) return false;
    document_.nodes_.back().next = static_cast<uint32_t>(document_.nodes_.size());
    return true;
  }

  void keepText(std::string& value) {
    document_.nodes_.back().text = static_cast<uint32_t>(document_.texts_.size());
    document_.texts_.push_back(value);
  }

  bool open(JsonKind kind) {
    if (open_.size() >= JsonDocument::kMaxDepth) {
      return refuse(nextToken(), fmt::format("nested more than {} deep", JsonDocument::kMaxDepth));
    }
    if (!add(kind, 0)) return false;
    open_.push_back(static_cast<uint32_t>(document_.nodes_.size() - 1));
    return true;
  }

  bool close() {
    cursor_ = tokenEnd(nextToken());
    document_.nodes_[open_.back()].next = static_cast<uint32_t>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& fileName_;
  size_t cursor_ = 0;
  std::vector<uint32_t> open_;
  bool keyPending_ = false;
};

Result<JsonDocument> JsonDocument::parse(std::string_view text, const std::string& fileName) {
  if (text.size() > kMaxInputBytes) {
    return fail(ErrorCode::BadInput, fileName, fmt::format("the text is larger than {} MiB", kMaxInputBytes >> 20),
                "split it, or put large geometry into an OBJ mesh");
  }
  JsonBuilder builder(text, fileName);
  try {
    if (!nlohmann::json::sax_parse(text, &builder)) return tl::unexpected(std::move(builder.error_));
  } catch (const std::exception& e) {
    return fail(ErrorCode::BadInput, fileName, std::string("the JSON parser failed: ") + e.what());
  }
  return std::move(builder.document_);
}

std::optional<JsonDocument::Value> JsonDocument::Value::member(std::string_view key) const {
  if (kind() != JsonKind::Object) return std::nullopt;
  Value at = first();
  for (uint32_t i = 0; i < size(); ++i, at = at.next().next()) {
    if (at.text() == key) return at.next();
  }
  return std::nullopt;
}

std::optional<JsonDocument::Value> JsonDocument::Value::element(uint32_t i) const {
  if (kind() != JsonKind::Array || i >= size()) return std::nullopt;
  Value at = first();
  while (i-- > 0) at = at.next();
  return at;
}

std::string_view describe(JsonKind kind) {
  switch (kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Boolean:
      return "a boolean";
    case JsonKind::Integer:
      return "an integer";
    case JsonKind::Number:
      return "a number";
    case JsonKind::String:
      return "a string";
    case JsonKind::Array:
      return "an array";
    case JsonKind::Object:
      return "an object";
  }
  return "a value";
}

std::string textPosition(std::string_view text, size_t offset, const std::string& fileName) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const size_t lineBegin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const std::string_view inLine = before.substr(lineBegin);
  const auto isCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return fmt::format("{}:{}:{}", fileName, line, std::count_if(inLine.begin(), inLine.end(), isCharacter) + 1);
}

}  // namespace rasterdiff
