#include "rasterizer/lines/bresenham_rules.hpp"

#include <algorithm>
#include <vector>

#include "rasterizer/lines/bresenham_line.hpp"
#include "rasterizer/lines/end_box.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// A fragment of the thin line, or the first pixel of the column that stands for it; (major, minor).
struct Fragment {
  int64_t major = 0, minor = 0;
};

PixelIndex pixelOf(Fragment f, bool xMajor) {
  const auto major = static_cast<int32_t>(f.major), minor = static_cast<int32_t>(f.minor);
  return xMajor ? PixelIndex{major, minor} : PixelIndex{minor, major};
}

class Check {
 public:
  Check(std::span<const PixelIndex> pixels, const DiamondLine& line, int64_t width, const PixelArea& area)
      : line_(line), xMajor_(line.xMajor()), width_(width), pixels_(pixels.begin(), pixels.end()) {
    major_ = xMajor_ ? Range{area.left, area.right} : Range{area.top, area.bottom};
    minor_ = xMajor_ ? Range{area.top, area.bottom} : Range{area.left, area.right};
    std::sort(pixels_.begin(), pixels_.end(), [this](PixelIndex a, PixelIndex b) {
      return xMajor_ ? std::pair(a.x, a.y) < std::pair(b.x, b.y) : std::pair(a.y, a.x) < std::pair(b.y, b.x);
    });
  }

  [[nodiscard]] BresenhamFinding run() {
    BresenhamFinding finding = collectColumns();
    if (finding.fault == BresenhamFault::None) finding = compareFragments();
    return finding;
  }

 private:
  [[nodiscard]] Fragment at(PixelIndex p) const { return xMajor_ ? Fragment{p.x, p.y} : Fragment{p.y, p.x}; }
  [[nodiscard]] BresenhamFinding found(BresenhamFault fault, Fragment f) const { return {fault, pixelOf(f, xMajor_)}; }

  BresenhamFinding collectColumns() {
    for (size_t i = 0; i < pixels_.size();) {
      const Fragment first = at(pixels_[i]);
      int64_t last = first.minor;
      size_t next = i + 1;
      while (next < pixels_.size() && at(pixels_[next]).major == first.major) {
        if (at(pixels_[next]).minor != last + 1) return found(BresenhamFault::TwoInAColumn, at(pixels_[next]));
        last = at(pixels_[next++]).minor;
      }
      const int64_t height = last - first.minor + 1;
      const bool cutBelow = first.minor == minor_.low, cutAbove = last == minor_.high - 1;
      if (height > width_) return found(width_ == 1 ? BresenhamFault::TwoInAColumn : BresenhamFault::WrongWidth, first);
      if (height < width_ && !cutBelow && !cutAbove) return found(BresenhamFault::WrongWidth, first);
      ++columns_;
      // A column that the border cuts at its beginning is known by its end.
      if (!cutBelow || !cutAbove) bases_.push_back({first.major, cutBelow ? last - width_ + 1 : first.minor});
      i = next;
    }
    return {};
  }

  [[nodiscard]] BresenhamFinding compareFragments() const {
    int64_t certain = 0, possible = 0;  // columns of ideal fragments, wherever they legally are, that the area shows
    for (int64_t i = 0; i < line_.count(); ++i) {
      const Fragment f = at(line_.pixel(i));
      const Range major{f.major - 1, f.major + 1}, minor{f.minor - 1, f.minor + width_};
      if (major.low >= major_.low && major.high < major_.high && minor.low >= minor_.low && minor.high < minor_.high)
        ++certain;
      if (major.high >= major_.low && major.low < major_.high && minor.high >= minor_.low && minor.low < minor_.high)
        ++possible;
    }
    if (columns_ > possible + 1) return {BresenhamFault::TooMany, {}};
    if (columns_ < certain - 1) return {BresenhamFault::TooFew, {}};
    // One fragment more than there should be need not correspond to any.
    int64_t strays = 0;
    for (const Fragment& base : bases_) {
      if (isNearIdeal(base)) continue;
      if (++strays > 1 || columns_ <= certain) return found(BresenhamFault::TooFar, base);
    }
    return {};
  }

  [[nodiscard]] bool isNearIdeal(Fragment base) const {
    if (line_.count() == 0) return false;
    const Fragment first = at(line_.pixel(0)), last = at(line_.pixel(line_.count() - 1));
    const int64_t direction = last.major >= first.major ? 1 : -1;
    for (int64_t major = base.major - 1; major <= base.major + 1; ++major) {
      const int64_t i = (major - first.major) * direction;
      if (i < 0 || i >= line_.count()) continue;
      if (std::abs(at(line_.pixel(i)).minor - base.minor) <= 1) return true;
    }
    return false;
  }

  const DiamondLine& line_;
  bool xMajor_;
  int64_t width_;
  std::vector<PixelIndex> pixels_;
  Range major_, minor_;  ///< of the area; high is exclusive
  int64_t columns_ = 0;
  std::vector<Fragment> bases_;
};

}  // namespace

BresenhamFinding checkBresenhamPixels(std::span<const PixelIndex> pixels, const LineEnds& ends, const LineStyle& style,
                                      const Rules& rules) {
  const BresenhamWidth width = bresenhamWidth(style.width, rules.limits);
  const auto check = [&](SubpixelPosition a, SubpixelPosition b) {
    BresenhamFinding finding;
    for (const int64_t w : {width.other, width.nominal}) {
      const DiamondLine line = bresenhamLine(a, b, w, rules.choices.diamondExit);
      finding = Check(pixels, line, w, style.area).run();
      if (finding.fault == BresenhamFault::None) break;
    }
    return finding;
  };
  const BresenhamFinding nominal = check(ends.a.snapped, ends.b.snapped);
  if (nominal.fault == BresenhamFault::None) return nominal;
  bool explained = false;
  forEachPlacement(EndBox(ends.a), EndBox(ends.b), [&](int64_t ax, int64_t ay, int64_t bx, int64_t by) {
    if (explained) return;
    const SubpixelPosition a{static_cast<int32_t>(ax), static_cast<int32_t>(ay)};
    const SubpixelPosition b{static_cast<int32_t>(bx), static_cast<int32_t>(by)};
    explained = check(a, b).fault == BresenhamFault::None;
  });
  return explained ? BresenhamFinding{} : nominal;
}

}  // namespace rasterdiff::rasterizer
