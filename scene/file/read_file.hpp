// A whole file as text, or an error that says why not.
#pragma once

#include <cstdint>
#include <string>

#include "scene/result.hpp"

namespace rasterdiff {

/// Scene files and meshes above this are refused.
inline constexpr uint64_t kMaxInputBytes = uint64_t{256} << 20;

/// Error: Io (missing, a folder, unreadable), BadInput (larger than kMaxInputBytes). `where` is the path.
[[nodiscard]] Result<std::string> readFile(const std::string& path);

}  // namespace rasterdiff
