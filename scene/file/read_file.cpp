#include "scene/file/read_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace rasterdiff {

Result<std::string> readFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return fail(ErrorCode::Io, path, "this is a folder, not a file", "name a file in it");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) {
    return fail(ErrorCode::Io, path, fmt::format("cannot open the file: {}", std::strerror(errno)),
                "check the path; relative paths start at the current folder");
  }
  std::string text;
  char chunk[65536];
  for (size_t got = 0; (got = std::fread(chunk, 1, sizeof chunk, file.get())) > 0;) {
    text.append(chunk, got);
    if (text.size() > kMaxInputBytes) {
      return fail(ErrorCode::BadInput, path, fmt::format("the file is larger than {} MiB", kMaxInputBytes >> 20),
                  "split it, or put large geometry into an OBJ mesh");
    }
  }
  if (std::ferror(file.get())) return fail(ErrorCode::Io, path, "reading the file failed");
  return text;
}

}  // namespace rasterdiff
