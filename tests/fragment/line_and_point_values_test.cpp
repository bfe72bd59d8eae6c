// Values along lines and of points: the projection onto the segment, perspective, the other legal parameters, and
// coordinates within a point.
#include <cmath>
#include <random>

#include "fragment_support.hpp"
#include "rasterizer/fragment/line_plane.hpp"
#include "rasterizer/fragment/value_freedoms.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene lineScene(const testing::Point& a, const testing::Point& b, uint32_t extent = 16) {
  Scene scene = testing::sceneOf({a, b}, extent);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  return scene;
}

// The parameter of a pixel's centre in long doubles.
long double parameterOf(const testing::Point& a, const testing::Point& b, uint32_t x, uint32_t y) {
  const long double dx = b.x - a.x, dy = b.y - a.y;
  return ((x + 0.5L - a.x) * dx + (y + 0.5L - a.y) * dy) / (dx * dx + dy * dy);
}

TEST(LineValues, FollowTheProjectionWithPerspective) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(1, 63), depth(0.1, 0.9);
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    const testing::Point a{place(random), place(random), depth(random), std::exp2(depth(random) * 4)};
    const testing::Point b{place(random), place(random), depth(random), std::exp2(depth(random) * 4)};
    Scene scene = lineScene(a, b, 64);
    useDepth(scene);
    addVarying(scene, "smooth", Interpolation::smooth, 1, {-3, 5});
    addVarying(scene, "screen", Interpolation::noperspective, 1, {-3, 5});
    scene.builtIns = {BuiltIn::FragCoord};
    const Frame frame = drawn(scene), open = drawn(scene, specificationRules());
    for (uint32_t y = 0; y < 64; ++y) {
      for (uint32_t x = 0; x < 64; ++x) {
        if (frame.primitive.at(x, y, 0) == 0 || open.primitive.at(x, y, 0) == 0) continue;
        const long double t = parameterOf(a, b, x, y);
        const long double w = (1 - t) / a.w + t / b.w;
        const long double smooth = ((1 - t) * -3 / a.w + t * 5 / b.w) / w, screen = (1 - t) * -3 + t * 5;
        const auto near = [&](const VaryingPlane& plane, uint32_t component, long double expected) {
          // Positions and depths were rounded to float32 on their way into clip space.
          EXPECT_NEAR(plane.values.at(x, y, 0, component), static_cast<double>(expected), 1e-4);
          EXPECT_TRUE(contains(plane.bounds->at(x, y, 0, component), static_cast<float>(expected)));
        };
        for (const Frame* each : {&frame, &open}) {
          near(each->varyings[0], 0, smooth);
          near(each->varyings[1], 0, screen);
          near(each->varyings[2], 2, (1 - t) * a.z + t * b.z);
          near(each->varyings[2], 3, w);
          EXPECT_NEAR(each->depth->at(x, y, 0), static_cast<double>((1 - t) * a.z + t * b.z), 1e-6);
        }
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 3000);
}

TEST(LineValues, FlatOnesComeFromTheProvokingEnd) {
  for (const auto mode : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
    Scene scene = lineScene({2.5, 2.5}, {12.5, 2.5});
    scene.state.provokingVertexMode = mode;
    addVarying(scene, "flat", Interpolation::flat, 1, {7, 9});
    const float expected = mode == ProvokingVertexMode::FIRST_VERTEX ? 7 : 9;
    EXPECT_EQ(drawn(scene).varyings[0].values.at(5, 2, 0), expected);
  }
}

