// Look-at and projections. The lecture is CMU 15-362/662, lecture 4, "Perspective projection and rasterization".
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/camera/look_at.hpp"
#include "scene/camera/projection.hpp"

namespace rasterdiff {
namespace {

/// Rounding of a few double operations on numbers of size 100 at most: 100 · 2^-52 · 8.
constexpr double kRounding = 1e-12;

glm::dvec4 at(const glm::dmat4& m, double x, double y, double z) { return m * glm::dvec4(x, y, z, 1); }
glm::dvec3 ndc(const glm::dmat4& m, double x, double y, double z) {
  const glm::dvec4 clip = at(m, x, y, z);
  return glm::dvec3(clip) / clip.w;
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected) {
  EXPECT_NEAR(actual.x, expected.x, kRounding);
  EXPECT_NEAR(actual.y, expected.y, kRounding);
  EXPECT_NEAR(actual.z, expected.z, kRounding);
}

TEST(LookAt, LectureCameraAt420LookingDownXIsTranslationThenQuarterTurnAboutY) {
  const auto view = lookAt({4, 2, 0}, {5, 2, 0}, {0, 1, 0});
  ASSERT_TRUE(view.has_value());
  // Translate by (-4, -2, 0), then rotate by 90 degrees about y: (x, y, z) -> (z, y, -x).
  for (const glm::dvec3& p : {glm::dvec3(4, 2, 0), glm::dvec3(5, 2, 0), glm::dvec3(1, 7, -3), glm::dvec3(0, 0, 9)}) {
    const glm::dvec3 moved = p - glm::dvec3(4, 2, 0);
    expectNear(glm::dvec3(at(*view, p.x, p.y, p.z)), glm::dvec3(moved.z, moved.y, -moved.x));
  }
}

TEST(LookAt, TheEyeIsTheOriginAndTheTargetIsStraightAhead) {
  const glm::dvec3 eye(3, -2, 7), target(-1, 4, 2);
  const auto view = lookAt(eye, target, {0.1, 0.9, 0.2});
  ASSERT_TRUE(view.has_value());
  expectNear(glm::dvec3(at(*view, eye.x, eye.y, eye.z)), glm::dvec3(0));
  expectNear(glm::dvec3(at(*view, target.x, target.y, target.z)), glm::dvec3(0, 0, -glm::length(target - eye)));
}

TEST(LookAt, TheRotationIsOrthonormalAndKeepsHandedness) {
  const auto view = lookAt({1, 2, 3}, {-4, 0.5, 9}, {0.3, 1, -0.2});
  ASSERT_TRUE(view.has_value());
  const glm::dmat3 r(*view);
  const glm::dmat3 product = r * glm::transpose(r);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, kRounding);
  }
  EXPECT_NEAR(glm::determinant(r), 1, kRounding);
}

TEST(LookAt, UpNeedNotBeUnitNorPerpendicular) {
  const auto a = lookAt({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), b = lookAt({0, 0, 5}, {0, 0, 0}, {0, 1e-150, 3e-151});
  ASSERT_TRUE(a.has_value() && b.has_value());
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR((*a)[c][r], (*b)[c][r], kRounding);
  }
}

TEST(LookAt, DegenerateCamerasAreRefusedAtTheirField) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const auto where = [](const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
    const auto view = lookAt(eye, target, up);
    return view ? std::string("accepted") : view.error().where;
  };
  EXPECT_EQ(where({1, 2, 3}, {1, 2, 3}, {0, 1, 0}), "target");
  EXPECT_EQ(where({0, 0, 0}, {0, 5, 0}, {0, 1, 0}), "up");
  EXPECT_EQ(where({0, 0, 0}, {0, -5, 0}, {0, 1, 0}), "up");
  EXPECT_EQ(where({0, 0, 0}, {1, 0, 0}, {0, 0, 0}), "up");
  EXPECT_EQ(where({0, 0, 0}, {1, 0, 0}, {0, kInf, 0}), "up");
  EXPECT_EQ(where({kInf, 0, 0}, {1, 0, 0}, {0, 1, 0}), "eye");
  EXPECT_EQ(where({0, 0, 0}, {std::nan(""), 0, 0}, {0, 1, 0}), "target");
  EXPECT_EQ(where({-1e308, 0, 0}, {1.7e308, 0, 0}, {0, 1, 0}), "target");
}

constexpr ViewBox kBox{-3, 5, -2, 4, 1.5, 12};

