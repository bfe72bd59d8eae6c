// Starts the loader through volk, creates an instance (with synchronization validation on demand), lists its devices.
#include "vkref/instance.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>

#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                         VkDebugUtilsMessageTypeFlagsEXT type,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  MessageLog& log = *static_cast<MessageLog*>(user);
  const std::lock_guard lock(log.mutex);
  const char* text = data && data->pMessage ? data->pMessage : "(no text)";
  if (type & VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT) {
    log.validation.emplace_back(text);
  } else if (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) {
    log.loader.emplace_back(text);
  }
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageLog& log) {
  auto info = vkStruct<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = &log;
  return info;
}

Result<void> startLoader() {
  static const VkResult started = volkInitialize();
  if (started != VK_SUCCESS) {
    return fail(ErrorCode::NoDevice, "libvulkan.so.1", "there is no Vulkan loader on this machine",
                "apt-get install libvulkan1");
  }
  if (volkGetInstanceVersion() < VK_API_VERSION_1_1) {
    return fail(ErrorCode::NoDevice, "libvulkan.so.1", "the Vulkan loader knows Vulkan 1.0 only",
                "apt-get install libvulkan1");
  }
  return {};
}

bool hasValidationLayer() {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const VkLayerProperties& layer : layers) {
    if (std::strcmp(layer.layerName, kValidationLayer) == 0) return true;
  }
  return false;
}

bool hasDebugUtils() {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  for (const VkExtensionProperties& extension : extensions) {
    if (std::strcmp(extension.extensionName, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) == 0) return true;
  }
  return false;
}

tl::unexpected<Error> refused(const char* call, VkResult result, MessageLog& log) {
  std::string what = fmt::format("{} returned {}", call, resultName(result));
  const std::lock_guard lock(log.mutex);
  for (const std::string& message : log.loader) what += "; " + message;
  return fail(ErrorCode::NoDevice, call, std::move(what));
}

}  // namespace

Result<std::unique_ptr<Instance>> Instance::create(bool validate) {
  if (const Result<void> started = startLoader(); !started) return tl::unexpected(started.error());
  if (validate && !hasValidationLayer()) {
    return fail(ErrorCode::NoDevice, kValidationLayer, "the Khronos validation layer is not installed",
                "apt-get install vulkan-validationlayers");
  }
  std::unique_ptr<Instance> self(new Instance);

  auto application = vkStruct<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.pApplicationName = "rasterdiff";
  application.apiVersion = VK_API_VERSION_1_3;
  auto info = vkStruct<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;

  std::vector<const char*> extensions;
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(*self->log_);
  const bool debugUtils = hasDebugUtils() || validate;
  if (debugUtils) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.pNext = &messenger;
  }
  const std::array enabled = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  auto features = vkStruct<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
  features.enabledValidationFeatureCount = enabled.size();
  features.pEnabledValidationFeatures = enabled.data();
  if (validate) {
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &kValidationLayer;
    features.pNext = info.pNext;
    info.pNext = &features;
  }
  info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();

  if (const VkResult result = vkCreateInstance(&info, nullptr, &self->instance_); result != VK_SUCCESS) {
    self->instance_ = VK_NULL_HANDLE;
    return refused("vkCreateInstance", result, *self->log_);
  }
  volkLoadInstanceOnly(self->instance_);
  if (debugUtils) {
    const VkResult result =
        vkCreateDebugUtilsMessengerEXT(self->instance_, &messenger, nullptr, &self->messenger_);
    if (result != VK_SUCCESS) return refused("vkCreateDebugUtilsMessengerEXT", result, *self->log_);
  }
  return self;
}

Instance::~Instance() {
  if (messenger_) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
  if (instance_) vkDestroyInstance(instance_, nullptr);
}

Result<std::vector<VkPhysicalDevice>> Instance::physicalDevices() {
  uint32_t count = 0;
  VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  if (result < 0) return refused("vkEnumeratePhysicalDevices", result, *log_);
  std::vector<VkPhysicalDevice> devices(count);
  result = vkEnumeratePhysicalDevices(instance_, &count, devices.data());
  if (result < 0) return refused("vkEnumeratePhysicalDevices", result, *log_);
  devices.resize(count);
  if (devices.empty()) {
    return fail(ErrorCode::NoDevice, "vkEnumeratePhysicalDevices", "the driver has no device on this machine");
  }
  return devices;
}

}  // namespace rasterdiff::vkref
