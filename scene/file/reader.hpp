// Typed access to JSON values: the first thing that does not fit becomes the error, with its place in the text.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file/enum_names.hpp"
#include "scene/file/json_document.hpp"
#include "scene/result.hpp"

namespace rasterdiff {

using JsonValue = JsonDocument::Value;

/// Functions return false once something is wrong; `error()` then has the first mistake.
class Reader {
 public:
  Reader(std::string_view text, const std::string& fileName) : text_(text), fileName_(fileName) {}

  bool fail(size_t offset, std::string what, std::string hint = {}, ErrorCode code = ErrorCode::BadInput);
  bool fail(const JsonValue& value, std::string what, std::string hint = {}) {
    return fail(value.offset(), std::move(what), std::move(hint));
  }
  [[nodiscard]] const Error& error() const { return *error_; }
  /// Where byte `at` of a string's text stands in the file; the string itself where escapes are in the way.
  [[nodiscard]] size_t offsetInText(const JsonValue& value, size_t at) const;

  /// `value` is an object and has no fields but `known`; a missing one of `required` is an error.
  bool object(const JsonValue& value, std::string_view what, std::span<const std::string_view> known,
              std::initializer_list<std::string_view> required = {});
  bool array(const JsonValue& value, std::string_view what);

  bool text(const JsonValue& value, std::string& out);
  bool boolean(const JsonValue& value, bool& out);
  bool unsigned32(const JsonValue& value, uint32_t& out);
  bool signed32(const JsonValue& value, int32_t& out);
  /// A finite number, decimal or hex float.
  bool number(const JsonValue& value, double& out);
  /// A number rounded to float32; "nan" and "inf" strings only with `nonFinite`.
  bool float32(const JsonValue& value, float& out, bool nonFinite = false);
  /// An array of `least` to `most` numbers, in order.
  bool numbers(const JsonValue& value, std::string_view what, uint32_t least, uint32_t most, std::vector<double>& out);

  template <class E>
  bool enumerant(const JsonValue& value, std::string_view what, E& out) {
    std::string name;
    if (!text(value, name)) return false;
    std::vector<std::string_view> names;
    for (const EnumName<E>& entry : enumNames<E>()) {
      if (entry.name == name) {
        out = entry.value;
        return true;
      }
      names.push_back(entry.name);
    }
    return fail(value, fmt::format("'{}' is no {}", name, what), suggest(name, names));
  }

  /// "did you mean 'width'?" if one of `known` is near, else "one of ...".
  [[nodiscard]] static std::string suggest(std::string_view name, std::span<const std::string_view> known);

 private:
  bool expected(const JsonValue& value, std::string_view what);
  bool integer(const JsonValue& value, double least, double most, double& out);
  std::string_view text_;
  const std::string& fileName_;
  std::optional<Error> error_;
};

}  // namespace rasterdiff