TEST(Orthographic, LectureTheEightCornersOfTheBoxGoToTheEightCornersOfTheCube) {
  const auto matrix = orthographic(kBox, Convention::OpenGL);
  ASSERT_TRUE(matrix.has_value());
  for (int corner = 0; corner < 8; ++corner) {
    const double x = corner & 1 ? kBox.right : kBox.left, y = corner & 2 ? kBox.top : kBox.bottom;
    const double distance = corner & 4 ? kBox.far : kBox.near;
    expectNear(ndc(*matrix, x, y, -distance), {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
    EXPECT_EQ(at(*matrix, x, y, -distance).w, 1);
  }
}

TEST(Orthographic, LectureMatrixAsPrintedTakesNearAndFarAsCoordinatesNotDistances) {
  // The slide's z row, 2/(n-f) z + (f+n)/(f-n), sends z = n to 1 and z = f to -1, as its list of corners says: there n
  // and f are coordinates. On the perspective slide they are distances, and -n goes to -1, -f to 1. With distances the
  // printed row sends -n and -f outside of the cube; ours is that row of -z, with its sign turned.
  const double n = kBox.near, f = kBox.far;
  const auto slide = [&](double z) { return 2 / (n - f) * z + (f + n) / (f - n); };
  EXPECT_NEAR(slide(n), 1, kRounding);
  EXPECT_NEAR(slide(f), -1, kRounding);
  EXPECT_GT(std::fabs(slide(-n)), 1);
  EXPECT_GT(std::fabs(slide(-f)), 1);
  const auto matrix = orthographic(kBox, Convention::OpenGL);
  ASSERT_TRUE(matrix.has_value());
  for (double z : {-n, -f, -5.0}) EXPECT_NEAR(ndc(*matrix, 0, 0, z).z, -slide(-z), kRounding);
}

TEST(Orthographic, VulkanDepthIsZeroToOneAndUpIsUpInThePicture) {
  const auto matrix = orthographic(kBox, Convention::Vulkan);
  ASSERT_TRUE(matrix.has_value());
  expectNear(ndc(*matrix, kBox.left, kBox.top, -kBox.near), {-1, -1, 0});
  expectNear(ndc(*matrix, kBox.right, kBox.bottom, -kBox.far), {1, 1, 1});
}

TEST(Perspective, LectureTheEightCornersOfTheFrustumGoToTheEightCornersOfTheCube) {
  const auto matrix = perspective(kBox, Convention::OpenGL);
  ASSERT_TRUE(matrix.has_value());
  for (int corner = 0; corner < 8; ++corner) {
    const double distance = corner & 4 ? kBox.far : kBox.near, scale = distance / kBox.near;
    const double x = corner & 1 ? kBox.right : kBox.left, y = corner & 2 ? kBox.top : kBox.bottom;
    expectNear(ndc(*matrix, x * scale, y * scale, -distance),
               {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
    EXPECT_NEAR(at(*matrix, x * scale, y * scale, -distance).w, distance, kRounding);
  }
}

TEST(Perspective, LectureMinusNearGoesToMinusOneAndMinusFarToOne) {
  const auto matrix = perspective(kBox, Convention::OpenGL);
  ASSERT_TRUE(matrix.has_value());
  EXPECT_NEAR(ndc(*matrix, 0, 0, -kBox.near).z, -1, kRounding);
  EXPECT_NEAR(ndc(*matrix, 0, 0, -kBox.far).z, 1, kRounding);
}

TEST(Perspective, LectureMatrixAsPrintedIsOurs) {
  const auto& [l, r, b, t, n, f] = kBox;
  const std::array<std::array<double, 4>, 4> rows{{{2 * n / (r - l), 0, (r + l) / (r - l), 0},
                                                   {0, 2 * n / (t - b), (t + b) / (t - b), 0},
                                                   {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)},
                                                   {0, 0, -1, 0}}};
  const auto matrix = perspective(kBox, Convention::OpenGL);
  ASSERT_TRUE(matrix.has_value());
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      EXPECT_NEAR((*matrix)[column][row], rows[static_cast<size_t>(row)][static_cast<size_t>(column)], kRounding);
    }
  }
}

TEST(Perspective, VulkanDepthIsZeroToOneAndUpIsUpInThePicture) {
  const auto matrix = perspective(kBox, Convention::Vulkan);
  ASSERT_TRUE(matrix.has_value());
  expectNear(ndc(*matrix, kBox.left, kBox.top, -kBox.near), {-1, -1, 0});
  EXPECT_NEAR(ndc(*matrix, 0, 0, -kBox.far).z, 1, kRounding);
}

TEST(Perspective, FieldOfViewIsTheAngleBetweenBottomAndTop) {
  const auto matrix = perspective(90, 2, 0.5, 10, Convention::Vulkan);
  ASSERT_TRUE(matrix.has_value());
  expectNear(ndc(*matrix, 2 * 3, 3, -3), {1, -1, ndc(*matrix, 0, 0, -3).z});  // tan 45 degrees = 1
}

TEST(Perspective, EmptyViewsAreRefusedAtTheirField) {
  const auto where = [](const Result<glm::dmat4>& matrix) { return matrix ? "accepted" : matrix.error().where; };
  const auto box = [&](const ViewBox& b) { return where(perspective(b, Convention::Vulkan)); };
  EXPECT_EQ(box({1, 1, -1, 1, 1, 2}), "right");
  EXPECT_EQ(box({-1, 1, 2, 2, 1, 2}), "top");
  EXPECT_EQ(box({-1, 1, -1, 1, 2, 2}), "far");
  EXPECT_EQ(box({-1, 1, -1, 1, 0, 2}), "near");
  EXPECT_EQ(box({-1, 1, -1, 1, 1, -2}), "far");
  EXPECT_EQ(box({std::nan(""), 1, -1, 1, 1, 2}), "left");
  EXPECT_EQ(where(perspective(0, 1, 1, 2, Convention::Vulkan)), "fovY");
  EXPECT_EQ(where(perspective(180, 1, 1, 2, Convention::Vulkan)), "fovY");
  EXPECT_EQ(where(perspective(60, 0, 1, 2, Convention::Vulkan)), "aspect");
  EXPECT_EQ(where(perspective(60, 1, -1, 2, Convention::Vulkan)), "near");
  EXPECT_EQ(where(orthographic({0, 0, -1, 1, 0, 1}, Convention::Vulkan)), "right");
  EXPECT_EQ(where(orthographic({0, 1e-320, -1, 1, 0, 1}, Convention::Vulkan)), "");
}

TEST(ToClip, RoundsOnceToFloat32) {
  glm::dmat4 matrix(1);
  matrix[3][0] = 0x1p-25;
  const ClipPosition p = toClip(matrix, 1, 0.1, -3);
  EXPECT_EQ(p, (ClipPosition{1, 0.1f, -3, 1}));
}

}  // namespace
}  // namespace rasterdiff
