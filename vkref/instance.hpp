// A Vulkan instance that sees one driver, with the loader's and the validation layer's messages collected.
#pragma once

#include <volk.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff::vkref {

/// What debug callbacks reported; they may come from any thread.
struct MessageLog {
  std::mutex mutex;
  std::vector<std::string> validation;  ///< errors and warnings of the validation layer
  std::vector<std::string> loader;      ///< errors of the loader: why a driver was not loaded
};

class Instance {
 public:
  /// Call with the environment of exactly one manifest set. Error: NoDevice (no loader, no layer, driver refused).
  [[nodiscard]] static Result<std::unique_ptr<Instance>> create(bool validate);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// Physical devices of the driver. Error: NoDevice.
  [[nodiscard]] Result<std::vector<VkPhysicalDevice>> physicalDevices();
  [[nodiscard]] MessageLog& log() { return *log_; }

 private:
  Instance() = default;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::unique_ptr<MessageLog> log_ = std::make_unique<MessageLog>();
};

}  // namespace rasterdiff::vkref
