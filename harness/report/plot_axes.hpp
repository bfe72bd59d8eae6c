// Logarithmic axes of the plots, and labels that keep out of each other's way.
#pragma once

#include <string>
#include <vector>

namespace rasterdiff::harness {

/// Decades from below the smallest to above the largest value, over a stretch of the page.
class LogAxis {
 public:
  /// `from`, `to`: where the axis begins and ends, user units. No values: one decade.
  LogAxis(const std::vector<double>& values, double from, double to);
  [[nodiscard]] double at(double value) const;
  /// Powers of ten, every second or third one where there are many.
  [[nodiscard]] std::vector<double> ticks() const;

 private:
  double low_ = 0, high_ = 1;  ///< exponents
  double from_, to_;
};

/// "1", "100", "10k", "1M", "10⁻³".
[[nodiscard]] std::string tickText(double value);

/// Heights of labels one above the other, as near to `wanted` (ascending) as the spacing allows, within [low, high].
[[nodiscard]] std::vector<double> spread(std::vector<double> wanted, double spacing, double low, double high);

/// Finds a place for a label of `text` beside (x, y); remembers all places.
class LabelPlacer {
 public:
  LabelPlacer(double left, double top, double right, double bottom) : left_(left), top_(top), right_(right), bottom_(bottom) {}
  struct Place {
    double x, y;       ///< of the text's base line
    bool toLeft;       ///< the text ends at x
    bool moved;        ///< far enough from its point to need a line to it
  };
  void avoid(double x, double y);  ///< a point is here
  void avoid(double x, double y, const std::string& text);  ///< a label is here, from x on, about y
  [[nodiscard]] Place place(double x, double y, const std::string& text);

 private:
  struct Box {
    double left, top, right, bottom;
  };
  [[nodiscard]] bool isFree(const Box& box) const;
  double left_, top_, right_, bottom_;
  std::vector<Box> taken_;
};

}  // namespace rasterdiff::harness
