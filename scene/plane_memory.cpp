#include "scene/plane_memory.hpp"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace rasterdiff {
namespace {

constexpr size_t kLargePage = size_t{1} << 21;  // bytes

// Advice only: it may be refused, and the bytes are the same.
void adviseLargePages([[maybe_unused]] void* memory, [[maybe_unused]] size_t bytes) {
#if defined(__linux__)
  if (bytes < 2 * kLargePage) return;
  const auto page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  auto* const begin = static_cast<std::byte*>(memory);
  const size_t misaligned = reinterpret_cast<size_t>(begin) % page;
  std::byte* const aligned = misaligned == 0 ? begin : begin + (page - misaligned);
  (void)madvise(aligned, bytes - static_cast<size_t>(aligned - begin), MADV_HUGEPAGE);
#endif
}

}  // namespace

// A large block of calloc is fresh memory of the system, which is zero already and is not touched.
void* zeroedPlaneMemory(size_t bytes) {
  void* const memory = std::calloc(bytes == 0 ? 1 : bytes, 1);
  if (memory == nullptr) throw std::bad_alloc();
  adviseLargePages(memory, bytes);
  return memory;
}

void freePlaneMemory(void* memory) noexcept { std::free(memory); }

}  // namespace rasterdiff
