// Signs of sums that doubles cannot decide, against exact rationals.
#include "rasterizer/exact_sign.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>
#include <vector>

namespace rasterdiff::rasterizer {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int rationalSign(const std::vector<double>& terms) {
  Rational sum = 0;
  for (const double term : terms) sum += Rational(term);
  return sum.sign();
}

TEST(ExactSign, SeesWhatRoundingLoses) {
  EXPECT_EQ(exactSign(std::vector<double>{1e30, 1, -1e30}), 1);
  EXPECT_EQ(exactSign(std::vector<double>{1e30, -1, -1e30}), -1);
  EXPECT_EQ(exactSign(std::vector<double>{1, 0x1p-53, -1, -0x1p-53}), 0);
  EXPECT_EQ(exactSign(std::vector<double>{1, 0x1p-53, -1, -0x1p-54}), 1);
  EXPECT_EQ(exactSign(std::vector<double>{}), 0);
  EXPECT_EQ(exactSign(std::vector<double>{0.0, -0.0}), 0);
}

TEST(ExactSign, AgreesWithRationalsOnSumsThatNearlyCancel) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  int zeros = 0, wrongInDoubles = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<double> terms;
    const size_t half = 1 + random() % 7;
    for (size_t k = 0; k < half; ++k) terms.push_back(std::ldexp(mantissa(random), static_cast<int>(random() % 120) - 60));
    for (size_t k = 0; k < half; ++k) terms.push_back(-terms[k]);
    // Most sums are zero but for one last bit of one term, or a tiny term.
    if (i % 4 == 1) terms[random() % terms.size()] *= 1 + 0x1p-52;
    if (i % 4 == 2) terms.push_back(i % 8 == 2 ? 0x1p-200 : -0x1p-200);
    std::shuffle(terms.begin(), terms.end(), random);
    const int expected = rationalSign(terms);
    ASSERT_EQ(exactSign(terms), expected) << "sum " << i;
    double naive = 0;
    for (const double term : terms) naive += term;
    zeros += expected == 0 ? 1 : 0;
    wrongInDoubles += ((naive > 0) - (naive < 0)) != expected ? 1 : 0;
  }
  EXPECT_GT(zeros, 5000);
  EXPECT_GT(wrongInDoubles, 1000) << "otherwise the sums are too easy";
}

TEST(ExactSign, ProductsSplitIntoTwoDoublesExactly) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> factor(-1e6, 1e6);
  for (int i = 0; i < 2000; ++i) {
    const double a = factor(random), b = factor(random);
    double high = 0, low = 0;
    twoProduct(a, b, high, low);
    EXPECT_EQ(Rational(high) + Rational(low), Rational(a) * Rational(b));
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