// A float32 evaluation as drivers do it: gradient by the reciprocal of the squared length, anchored at the origin.
TEST(LineValues, HoldFloat32Evaluations) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> place(-200, 800), value(-4, 4);
  for (int round = 0; round < 20000; ++round) {
    RasterVertex a, b;
    const float ax = place(random), ay = place(random), bx = place(random), by = place(random);
    a.position = {ax, ay, 0};
    b.position = {bx, by, 0};
    if (std::hypot(bx - ax, by - ay) < 1) continue;
    const float fa = value(random), fb = value(random);
    const LinearFunction f = LinePlane(a, b, 1, LineParameter::Projection).through(double{fa}, double{fb}, 0);
    const float t = std::uniform_real_distribution<float>(0, 1)(random);
    const float x = std::floor(ax + t * (bx - ax)) + 0.5F, y = std::floor(ay + t * (by - ay)) + 0.5F;
    const float dx = ax - bx, dy = ay - by, reciprocal = 1.0F / (dx * dx + dy * dy), difference = fa - fb;
    const float gx = difference * dx * reciprocal, gy = difference * dy * reciprocal;
    const float computed = (fa - (gx * ax + gy * ay)) + gx * x + gy * y;
    EXPECT_NEAR(f.at(double{x}, double{y}), double{computed}, f.radius(double{x}, double{y}) + std::fabs(double{computed}) * 0x1p-24);
  }
}

TEST(LineValues, OfNonStrictLinesMayFollowTheMajorAxisOrTheProjection) {
  Scene scene = lineScene({2.5, 2.5}, {12.5, 7.5});
  addVarying(scene, "t", Interpolation::noperspective, 1, {0, 1});
  for (const bool strict : {false, true}) {
    Limits limits;
    limits.strictLines = strict;
    Rules open = Rules::specification(limits), closed = *Rules::profile("reference", limits);
    const Frame frame = drawn(scene, open);
    int compared = 0;
    for (uint32_t y = 0; y < 16; ++y) {
      for (uint32_t x = 0; x < 16; ++x) {
        if (frame.primitive.at(x, y, 0) == 0) continue;
        const auto projected = static_cast<float>(parameterOf({2.5, 2.5}, {12.5, 7.5}, x, y));
        const float major = (static_cast<float>(x) - 2) / 10;
        if (std::fabs(projected - major) < 0.01F) continue;
        EXPECT_TRUE(contains(frame.varyings[0].bounds->at(x, y, 0), projected));
        EXPECT_EQ(contains(frame.varyings[0].bounds->at(x, y, 0), major), !strict);
        ++compared;
      }
    }
    EXPECT_GT(compared, 3);
  }
}

Scene pointScene(double x, double y, float size, uint32_t samples = 1) {
  Scene scene = testing::sceneOf({{x, y, 0.375, 4}}, 16, samples);
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.state.pointSize = size;
  return scene;
}

Rules withPointSizes(Rules rules) {
  rules.limits.pointSizeMin = 0;
  rules.limits.pointSizeMax = 255;
  rules.limits.pointSizeGranularity = 0.125F;
  return rules;
}

TEST(PointValues, AreThoseOfTheVertexBitByBit) {
  Scene scene = pointScene(8.3, 7.9, 4);
  useDepth(scene);
  for (const auto& [name, interpolation] : {std::pair{"a", Interpolation::smooth}, {"b", Interpolation::noperspective}, {"c", Interpolation::flat}}) {
    addVarying(scene, name, interpolation, 1, {0x1.23456p-3F});
  }
  for (const Rules& rules : {withPointSizes(testing::referenceRules()), withPointSizes(specificationRules())}) {
    const Frame frame = drawn(scene, rules);
    ASSERT_EQ(frame.primitive.at(8, 8, 0), 1U);
    EXPECT_EQ(frame.depth->at(8, 8, 0), 0.375F);
    for (const VaryingPlane& plane : frame.varyings) {
      EXPECT_EQ(plane.values.at(8, 8, 0), 0x1.23456p-3F);
      EXPECT_EQ(plane.bounds->at(8, 8, 0).lo, plane.bounds->at(8, 8, 0).hi);
    }
  }
}

TEST(PointCoord, RunsFromTheUpperLeftCornerAroundTheUnroundedVertex) {
  Scene scene = pointScene(8.25, 7.125, 5);
  scene.builtIns = {BuiltIn::PointCoord};
  const Frame frame = drawn(scene, withPointSizes(testing::referenceRules()));
  const Plane<float>& values = frame.varyings[0].values;
  ASSERT_EQ(frame.primitive.at(6, 9, 0), 1U);
  EXPECT_EQ(values.at(6, 9, 0, 0), static_cast<float>(0.5 + (6.5 - 8.25) / 5));
  EXPECT_EQ(values.at(6, 9, 0, 1), static_cast<float>(0.5 + (9.5 - 7.125) / 5));
}

