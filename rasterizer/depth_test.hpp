// The depth test, on values and on intervals. [vk:fragops-depth]
#pragma once

#include "scene/frame.hpp"
#include "scene/vulkan_enums.hpp"

namespace rasterdiff::rasterizer {

[[nodiscard]] constexpr bool depthTestPasses(CompareOp op, float fragment, float stored) {
  switch (op) {
    case CompareOp::NEVER: return false;
    case CompareOp::LESS: return fragment < stored;
    case CompareOp::EQUAL: return fragment == stored;
    case CompareOp::LESS_OR_EQUAL: return fragment <= stored;
    case CompareOp::GREATER: return fragment > stored;
    case CompareOp::NOT_EQUAL: return fragment != stored;
    case CompareOp::GREATER_OR_EQUAL: return fragment >= stored;
    case CompareOp::ALWAYS: return true;
  }
  return true;
}

/// Can the test pass for some values of the two intervals?
[[nodiscard]] constexpr bool depthTestMayPass(CompareOp op, Bounds fragment, Bounds stored) {
  switch (op) {
    case CompareOp::NEVER: return false;
    case CompareOp::LESS: return fragment.lo < stored.hi;
    case CompareOp::EQUAL: return fragment.lo <= stored.hi && stored.lo <= fragment.hi;
    case CompareOp::LESS_OR_EQUAL: return fragment.lo <= stored.hi;
    case CompareOp::GREATER: return fragment.hi > stored.lo;
    case CompareOp::NOT_EQUAL: return !(fragment.lo == fragment.hi && stored.lo == stored.hi && fragment.lo == stored.lo);
    case CompareOp::GREATER_OR_EQUAL: return fragment.hi >= stored.lo;
    case CompareOp::ALWAYS: return true;
  }
  return true;
}

[[nodiscard]] constexpr CompareOp negated(CompareOp op) {
  switch (op) {
    case CompareOp::NEVER: return CompareOp::ALWAYS;
    case CompareOp::LESS: return CompareOp::GREATER_OR_EQUAL;
    case CompareOp::EQUAL: return CompareOp::NOT_EQUAL;
    case CompareOp::LESS_OR_EQUAL: return CompareOp::GREATER;
    case CompareOp::GREATER: return CompareOp::LESS_OR_EQUAL;
    case CompareOp::NOT_EQUAL: return CompareOp::EQUAL;
    case CompareOp::GREATER_OR_EQUAL: return CompareOp::LESS;
    case CompareOp::ALWAYS: return CompareOp::NEVER;
  }
  return op;
}

/// Can the test fail for some values of the two intervals?
[[nodiscard]] constexpr bool depthTestMayFail(CompareOp op, Bounds fragment, Bounds stored) {
  return depthTestMayPass(negated(op), fragment, stored);
}

}  // namespace rasterdiff::rasterizer
