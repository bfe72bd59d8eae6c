#include "harness/report/output.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace rasterdiff::harness {
namespace {

Result<void> write(const std::filesystem::path& path, std::string_view bytes, std::ios::openmode mode) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | mode);
  if (file) file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file) file.close();
  if (file) return {};
  return fail(ErrorCode::Io, path.string(),
              std::string("cannot be written: ") + (errno != 0 ? std::strerror(errno) : "the stream failed"),
              "name a file in a folder that exists and may be written");
}

}  // namespace

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
  return write(path, bytes, std::ios::trunc);
}

Result<void> checkWritable(const std::filesystem::path& path) { return write(path, {}, std::ios::app); }

}  // namespace rasterdiff::harness
