// Files that a run writes.
#pragma once

#include <filesystem>
#include <string_view>

#include "scene/result.hpp"

namespace rasterdiff::harness {

/// Writes `bytes` as the whole file. Error: Io with the system's reason; `where` is the path.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Whether writeFile would succeed, found out before the work and without touching what the file holds. Error: Io.
[[nodiscard]] Result<void> checkWritable(const std::filesystem::path& path);

}  // namespace rasterdiff::harness
