// Which rules decide a sample inside a point or a line. How often they did is counted by the renderer.
#pragma once

#include <array>
#include <span>

#include "rasterizer/geometry.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {

/// In no particular order, but for the shape's own rule (PointSquare, LineRectangle, LineBresenham), which is first.
class FigureRules {
 public:
  FigureRules(const Scene& scene, const Rules& rules, const Primitive& primitive, const Figure& figure);
  [[nodiscard]] std::span<const Rule> all() const& { return std::span(rules_).first(count_); }
  std::span<const Rule> all() const&& = delete;  // it would outlive them
  [[nodiscard]] Rule shape() const { return rules_[0]; }

 private:
  void add(Rule rule) { rules_[count_++] = rule; }
  std::array<Rule, 8> rules_{};
  size_t count_ = 0;
};

}  // namespace rasterdiff::rasterizer
