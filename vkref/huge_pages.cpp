// Advice only: a kernel that refuses changes nothing but speed.
#include "vkref/huge_pages.hpp"

#include <sys/mman.h>

#include <cstdint>

namespace rasterdiff::vkref {

void adviseHugePages(void* memory, size_t bytes) {
  constexpr size_t kHugePage = size_t{2} << 20;
  constexpr uintptr_t kPage = 4096;
  if (bytes < 2 * kHugePage) return;
  const uintptr_t first = (reinterpret_cast<uintptr_t>(memory) + kPage - 1) / kPage * kPage;
  const uintptr_t last = (reinterpret_cast<uintptr_t>(memory) + bytes) / kPage * kPage;
  madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace rasterdiff::vkref
