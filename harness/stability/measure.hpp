// How far each way of drawing is from the exact answer on the families: kernels and textbook methods of coverage and
// interpolation, the reference's own path, and a driver.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/stability/families.hpp"
#include "harness/subject.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::harness::stability {

struct Point {
  double dial = 0;
  uint64_t cases = 0;      ///< covered samples, or values
  uint64_t wrong = 0;      ///< samples whose coverage is wrong; of a driver's values: those outside of their interval
  double maxUlp = 0;       ///< of finite values
  uint64_t notFinite = 0;  ///< values
  bool offered = true;     ///< the driver can draw it at all (large targets)
};

struct Series {
  std::string family, method;
  bool values = false;  ///< of values; else of coverage
  bool judged = false;  ///< a driver's: `wrong` is the verdict's, freedoms are not counted
  std::vector<Point> points{};
};

/// Methods lose half of float32's 24 bits here.
inline constexpr double kLostUlp = 4096;

[[nodiscard]] bool isBroken(const Series& series, const Point& point);
/// The first value of the dial at which the method breaks: wrong coverage, values that are not finite, and values outside
/// of their interval (of drivers) or more than kLostUlp off (of methods). None if it never does.
[[nodiscard]] std::optional<double> breaksAt(const Series& series);

/// The reference (in ULPs against extended precision, on the same unsnapped corners) and all methods, for one family.
[[nodiscard]] std::vector<Series> measureMethods(const Family& family);

/// A driver under its rules: coverage and values. Error: the driver's own.
[[nodiscard]] Result<std::vector<Series>> measureDriver(const Family& family, Subject& subject, const rasterizer::Rules& rules);

}  // namespace rasterdiff::harness::stability
