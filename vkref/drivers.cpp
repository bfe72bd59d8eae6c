// Finds ICD manifests in the folders of the Vulkan loader, and refuses a bad one before the loader skips it silently.
#include "vkref/drivers.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rasterdiff::vkref {
namespace {

namespace fs = std::filesystem;

constexpr std::array<KnownDriver, 2> kKnownDrivers = {{
    {"lavapipe", "/usr/share/vulkan/icd.d", "lvp_icd", "apt-get install mesa-vulkan-drivers"},
    {"swiftshader", "/usr/lib/chromium", "vk_swiftshader_icd",
     "apt-get install --no-install-recommends chromium-common"},
}};

constexpr std::array<std::string_view, 4> kLoaderFolders = {"/usr/local/etc/vulkan/icd.d", "/etc/vulkan/icd.d",
                                                            "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d"};

constexpr std::uintmax_t kMaxManifestBytes = 1 << 20;

tl::unexpected<Error> refuse(const std::string& manifest, std::string what) {
  return fail(ErrorCode::NoDevice, manifest, std::move(what));
}

/// Sorted paths of the manifests in `folder` whose file name begins with `prefix`.
std::vector<std::string> manifestsIn(std::string_view folder, std::string_view prefix) {
  std::vector<std::string> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path& path = it->path();
    if (path.extension() == ".json" && path.filename().string().starts_with(prefix)) found.push_back(path.string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The text of a manifest; refuses what is not a small regular file.
Result<std::string> readManifest(const std::string& manifest) {
  std::error_code error;
  if (!fs::exists(manifest, error)) return refuse(manifest, "no such file");
  if (!fs::is_regular_file(manifest, error)) return refuse(manifest, "not a regular file");
  const std::uintmax_t size = fs::file_size(manifest, error);
  if (error || size > kMaxManifestBytes) return refuse(manifest, "larger than any driver manifest");
  std::ifstream file(manifest, std::ios::binary);
  std::string text(static_cast<size_t>(size), '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(size))) return refuse(manifest, "cannot be read");
  return text;
}

/// `library_path` as the loader resolves it: bare names are searched for, others are relative to the manifest.
Result<std::string> libraryPathOf(const std::string& manifest, const std::string& text) {
  const nlohmann::json root = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (root.is_discarded()) return refuse(manifest, "not valid JSON");
  const auto member = [](const nlohmann::json& object, const char* name) -> const nlohmann::json* {
    const auto it = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && it != object.end() ? &*it : nullptr;
  };
  const nlohmann::json* icd = member(root, "ICD");
  const nlohmann::json* library = icd ? member(*icd, "library_path") : nullptr;
  if (!library || !library->is_string()) return refuse(manifest, "not a driver manifest: no \"ICD\".\"library_path\"");
  const std::string path = library->get<std::string>();
  if (path.empty()) return refuse(manifest, "its \"library_path\" is empty");
  if (path.find('/') == std::string::npos) return path;
  return (fs::path(manifest).parent_path() / path).lexically_normal().string();
}

std::string loadedPath(void* library, const std::string& asked) {
  link_map* map = nullptr;
  const bool known = dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && map && map->l_name && *map->l_name;
  return known ? map->l_name : asked;
}

}  // namespace

std::span<const KnownDriver> knownDrivers() { return kKnownDrivers; }

Result<std::vector<std::string>> manifestsOf(const std::string& driver) {
  for (const KnownDriver& known : kKnownDrivers) {
    if (driver != known.name) continue;
    std::vector<std::string> found;
    for (std::string_view folder : kLoaderFolders) {
      for (std::string& path : manifestsIn(folder, known.prefix)) found.push_back(std::move(path));
    }
    if (std::find(kLoaderFolders.begin(), kLoaderFolders.end(), known.folder) == kLoaderFolders.end()) {
      for (std::string& path : manifestsIn(known.folder, known.prefix)) found.push_back(std::move(path));
    }
    return found;
  }
  if (!driver.ends_with(".json") && driver.find('/') == std::string::npos) {
    return fail(ErrorCode::NoDevice, driver, fmt::format("unknown driver '{}'", driver),
                "take lavapipe, swiftshader, or the path of a driver manifest (*.json)");
  }
  std::error_code error;
  const fs::path absolute = fs::absolute(driver, error);
  return std::vector<std::string>{error ? driver : absolute.lexically_normal().string()};
}

std::vector<std::string> otherManifests() {
  std::vector<std::string> others;
  for (std::string_view folder : kLoaderFolders) {
    for (std::string& path : manifestsIn(folder, "")) {
      const std::string file = fs::path(path).filename().string();
      const bool known = std::any_of(kKnownDrivers.begin(), kKnownDrivers.end(),
                                     [&](const KnownDriver& driver) { return file.starts_with(driver.prefix); });
      if (!known) others.push_back(std::move(path));
    }
  }
  return others;
}

Result<std::string> checkManifest(const std::string& manifest) {
  if (manifest.find(':') != std::string::npos) {
    return refuse(manifest, "the Vulkan loader cannot take a path with a ':' in it");
  }
  const Result<std::string> text = readManifest(manifest);
  if (!text) return tl::unexpected(text.error());
  const Result<std::string> path = libraryPathOf(manifest, *text);
  if (!path) return path;
  // Never closed: opening a driver again then costs no loading, and the loader finds the very library checked here.
  void* library = dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const char* reason = dlerror();
    return refuse(manifest, fmt::format("its library cannot be loaded: {}", reason ? reason : *path));
  }
  if (!dlsym(library, "vk_icdGetInstanceProcAddr") && !dlsym(library, "vk_icdNegotiateLoaderICDInterfaceVersion")) {
    return refuse(manifest, fmt::format("{} is not a Vulkan driver", *path));
  }
  return loadedPath(library, *path);
}

}  // namespace rasterdiff::vkref
