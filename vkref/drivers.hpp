// Driver discovery: from a driver's name or a manifest's path to the manifests that could be loaded, each checked.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff::vkref {

/// A driver that is known by name.
struct KnownDriver {
  std::string_view name;
  std::string_view folder;  ///< where its manifest lies (beside the folders that a loader searches)
  std::string_view prefix;  ///< how the manifest's file name begins
  std::string_view install; ///< the command that installs it
};

[[nodiscard]] std::span<const KnownDriver> knownDrivers();

/// Manifests that `driver` (a known name, or a path of a *.json) stands for; empty if it is known but not installed.
/// Error: NoDevice for a name that is not known.
[[nodiscard]] Result<std::vector<std::string>> manifestsOf(const std::string& driver);

/// All other manifests in the folders that a loader searches.
[[nodiscard]] std::vector<std::string> otherManifests();

/// Checks that a manifest can be read, is an ICD manifest, and names a library that loads as a Vulkan driver.
/// Returns the path of the library that was loaded (it stays loaded). Error: NoDevice with the reason.
[[nodiscard]] Result<std::string> checkManifest(const std::string& manifest);

}  // namespace rasterdiff::vkref
