// Sets and restores the environment of the Vulkan loader and of Mesa.
#include "vkref/environment.hpp"

#include <cstdlib>

namespace rasterdiff::vkref {
namespace {

std::mutex& openingMutex() {
  static std::mutex mutex;
  return mutex;
}

void apply(const ScopedEnvironment::Setting& setting) {
  if (setting.value) {
    setenv(setting.name.c_str(), setting.value->c_str(), 1);
  } else {
    unsetenv(setting.name.c_str());
  }
}

}  // namespace

ScopedEnvironment::ScopedEnvironment(const std::vector<Setting>& settings) : lock_(openingMutex()) {
  for (const Setting& setting : settings) {
    const char* old = std::getenv(setting.name.c_str());
    before_.push_back({setting.name, old ? std::optional<std::string>(old) : std::nullopt});
    apply(setting);
  }
}

ScopedEnvironment::~ScopedEnvironment() {
  for (const Setting& setting : before_) apply(setting);
}

std::vector<ScopedEnvironment::Setting> environmentFor(const std::string& manifest) {
  return {
      {"VK_DRIVER_FILES", manifest},
      {"VK_ICD_FILENAMES", manifest},  // the name that loaders before 1.3.207 know
      {"VK_ADD_DRIVER_FILES", std::nullopt},
      {"VK_LOADER_DRIVERS_SELECT", std::nullopt},
      {"VK_LOADER_DRIVERS_DISABLE", std::nullopt},
      {"VK_LOADER_LAYERS_DISABLE", "~implicit~"},
      {"NODEVICE_SELECT", "1"},  // the same for Mesa's device-select layer under older loaders
      {"MESA_SHADER_CACHE_DISABLE", "true"},
  };
}

}  // namespace rasterdiff::vkref
