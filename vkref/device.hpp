// A Vulkan device under test: found by name or manifest path, opened headless, closed with its last reference.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/frame.hpp"
#include "scene/limits.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::vkref {

struct DeviceOptions {
  std::string driver = "lavapipe";  ///< "lavapipe", "swiftshader" or the path of an ICD manifest (*.json)
  bool validate = false;            ///< Khronos validation layer with synchronization validation
  double timeoutSeconds = 20;       ///< for one submit
  size_t mostPipelines = 512;       ///< that are kept: bounds the memory of a long search
};

struct DriverInfo {
  std::string name;        ///< VkPhysicalDeviceDriverProperties::driverName ("llvmpipe" for lavapipe)
  std::string info;        ///< ... driverInfo, or driverVersion where that is empty: what exactly was tested
  std::string deviceName;
  std::string apiVersion;  ///< "1.3.230"
  std::string manifest;    ///< path of the ICD manifest
  std::string library;     ///< the shared object that was really loaded (a manifest may name a bare file)
};

/// What the last render() or renderTogether() made on the driver's side: how a test knows that nothing unneeded was asked for.
/// Bytes are those of texels and of planes, without a driver's padding; images and buffers of earlier scenes are reused
/// and count as if they were new.
struct RenderCost {
  uint32_t colorAttachments = 0, depthAttachments = 0, passes = 0;
  uint64_t attachmentBytes = 0, readbackBytes = 0;
  uint32_t pipelinesCreated = 0;
  double pipelineSeconds = 0;  ///< to create them
  double uploadSeconds = 0;    ///< without them: from the call to the submit of the draws
  double drawSeconds = 0;      ///< from that submit to its fence
  double readbackSeconds = 0;  ///< from the fence to the planes
};

/// One thread at a time; several devices may be open at once, of one driver or of several. Close it before main
/// returns: drivers and layers do not outlive that.
class Device {
 public:
  struct Impl;
  explicit Device(std::unique_ptr<Impl> impl);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] const DriverInfo& driver() const;
  [[nodiscard]] const Limits& limits() const;
  [[nodiscard]] const RenderCost& lastCost() const;
  /// Messages of the validation layer so far (errors and warnings); empty is clean.
  [[nodiscard]] const std::vector<std::string>& validationMessages() const;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// Error: NoDevice with every candidate and why it was refused.
[[nodiscard]] Result<std::unique_ptr<Device>> openDevice(const DeviceOptions& options);

/// A driver that could be asked for, for `rasterdiff devices`.
struct DriverCandidate {
  std::string name;      ///< "lavapipe", "swiftshader", or the manifest's path
  std::string manifest;  ///< empty: not installed
  bool usable = false;
  std::string refusal;   ///< why not
  DriverInfo driver;
  Limits limits;
  std::vector<std::pair<std::string, std::string>> facts;  ///< further limits and features that matter, name and value
};

[[nodiscard]] std::vector<DriverCandidate> listDrivers();

/// Draws `scene` on `device` and reads back every sample. Error: NotOffered (the scene needs what the device lacks),
/// DeviceLost, TimedOut (the device must then be closed).
[[nodiscard]] Result<Frame> render(const Scene& scene, Device& device);

/// The same of many scenes: as many as fit a bound of memory are drawn by one submit, and read back together. Each has the
/// frame or the error that it would have alone; what is lost with a submit is lost for all of its scenes.
[[nodiscard]] std::vector<Result<Frame>> renderTogether(std::span<const Scene> scenes, Device& device);

}  // namespace rasterdiff::vkref
