// Memory of a frame's planes: zeroed by the system when it is first touched. What a
// scene does not draw on costs nothing.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace rasterdiff {

/// Zeroed bytes; never null. Throws std::bad_alloc.
[[nodiscard]] void* zeroedPlaneMemory(size_t bytes);
void freePlaneMemory(void* memory) noexcept;

/// For vectors whose elements are zero bits when value-initialised, and that are sized once: `std::vector(n)` leaves the
/// memory untouched.
template <class T>
struct ZeroedAllocator {
  using value_type = T;
  static_assert(std::is_trivially_copyable_v<T>);

  ZeroedAllocator() = default;
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}

  [[nodiscard]] T* allocate(size_t n) {
    if (n > static_cast<size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(zeroedPlaneMemory(n * sizeof(T)));
  }
  void deallocate(T* memory, size_t) noexcept { freePlaneMemory(memory); }

  void construct(T*) {}
  template <class... Arguments>
  void construct(T* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }
};

}  // namespace rasterdiff
