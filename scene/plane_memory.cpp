#include "scene/plane_memory.hpp"

#include <cstdlib>

namespace rasterdiff {

// A large block of calloc is fresh memory of the system, which is zero already and is not touched. Large pages are not asked
// for: they would be zeroed whole, and where they have to be made first that costs more than they save.
void* planeMemory(size_t bytes, bool zeroed) {
  void* const memory = zeroed ? std::calloc(bytes == 0 ? 1 : bytes, 1) : std::malloc(bytes == 0 ? 1 : bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void freePlaneMemory(void* memory) noexcept { std::free(memory); }

}  // namespace rasterdiff
