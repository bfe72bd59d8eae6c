// Keeps buffers and images of finished scenes for the next scene that wants the same, up to a number of bytes.
#pragma once

#include <list>
#include <memory>

#include "vkref/memory.hpp"

namespace rasterdiff::vkref {

/// Resource is Buffer or Image. A lease must not outlive its pool.
template <class Resource>
class Pool {
 public:
  struct Return {
    Pool* pool = nullptr;
    VkDeviceSize bytes = 0;
    void operator()(Resource* resource) const { pool->release(std::unique_ptr<Resource>(resource), bytes); }
  };
  using Lease = std::unique_ptr<Resource, Return>;

  /// `idleBytes`: above it, what has been idle for longest is destroyed.
  Pool(const Context& context, VkDeviceSize idleBytes) : context_(context), idleLimit_(idleBytes) {}
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// `bytes` is what the resource counts as while it is idle. Error: NotOffered when memory ran out.
  [[nodiscard]] Result<Lease> acquire(const typename Resource::Key& key, VkDeviceSize bytes) {
    for (auto it = idle_.begin(); it != idle_.end(); ++it) {
      if (it->resource->key != key) continue;
      Lease lease(it->resource.release(), Return{this, bytes});
      idleBytes_ -= it->bytes;
      idle_.erase(it);
      return lease;
    }
    Result<std::unique_ptr<Resource>> created = Resource::create(context_, key);
    if (!created && created.error().code == ErrorCode::NotOffered && !idle_.empty()) {
      idle_.clear();  // idle memory must not be the reason
      idleBytes_ = 0;
      created = Resource::create(context_, key);
    }
    if (!created) return tl::unexpected(created.error());
    return Lease(created->release(), Return{this, bytes});
  }

 private:
  struct Idle {
    std::unique_ptr<Resource> resource;
    VkDeviceSize bytes = 0;
  };

  void release(std::unique_ptr<Resource> resource, VkDeviceSize bytes) {
    idle_.push_front({std::move(resource), bytes});
    idleBytes_ += bytes;
    while (idleBytes_ > idleLimit_ && !idle_.empty()) {
      idleBytes_ -= idle_.back().bytes;
      idle_.pop_back();
    }
  }

  const Context& context_;
  VkDeviceSize idleLimit_;
  VkDeviceSize idleBytes_ = 0;
  std::list<Idle> idle_;  ///< most recently used first
};

}  // namespace rasterdiff::vkref
