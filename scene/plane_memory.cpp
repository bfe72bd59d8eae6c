#include "scene/plane_memory.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace rasterdiff {

// A large block of calloc is fresh memory of the system, which is zero already and is not touched. Large pages are not asked
// for: they would be zeroed whole, and where they have to be made first that costs more than they save. What calloc gives begins
// anywhere in a cache line; before the line that is given away there is the address of the block.
void* planeMemory(size_t bytes, bool zeroed) {
  constexpr size_t kLine = 64;
  const size_t size = bytes + kLine + sizeof(void*);
  void* const block = size < bytes ? nullptr : zeroed ? std::calloc(size, 1) : std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  const auto first = reinterpret_cast<uintptr_t>(block) + sizeof(void*);
  void* const memory = reinterpret_cast<void*>((first + kLine - 1) / kLine * kLine);
  std::memcpy(static_cast<char*>(memory) - sizeof(void*), &block, sizeof(void*));
  return memory;
}

void freePlaneMemory(void* memory) noexcept {
  if (memory == nullptr) return;
  void* block = nullptr;
  std::memcpy(&block, static_cast<const char*>(memory) - sizeof(void*), sizeof(void*));
  std::free(block);
}

}  // namespace rasterdiff