// [vk:primsrast-points-basic] at the centre or at a sample.
TEST(PointCoord, MayBeThatOfAnySampleUnderOpenRules) {
  Scene scene = pointScene(8, 8, 4, 4);
  scene.builtIns = {BuiltIn::PointCoord};
  const Frame frame = drawn(scene, withPointSizes(specificationRules()));
  ASSERT_EQ(frame.primitive.at(8, 7, 0), 1U);
  const Bounds s = frame.varyings[0].bounds->at(8, 7, 0, 0);
  for (const int sixteenths : {2, 6, 8, 10, 14}) EXPECT_TRUE(contains(s, 0.5F + static_cast<float>(sixteenths) / 64));
  EXPECT_FALSE(contains(s, 0.5F + 18.0F / 64));
}

// [vk:limits-pointSizeGranularity] a size between two advertised ones: the nearest of them, or what was asked for.
TEST(PointCoord, IsThatOfASizeThatMayBeDrawn) {
  Scene scene = pointScene(8, 8, 2.0625F);
  scene.builtIns = {BuiltIn::PointCoord};
  Rules rules = withPointSizes(specificationRules());
  const auto at = [](float size) { return static_cast<float>(0.5 + 0.5 / size); };
  for (const float granularity : {0.0F, 0.125F}) {
    rules.limits.pointSizeGranularity = granularity;
    const Frame frame = drawn(scene, rules);
    ASSERT_EQ(frame.primitive.at(8, 8, 0), 1U);
    const Bounds s = frame.varyings[0].bounds->at(8, 8, 0, 0);
    EXPECT_TRUE(contains(s, at(2.0625F)));
    EXPECT_EQ(contains(s, at(2)), granularity > 0);
    EXPECT_EQ(contains(s, at(2.125F)), granularity > 0);
    EXPECT_FALSE(contains(s, at(2.25F)));
    EXPECT_EQ(valueFreedoms(scene, rules).front(), granularity > 0 ? Freedom::PointSizeStep : Freedom::None);
  }
}

// [choice:point-arithmetic]
TEST(PointCoord, IsThatOfTheSizeThatAProfileDraws) {
  Scene scene = pointScene(8, 8, 2.0625F);
  scene.builtIns = {BuiltIn::PointCoord};
  Rules rules = withPointSizes(testing::referenceRules());
  rules.limits.pointSizeGranularity = 0.125F;
  for (const PointArithmetic arithmetic : {PointArithmetic::Exact, PointArithmetic::SnappedCentre, PointArithmetic::SnappedCentreEven,
                                           PointArithmetic::SnappedCorners, PointArithmetic::ClipCorners}) {
    rules.choices.pointArithmetic = arithmetic;
    const bool advertised = arithmetic == PointArithmetic::Exact || arithmetic == PointArithmetic::SnappedCorners;
    const Frame frame = drawn(scene, rules);
    ASSERT_EQ(frame.primitive.at(8, 8, 0), 1U);
    EXPECT_EQ(frame.varyings[0].values.at(8, 8, 0, 0), static_cast<float>(0.5 + 0.5 / (advertised ? 2.0 : 2.0625)));
  }
}

TEST(PointCoord, OfATriangleDrawnAsPointsIsUndefined) {
  Scene scene = testing::sceneOf({{1.5, 1.5}, {6.5, 1.5}, {1.5, 6.5}}, 8);
  scene.state.polygonMode = PolygonMode::POINT;
  scene.builtIns = {BuiltIn::PointCoord};
  const Frame frame = drawn(scene);
  ASSERT_EQ(frame.primitive.at(1, 1, 0), 1U);
  EXPECT_TRUE(std::isinf(frame.varyings[0].bounds->at(1, 1, 0, 0).lo));
  EXPECT_TRUE(std::isinf(frame.varyings[0].bounds->at(1, 1, 0, 1).hi));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
