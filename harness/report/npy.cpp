#include "harness/report/npy.hpp"

#include <fmt/format.h>

#include <bit>
#include <type_traits>

#include "harness/report/output.hpp"

namespace rasterdiff::harness {
namespace {

static_assert(std::endian::native == std::endian::little, "the files are little-endian and written as they lie");

/// Version 1.0: magic, version, length of the header (16 bits), header padded so that the data starts at 64 n.
template <class T>
std::string npyBytes(const Plane<T>& plane, bool withComponents) {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, uint32_t>);
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}{}), }}",
                                   std::is_same_v<T, float> ? "<f4" : "<u4", plane.height, plane.width, plane.samples,
                                   withComponents ? fmt::format(", {}", plane.components) : "");
  constexpr size_t kPreamble = 10;
  header.append(63 - (kPreamble + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xff);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(plane.data.data()), plane.data.size() * sizeof(T));
  return bytes;
}

}  // namespace

std::string planeFileName(std::string_view varying) {
  std::string name;
  for (const char c : varying) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                       c == '_' || (c == '.' && !name.empty());
    name += plain ? c : '_';
  }
  if (name.empty() || name == "coverage" || name == "count" || name == "depth" || name == "primitive") name += '_';
  return name;
}

Result<std::vector<std::filesystem::path>> writeNpyFiles(const std::filesystem::path& folder, const Frame& frame) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return fail(ErrorCode::Io, folder.string(), fmt::format("cannot make this folder: {}", error.message()),
                "name a folder that may be written");
  }
  std::vector<std::filesystem::path> files;
  Result<void> written;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    if (!written) return;
    files.push_back(folder / (name + ".npy"));
    written = writeFile(files.back(), bytes);
  };
  write("coverage", npyBytes(frame.primitive, false));
  write("count", npyBytes(frame.count, false));
  if (frame.depth) write("depth", npyBytes(*frame.depth, false));
  for (const VaryingPlane& varying : frame.varyings) write(planeFileName(varying.name), npyBytes(varying.values, true));
  for (const VaryingPlane& resolved : frame.resolved) {
    write(planeFileName(resolved.name) + ".resolved", npyBytes(resolved.values, true));
  }
  if (!written) return tl::unexpected(written.error());
  return files;
}

}  // namespace rasterdiff::harness
