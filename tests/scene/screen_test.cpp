// Pixels and back, and the lecture's derivation of perspective-correct interpolation.
#include "scene/camera/screen.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/generators/prng.hpp"

namespace rasterdiff {
namespace {

/// [vk:vertexpostproc-viewport] in float32, each operation rounded, by the reciprocal of w as drivers do.
float viewportFloat32(float clip, float w, float extent, float origin) {
  const float reciprocal = 1.0f / w;
  const float ndc = clip * reciprocal, half = extent * 0.5f;
  const float scaled = ndc * half;
  return scaled + (origin + half);
}

TEST(ScreenTransform, LectureReflectTranslateScale) {
  const glm::dmat4 m = screenTransform(640, 480);
  EXPECT_EQ(m * glm::dvec4(-1, 1, 0, 1), glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(m * glm::dvec4(1, -1, 0, 1), glm::dvec4(640, 480, 0, 1));
  EXPECT_EQ(m * glm::dvec4(0, 0, 0.25, 1), glm::dvec4(320, 240, 0.25, 1));
}

TEST(ScreenTransform, IsVulkansViewportAfterTurningYRound) {
  const glm::dmat4 m = screenTransform(64, 32);
  const Viewport viewport{0, 0, 64, 32, 0, 1};
  for (double x : {-0.75, 0.0, 0.5}) {
    for (double y : {-0.5, 0.25}) {
      const glm::dvec4 pixel = m * glm::dvec4(x, -y, 0, 1);  // the lecture's y is up
      const ClipPosition clip = clipFromPixels(viewport, {pixel.x, pixel.y, 0, 1});
      EXPECT_EQ(clip.x, static_cast<float>(x));
      EXPECT_EQ(clip.y, static_cast<float>(y));
    }
  }
}

TEST(ClipFromPixels, PowerOfTwoViewportsGiveEveryGridPointBackExactly) {
  Prng random(1);
  for (float extent : {16.0f, 256.0f, 2048.0f}) {
    for (float origin : {0.0f, 8.0f, -32.0f}) {
      for (float w : {1.0f, 0.25f, 8.0f}) {
        const Viewport viewport{origin, origin, extent, -extent, 0, 1};
        for (int i = 0; i < 2000; ++i) {
          const auto pixels = static_cast<float>(random.below(static_cast<uint64_t>(extent) * 256)) / 256 + origin;
          const ClipPosition clip = clipFromPixels(
              viewport, {double{pixels}, double{origin} - (double{pixels} - double{origin}), 0.5, double{w}});
          EXPECT_EQ(viewportFloat32(clip.x, clip.w, extent, origin), pixels);
          EXPECT_EQ(viewportFloat32(clip.y, clip.w, -extent, origin), origin - (pixels - origin));
          EXPECT_EQ(clip.w, w);
          EXPECT_EQ(clip.z, 0.5f * w);
        }
      }
    }
  }
}

TEST(ClipFromPixels, OtherViewportsComeBackWithinAGridStepOf256) {
  // float32 of the NDC: half an ulp below 1 is 2^-25; times half the extent (50) that is far below 1/512 pixel.
  const Viewport viewport{3, 0, 100, 100, 0, 1};
  Prng random(2);
  for (int i = 0; i < 2000; ++i) {
    const double pixels = random.between(3.0, 103.0);
    const ClipPosition clip = clipFromPixels(viewport, {pixels, 0, 0, 1});
    EXPECT_NEAR(double{clip.x} * 50 + 53, pixels, 50 * 0x1p-25);
  }
}

/// The lecture's derivation: along a line in space, p(t) = p0 + t (p1 - p0) projects to the screen point that
/// interpolates the projected ends with s, where 1/z and f/z are linear in s.
TEST(PerspectiveInterpolation, LectureOneOverZAndFOverZAreLinearOnTheScreen) {
  Prng random(3);
  for (int i = 0; i < 10000; ++i) {
    const double x0 = random.between(-5.0, 5.0), x1 = random.between(-5.0, 5.0);
    const double z0 = random.between(0.5, 20.0), z1 = random.between(0.5, 20.0);
    const double f0 = random.between(-3.0, 3.0), f1 = random.between(-3.0, 3.0);
    const double t = random.unit();
    const double x = x0 + t * (x1 - x0), z = z0 + t * (z1 - z0), f = f0 + t * (f1 - f0);
    const double s0 = x0 / z0, s1 = x1 / z1;
    if (std::fabs(s1 - s0) < 1e-3) continue;  // seen end-on: the screen does not tell the points apart
    const double s = (x / z - s0) / (s1 - s0);
    // Rounding of x/z over a screen length of 1e-3 at least: 10 · 2^-52 / 1e-3 · size of the ends (40).
    const double rounding = 1e-9;
    EXPECT_NEAR(1 / z, (1 - s) / z0 + s / z1, rounding);
    EXPECT_NEAR(f / z, (1 - s) * f0 / z0 + s * f1 / z1, rounding);
    const double interpolated = ((1 - s) * f0 / z0 + s * f1 / z1) / ((1 - s) / z0 + s / z1);
    EXPECT_NEAR(interpolated, f, 20 * rounding);  // divided by 1/z >= 1/20
  }
}

TEST(PerspectiveInterpolation, DepthAfterProjectionIsLinearOnTheScreen) {
  Prng random(4);
  for (int i = 0; i < 1000; ++i) {
    const double near = 0.5, far = 20, a = far / (far - near), b = -near * far / (far - near);
    const double z0 = random.between(near, far), z1 = random.between(near, far), s = random.unit();
    const double depth0 = a + b / z0, depth1 = a + b / z1;
    const double z = 1 / ((1 - s) / z0 + s / z1);
    EXPECT_NEAR(a + b / z, (1 - s) * depth0 + s * depth1, 1e-13);  // a few roundings of numbers around 1
  }
}

}  // namespace
}  // namespace rasterdiff
