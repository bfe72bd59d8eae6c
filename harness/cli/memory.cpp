#include "harness/cli/memory.hpp"

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace rasterdiff::harness::cli {

void keepFreedMemory() {
#if defined(__GLIBC__)
  constexpr int kKept = 32 << 20;  // bytes; glibc takes no larger threshold
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_TRIM_THRESHOLD, 8 * kKept);
#endif
}

}  // namespace rasterdiff::harness::cli
