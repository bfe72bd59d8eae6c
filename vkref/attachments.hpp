// The images that a plan asks for, and nothing else.
#pragma once

#include <vector>

#include "vkref/plan.hpp"
#include "vkref/pool.hpp"

namespace rasterdiff::vkref {

struct Attachments {
  std::vector<Pool<Image>::Lease> color;     ///< as RenderPlan::color
  std::vector<Pool<Image>::Lease> resolved;  ///< one sample a pixel, as the varyings; empty without a resolve
  Pool<Image>::Lease depth;                  ///< null without a depth attachment
  Pool<Image>::Lease resolvedDepth;          ///< null without a depth resolve
};

/// Adds what was made or reused to `cost`. Error: NotOffered when memory ran out.
[[nodiscard]] Result<Attachments> acquireAttachments(const RenderPlan& plan, Pool<Image>& images, RenderCost& cost);

}  // namespace rasterdiff::vkref
