// The 113-bit values that the kernels are judged by are the exact rationals, rounded once.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "rasterizer/kernels/value_oracle.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::oracle {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using rasterizer::SnappedTriangle;

Rational weight(SubpixelPosition a, SubpixelPosition b, SubpixelPosition c) {
  return (Rational(b.x) - a.x) * (Rational(c.y) - a.y) - (Rational(b.y) - a.y) * (Rational(c.x) - a.x);
}

Rational rational(const SnappedTriangle& t, SubpixelPosition p, const std::array<float, 3>& values, const std::array<float, 3>& w) {
  const std::array<Rational, 3> b{weight(p, t.v[1], t.v[2]), weight(t.v[0], p, t.v[2]), weight(t.v[0], t.v[1], p)};
  Rational numerator = 0, denominator = 0;
  for (size_t i = 0; i < 3; ++i) {
    numerator += b[i] * Rational(values[i]) * Rational(w[i]);
    denominator += b[i] * Rational(w[i]);
  }
  return numerator / denominator;
}

TEST(ExactValue, IsTheRationalRoundedToDouble) {
  rasterdiff::Prng random(41);
  const auto roundedOnce = [](double value, const Rational& exact) {
    const Rational error = abs(Rational(value) - exact);
    return error <= abs(exact) * Rational(0x1p-53) * Rational(1.0 + 0x1p-40);
  };
  int tried = 0;
  while (tried < 4000) {
    const int32_t reach = tried % 2 == 0 ? 3000 : 1 << 22;
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = {random.between(-reach, reach), random.between(-reach, reach)};
    if (weight(t.v[0], t.v[1], t.v[2]) == 0) continue;
    // A point inside, so that no denominator is zero.
    const SubpixelPosition p{static_cast<int32_t>((int64_t{t.v[0].x} + t.v[1].x + t.v[2].x) / 3),
                             static_cast<int32_t>((int64_t{t.v[0].y} + t.v[1].y + t.v[2].y) / 3)};
    std::array<float, 3> values{}, w{};
    for (size_t i = 0; i < 3; ++i) {
      values[i] = static_cast<float>(random.between(-1.0, 1.0));
      w[i] = static_cast<float>(random.between(0.01, 1.0));
    }
    ++tried;
    EXPECT_TRUE(roundedOnce(exactValue(t, p, values), rational(t, p, values, {1, 1, 1})));
    const Rational perspective = rational(t, p, values, w);
    EXPECT_TRUE(roundedOnce(exactPerspectiveValue(t, p, values, w), perspective));
  }
}

}  // namespace
}  // namespace rasterdiff::oracle
