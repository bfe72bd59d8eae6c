// Environment variables set while a driver is being opened, and put back afterwards; one opening at a time.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace rasterdiff::vkref {

class ScopedEnvironment {
 public:
  struct Setting {
    std::string name;
    std::optional<std::string> value;  ///< none: unset
  };
  /// Holds a process-wide lock until destroyed: the environment and volk's function pointers are shared.
  explicit ScopedEnvironment(const std::vector<Setting>& settings);
  ~ScopedEnvironment();
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  std::vector<Setting> before_;
};

/// What the loader and Mesa must see so that exactly the driver of `manifest` is loaded, without implicit layers and
/// without a disk cache of compiled shaders (its key leaves out the vector width).
[[nodiscard]] std::vector<ScopedEnvironment::Setting> environmentFor(const std::string& manifest);

}  // namespace rasterdiff::vkref
