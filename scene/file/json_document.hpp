// JSON as a flat list of values that remember where in the text they stand. What they mean is the readers' business.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff {

enum class JsonKind : uint8_t { Null, Boolean, Integer, Number, String, Array, Object };

/// "a string", "an object", ... for messages.
[[nodiscard]] std::string_view describe(JsonKind kind);

class JsonDocument {
  struct Node {
    uint32_t offset = 0;
    uint32_t next = 0;  ///< index of the value behind this one and all that it holds
    uint32_t text = 0;  ///< String: index of its text; Array, Object: number of elements
    JsonKind kind = JsonKind::Null;
    double number = 0;
  };

 public:
  /// A value of a document; valid as long as the document stays where it is.
  class Value {
   public:
    [[nodiscard]] JsonKind kind() const { return node().kind; }
    [[nodiscard]] bool boolean() const { return node().number != 0; }
    /// Integer or Number. Integers beyond 2^53 are rounded.
    [[nodiscard]] double number() const { return node().number; }
    [[nodiscard]] const std::string& text() const { return document_->texts_[node().text]; }
    /// Members of an Object, elements of an Array.
    [[nodiscard]] uint32_t size() const { return node().text; }
    /// Array or Object: the first element's value or first member's key; then each one's `next()`.
    [[nodiscard]] Value first() const { return {document_, index_ + 1}; }
    /// The value behind this one; behind a key stands its value.
    [[nodiscard]] Value next() const { return {document_, node().next}; }
    /// Bytes from the start of the text.
    [[nodiscard]] size_t offset() const { return node().offset; }
    [[nodiscard]] std::optional<Value> member(std::string_view key) const;
    [[nodiscard]] std::optional<Value> element(uint32_t i) const;

   private:
    friend class JsonDocument;
    Value(const JsonDocument* document, uint32_t index) : document_(document), index_(index) {}
    [[nodiscard]] const Node& node() const { return document_->nodes_[index_]; }
    const JsonDocument* document_;
    uint32_t index_;
  };

  /// Deepest nesting, most values and most members of an object that are accepted.
  static constexpr uint32_t kMaxDepth = 64, kMaxValues = 1u << 25, kMaxMembers = 64;

  /// Error: BadInput with fileName:line:column: syntax, duplicate keys, the limits above, kMaxInputBytes.
  [[nodiscard]] static Result<JsonDocument> parse(std::string_view text, const std::string& fileName);

  [[nodiscard]] Value root() const { return {this, 0}; }

 private:
  friend class JsonBuilder;
  std::vector<Node> nodes_;
  std::vector<std::string> texts_;
};

/// "fileName:line:column" of a byte offset, both counted from 1, columns in UTF-8 characters.
[[nodiscard]] std::string textPosition(std::string_view text, size_t offset, const std::string& fileName);

}  // namespace rasterdiff
