#include "harness/cli/driver_range.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <charconv>
#include <optional>

#include "rasterizer/deliberate_error.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr std::string_view kMutant = "mutant:", kDots = "..";
constexpr uint64_t kMostDrivers = 10'000;

bool isNumbered(std::string_view driver) { return driver.starts_with("legal:") || driver.starts_with("synthetic:"); }

std::optional<uint64_t> number(std::string_view text) {
  uint64_t value = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (wrong != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Result<std::vector<std::string>> numbered(const std::string& driver) {
  const size_t colon = driver.find(':'), dots = driver.find(kDots);
  const std::string_view text(driver);
  const auto first = number(text.substr(colon + 1, dots - colon - 1)), last = number(text.substr(dots + kDots.size()));
  if (!first || !last || *last < *first || *last - *first >= kMostDrivers) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("'{}' is no range of at most {} numbers", text.substr(colon + 1), kMostDrivers),
                "as in legal:1..100");
  }
  std::vector<std::string> names;
  for (uint64_t i = *first; i <= *last; ++i) names.push_back(fmt::format("{}:{}", text.substr(0, colon), i));
  return names;
}

Result<std::vector<std::string>> mutants(const std::string& driver) {
  std::vector<std::string> names;
  for (const rasterizer::DeliberateErrorInfo& error : rasterizer::deliberateErrors()) {
    std::string name = std::string(kMutant) + std::string(error.name);
    if (fnmatch(driver.c_str(), name.c_str(), 0) == 0) names.push_back(std::move(name));
  }
  if (names.empty()) {
    return fail(ErrorCode::BadInput, "--driver", fmt::format("no deliberate error matches '{}'", driver.substr(kMutant.size())),
                "rasterdiff list --mutants");
  }
  return names;
}

}  // namespace

bool namesSeveral(std::string_view driver) {
  if (driver.starts_with(kMutant)) return driver.find_first_of("*?[") != std::string_view::npos;
  return isNumbered(driver) && driver.find(kDots) != std::string_view::npos;
}

Result<std::vector<std::string>> driversNamed(const std::string& driver) {
  if (!namesSeveral(driver)) return std::vector<std::string>{driver};
  return driver.starts_with(kMutant) ? mutants(driver) : numbered(driver);
}

}  // namespace rasterdiff::harness::cli
