#include "harness/cli/memory.hpp"

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace rasterdiff::harness::cli {

void keepFreedMemory() {
#if defined(__GLIBC__)
  constexpr int kKept = 1 << 30;  // bytes
  mallopt(M_MMAP_MAX, 0);         // what is mapped for itself goes back to the system at once
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

}  // namespace rasterdiff::harness::cli
