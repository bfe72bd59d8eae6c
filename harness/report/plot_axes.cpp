#include "harness/report/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rasterdiff::harness {
namespace {

constexpr double kLetter = 6.3, kLine = 12;  // width and height of a letter of the labels, user units

}  // namespace

LogAxis::LogAxis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  low_ = std::floor(std::log10(*low) + 1e-9);
  high_ = std::ceil(std::log10(*high) - 1e-9);
  if (high_ <= low_) high_ = low_ + 1;
}

double LogAxis::at(double value) const { return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_); }

std::vector<double> LogAxis::ticks() const {
  const double decades = high_ - low_;
  const double step = std::max(1.0, std::ceil(decades / 7));
  std::vector<double> values;
  for (double e = low_; e <= high_ + 1e-9; e += step) values.push_back(std::pow(10.0, e));
  return values;
}

std::string tickText(double value) {
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  if (exponent >= 0 && exponent < 12) {
    constexpr const char* kUnits[] = {"", "k", "M", "G"};
    return fmt::format("{:.0f}{}", std::pow(10.0, exponent % 3), kUnits[exponent / 3]);
  }
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

std::vector<double> spread(std::vector<double> wanted, double spacing, double low, double high) {
  // Runs of labels that touch share their shift: each run lies about the mean of what its labels want.
  struct Group {
    double sum = 0;  ///< of the wanted heights, each less what stands before it in the run
    size_t size = 0;
    [[nodiscard]] double start() const { return sum / static_cast<double>(size); }
  };
  std::vector<Group> groups;
  const auto startOf = [&](const Group& group) {
    const double length = spacing * static_cast<double>(group.size - 1);
    return std::max(low, std::min(group.start(), high - length));
  };
  for (const double y : wanted) {
    groups.push_back({y, 1});
    while (groups.size() > 1) {
      const Group last = groups.back();
      Group& before = groups[groups.size() - 2];
      const double end = startOf(before) + spacing * static_cast<double>(before.size);
      if (startOf(last) >= end) break;
      before.sum += last.sum - spacing * static_cast<double>(before.size * last.size);
      before.size += last.size;
      groups.pop_back();
    }
  }
  std::vector<double> placed;
  for (const Group& group : groups)
    for (size_t i = 0; i < group.size; ++i) placed.push_back(startOf(group) + spacing * static_cast<double>(i));
  return placed;
}

void LabelPlacer::avoid(double x, double y, const std::string& text) {
  taken_.push_back({x, y - kLine / 2, x + kLetter * static_cast<double>(text.size()), y + kLine / 2});
}

void LabelPlacer::avoid(double x, double y) { taken_.push_back({x - 4, y - 4, x + 4, y + 4}); }

bool LabelPlacer::isFree(const Box& box) const {
  if (box.left < left_ || box.right > right_ || box.top < top_ || box.bottom > bottom_) return false;
  return std::ranges::none_of(taken_, [&](const Box& other) {
    return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
  });
}

LabelPlacer::Place LabelPlacer::place(double x, double y, const std::string& text) {
  constexpr double kGap = 7;
  const double width = kLetter * static_cast<double>(text.size());
  const auto boxAt = [&](double dy, bool toLeft, double gap) {
    const double edge = toLeft ? x - gap : x + gap;
    return Box{toLeft ? edge - width : edge, y + dy - kLine / 2, toLeft ? edge : edge + width, y + dy + kLine / 2};
  };
  Box box = boxAt(0, false, kGap);
  bool left = false, moved = false;
  for (int step = 0; step < 90; ++step) {
    const double dy = (step % 2 == 0 ? 1 : -1) * ((step + 1) / 2) * 6.0, gap = step == 0 ? kGap : kGap + 9;
    const bool rightIsFree = isFree(boxAt(dy, false, gap));
    if (!rightIsFree && !isFree(boxAt(dy, true, gap))) continue;
    left = !rightIsFree;
    moved = step > 0;
    box = boxAt(dy, left, gap);
    break;
  }
  taken_.push_back(box);
  return {left ? box.right : box.left, box.bottom - 2, left, moved};
}

}  // namespace rasterdiff::harness
