// Every driver test runs on lavapipe and on SwiftShader, under the validation layer, and ends with a clean log.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "tests/support/text_mask.hpp"
#include "vkref/device_impl.hpp"

namespace rasterdiff::vkref::testing {

/// One device a driver for the whole test program: many scenes in one process is how devices are used.
/// Closed before main returns, since drivers and layers are gone when static objects are destroyed.
class SharedDevices : public ::testing::Environment {
 public:
  static Device& get(const std::string& driver) {
    static auto* self = static_cast<SharedDevices*>(::testing::AddGlobalTestEnvironment(new SharedDevices));
    std::unique_ptr<Device>& device = self->devices_[driver];
    if (!device) {
      Result<std::unique_ptr<Device>> opened = openDevice({driver, /*validate=*/true, /*timeoutSeconds=*/60});
      if (!opened) throw std::runtime_error(fmt::format("{}: {} ({})", driver, opened.error().what, opened.error().hint));
      device = std::move(*opened);
    }
    return *device;
  }
  void TearDown() override { devices_.clear(); }

 private:
  std::map<std::string, std::unique_ptr<Device>> devices_;
};

class DriverTest : public ::testing::TestWithParam<const char*> {
 protected:
  Device& device() { return SharedDevices::get(GetParam()); }

  Frame draw(const Scene& scene) {
    Result<Frame> frame = render(scene, device());
    if (!frame) throw std::runtime_error(fmt::format("{}: {}", frame.error().where, frame.error().what));
    return std::move(*frame);
  }

  /// The frame of a scene that needs a feature; where that is not `offered`, nothing, and the refusal names `where`.
  std::optional<Frame> drawIf(bool offered, const Scene& scene, const std::string& where) {
    if (offered) return draw(scene);
    const Result<Frame> frame = render(scene, device());
    EXPECT_FALSE(frame.has_value());
    if (frame) return std::nullopt;
    EXPECT_EQ(frame.error().code, ErrorCode::NotOffered) << frame.error().what;
    EXPECT_EQ(frame.error().where, where) << frame.error().what;
    return std::nullopt;
  }

  const Capabilities& caps() { return device().impl().context->caps; }

  void TearDown() override {
    const std::vector<std::string>& messages = device().validationMessages();
    EXPECT_TRUE(messages.empty()) << messages.size() << " validation messages, the first: " << messages.front();
  }
};

inline std::string driverName(const ::testing::TestParamInfo<const char*>& info) { return info.param; }

#define RASTERDIFF_ON_ALL_DRIVERS(suite) \
  INSTANTIATE_TEST_SUITE_P(Drivers, suite, ::testing::Values("lavapipe", "swiftshader"), driverName)

struct Point {
  float x, y, z = 0.5F, w = 1;
};

/// A scene of one draw; points are in pixels of a target whose extents are powers of two, so that they arrive exactly.
inline Scene sceneOf(const std::vector<Point>& points, uint32_t width = 8, uint32_t height = 8, uint32_t samples = 1) {
  Scene scene;
  scene.name = "test";
  scene.target.width = width;
  scene.target.height = height;
  scene.target.samples = samples;
  scene.viewport = {0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1};
  Draw draw;
  for (const Point& p : points) {
    draw.positions.push_back({(p.x / (static_cast<float>(width) / 2) - 1) * p.w,
                              (p.y / (static_cast<float>(height) / 2) - 1) * p.w, p.z * p.w, p.w});
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

/// Covers every sample of the target; `z` in 0..1.
inline std::vector<Point> wholeTarget(float width = 8, float height = 8, float z = 0.5F) {
  return {{0, 0, z}, {2 * width, 0, z}, {0, 2 * height, z}};
}

/// A varying that tells each vertex of a draw from the others: its number.
inline Varying vertexNumbers(size_t vertices, Interpolation interpolation = Interpolation::flat) {
  Varying varying{"vertex", interpolation, 1, {}};
  for (size_t i = 0; i < vertices; ++i) varying.values.push_back(static_cast<float>(i));
  return varying;
}

/// The same varying value at every vertex of the first draw.
inline Varying constantVarying(const std::string& name, size_t vertices, const std::vector<float>& value) {
  Varying varying{name, Interpolation::flat, static_cast<uint32_t>(value.size()), {}};
  for (size_t i = 0; i < vertices; ++i) varying.values.insert(varying.values.end(), value.begin(), value.end());
  return varying;
}

/// Primitive indices as text, one digit a pixel, '.' where nothing was drawn.
inline std::string textPrimitives(const Frame& frame, uint32_t sample = 0) {
  std::string text;
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) {
      const uint32_t primitive = frame.primitive.at(x, y, sample);
      text += primitive == 0 ? '.' : static_cast<char>('0' + primitive);
    }
    text += '\n';
  }
  return text;
}

}  // namespace rasterdiff::vkref::testing
