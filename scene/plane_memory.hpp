// Memory of a frame's planes: zeroed by the system when it is first touched. What a
// scene does not draw on costs nothing.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace rasterdiff {

/// Bytes, zeroed or as they are; never null. Throws std::bad_alloc.
[[nodiscard]] void* planeMemory(size_t bytes, bool zeroed);
void freePlaneMemory(void* memory) noexcept;

/// For vectors whose elements are zero bits when value-initialised, and that are sized once: `std::vector(n)` leaves the
/// memory untouched. With an allocator that is unwritten(), elements are whatever was there.
template <class T>
struct ZeroedAllocator {
  using value_type = T;
  static_assert(std::is_trivially_copyable_v<T>);

  ZeroedAllocator() = default;
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>& other) : zeroed_(other.zeroed()) {}

  [[nodiscard]] static ZeroedAllocator unwritten() {
    ZeroedAllocator allocator;
    allocator.zeroed_ = false;
    return allocator;
  }
  [[nodiscard]] bool zeroed() const { return zeroed_; }
  /// A copy may grow.
  [[nodiscard]] ZeroedAllocator select_on_container_copy_construction() const { return {}; }

  [[nodiscard]] T* allocate(size_t n) {
    if (n > static_cast<size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(planeMemory(n * sizeof(T), zeroed_));
  }
  void deallocate(T* memory, size_t) noexcept { freePlaneMemory(memory); }

  void construct(T*) {}
  template <class... Arguments>
  void construct(T* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }

 private:
  bool zeroed_ = true;
};

}  // namespace rasterdiff
