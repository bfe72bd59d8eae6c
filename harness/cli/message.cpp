#include "harness/cli/message.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rasterdiff::harness::cli {

int exitStatusOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadInput:
    case ErrorCode::Io: return 2;
    case ErrorCode::NoDevice:
    case ErrorCode::NotOffered: return 3;
    case ErrorCode::DeviceLost:
    case ErrorCode::TimedOut: return 4;
  }
  return 2;
}

std::string nextCommand(const Error& error, std::string_view verb) {
  if (exitStatusOf(error.code) != 2) return "rasterdiff devices";
  if (error.hint.starts_with("rasterdiff ")) return error.hint;
  return fmt::format("rasterdiff {} --help", verb);
}

int complain(const Error& error, std::string_view next) {
  const std::string place = error.where.empty() ? "rasterdiff" : error.where;
  fmt::print(stderr, "{}: {}\n", place, error.what);
  if (!error.hint.empty() && error.hint != next) fmt::print(stderr, "hint: {}\n", error.hint);
  if (!next.empty()) fmt::print(stderr, "{}\n", next);
  return exitStatusOf(error.code);
}

}  // namespace rasterdiff::harness::cli
