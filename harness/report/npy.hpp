// Frames as .npy files for programs: `coverage`, `count` (uint32), `depth` and each varying (float32), little-endian,
// C order, height × width × samples (× components for varyings). What a scene resolves: NAME.resolved, one sample a pixel.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/frame.hpp"
#include "scene/result.hpp"

namespace rasterdiff::harness {

/// Writes every plane of `frame` into `folder`, which is made if it is missing. Returns the files. Error: Io.
[[nodiscard]] Result<std::vector<std::filesystem::path>> writeNpyFiles(const std::filesystem::path& folder,
                                                                       const Frame& frame);

/// A name as a file name: letters, digits, '-', '_' and '.' stay, everything else becomes '_'; never empty, never a
/// name that a plane has already ("depth" as a varying becomes "depth_").
[[nodiscard]] std::string planeFileName(std::string_view varying);

}  // namespace rasterdiff::harness
